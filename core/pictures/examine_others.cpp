// Sizes of pictures whose decoders take memory for all pixels before they can be asked.
#include <algorithm>

#include "core/pictures/byte_order.h"
#include "core/pictures/examined.h"
#include "core/pictures/picture_problem.h"

namespace nacre {

// RIFF's chunks: a header chunk, if any, comes before the pictures.
void examine_webp(const FileBytes& file, Examined& found) {
    found.orientation = 1;
    const std::uint64_t end = 8 + little_endian(file.read(4, 4), 0, 4);
    if (end > file.size()) throw PictureProblem("the WebP file is cut short");
    for (std::uint64_t position = 12; position + 8 <= end;) {
        const std::string head = file.read(position, 24);
        const std::string_view name = std::string_view(head).substr(0, 4);
        const std::uint64_t length = little_endian(head, 4, 4);
        const bool is_first = found.size.x < 1;
        if (name == "VP8X")
            found.size = glm::dvec2(little_endian(head, 12, 3), little_endian(head, 15, 3)) + 1.0;
        if (name == "VP8 " && is_first)
            found.size = glm::dvec2(little_endian(head, 14, 2) & 0x3FFF, little_endian(head, 16, 2) & 0x3FFF);
        if (name == "VP8L" && is_first) {
            const std::uint64_t bits = little_endian(head, 9, 4);
            found.size = glm::dvec2(bits & 0x3FFF, (bits >> 14) & 0x3FFF) + 1.0;
        }
        if (name == "EXIF") {
            const std::string exif = file.read(position + 8, std::min<std::uint64_t>(length, 1u << 16));
            found.orientation =
                std::max(1, exif_orientation(exif.starts_with("Exif") ? exif.substr(6) : exif));
        }
        if (name == "ANIM") found.notes.emplace_back("an animation, of which the first picture is used");
        position += 8 + length + (length & 1);
    }
}

// libheif turns the picture itself. The largest of the sizes, since a picture may be made of others.
void examine_heif(const FileBytes& file, Examined& found) {
    constexpr std::uint64_t boxes_max = 1u << 22;  // before the pixels
    found.orientation = 1;
    const std::string start = file.read(0, boxes_max);
    for (std::size_t at = start.find("ispe"); at != start.npos; at = start.find("ispe", at + 4))
        found.size =
            glm::max(found.size, glm::dvec2(big_endian(start, at + 8, 4), big_endian(start, at + 12, 4)));
    if (found.size.x < 1) throw PictureProblem("the HEIF file does not say how large its picture is");
}

// The marker SIZ follows the start of the code stream. (ITU-T T.800, annex A)
void examine_jpeg2000(const FileBytes& file, Examined& found) {
    constexpr std::uint64_t boxes_max = 1u << 20;
    found.orientation = 1;
    const std::string start = file.read(0, boxes_max);
    const std::size_t at = start.find("\xFF\x4F\xFF\x51");
    if (at == start.npos) throw PictureProblem("the JPEG 2000 file has no code stream");
    found.size = glm::dvec2(big_endian(start, at + 8, 4), big_endian(start, at + 12, 4)) -
                 glm::dvec2(big_endian(start, at + 16, 4), big_endian(start, at + 20, 4));
}

}  // namespace nacre
