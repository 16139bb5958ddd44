#include "core/pictures/examined.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <string_view>
#include <utility>

#include "core/base/file_extension.h"
#include "core/pictures/byte_order.h"
#include "core/pictures/picture_problem.h"

namespace nacre {
namespace {

using namespace std::string_view_literals;

struct Signature {
    std::size_t at;
    std::string_view bytes;
    const char* format;
};

constexpr Signature signatures[] = {{0, "\x89PNG\r\n"sv, "png"},
                                    {0, "\xFF\xD8\xFF"sv, "jpeg"},
                                    {0, "\x76\x2F\x31\x01"sv, "openexr"},
                                    {0, "II*\0"sv, "tiff"},
                                    {0, "MM\0*"sv, "tiff"},
                                    {0, "II+\0"sv, "tiff"},
                                    {0, "MM\0+"sv, "tiff"},
                                    {0, "#?"sv, "hdr"},
                                    {8, "WEBP"sv, "webp"},
                                    {0, "8BPS"sv, "psd"},
                                    {0, "DDS "sv, "dds"},
                                    {4, "jP  \r\n\x87\n"sv, "jpeg2000"},
                                    {0, "\xFF\x4F\xFF\x51"sv, "jpeg2000"},
                                    {4, "ftypheic"sv, "heif"},
                                    {4, "ftypheix"sv, "heif"},
                                    {4, "ftypheim"sv, "heif"},
                                    {4, "ftypheis"sv, "heif"},
                                    {4, "ftyphevc"sv, "heif"},
                                    {4, "ftypmif1"sv, "heif"},
                                    {4, "ftypavif"sv, "heif"}};

bool is_pnm(std::string_view start) {
    constexpr std::string_view kinds = "123456Ff";
    return start.size() > 2 && start[0] == 'P' && kinds.find(start[1]) != kinds.npos &&
           (std::isspace(static_cast<unsigned char>(start[2])) != 0 || start[2] == '#');
}

// BM alone is how a text may begin: the reserved bytes and the length of the header that follows too.
bool is_bmp(std::string_view start) {
    constexpr std::array<std::uint64_t, 7> lengths{12, 40, 52, 56, 64, 108, 124};
    return start.starts_with("BM") &&
           std::find(lengths.begin(), lengths.end(), little_endian(start, 14, 4)) != lengths.end();
}

// TGA has no signature, but for the footer of its second version; else its name must say so and its header
// make sense. (Truevision TGA, version 2.0)
bool is_tga(const FileBytes& file, std::string_view start) {
    constexpr std::uint64_t footer_name = 18;
    const bool has_footer =
        file.size() >= 44 &&
        file.read(file.size() - footer_name, footer_name).starts_with("TRUEVISION-XFILE.");
    const std::string extension = extension_of(file.path());
    if (!has_footer && extension != ".tga" && extension != ".tpic") return false;
    const auto has_palette = little_endian(start, 1, 1), kind = little_endian(start, 2, 1);
    const auto depth = little_endian(start, 16, 1), descriptor = little_endian(start, 17, 1);
    constexpr std::array<std::uint64_t, 6> kinds{1, 2, 3, 9, 10, 11};
    constexpr std::array<std::uint64_t, 5> depths{8, 15, 16, 24, 32};
    return has_palette <= 1 && std::find(kinds.begin(), kinds.end(), kind) != kinds.end() &&
           std::find(depths.begin(), depths.end(), depth) != depths.end() && descriptor < 64;
}

// A text in which the first element is <svg>, perhaps with a prefix.
bool is_svg(const FileBytes& file) {
    constexpr std::uint64_t looked_at = 1 << 14;
    const std::string text = file.read(0, looked_at);
    std::size_t at = text.starts_with("\xEF\xBB\xBF") ? 3 : 0;
    while ((at = text.find_first_not_of(" \t\r\n", at)) != text.npos && text[at] == '<') {
        const bool comment = text.compare(at, 4, "<!--") == 0;
        if (!comment && text.compare(at, 2, "<?") != 0 && text.compare(at, 2, "<!") != 0) break;
        // A document type may hold declarations of its own in brackets.
        const bool declares =
            text.compare(at, 9, "<!DOCTYPE") == 0 && text.find('[', at) < text.find('>', at);
        const std::string_view end = comment ? "-->" : declares ? "]>" : ">";
        at = text.find(end, at);
        if (at == text.npos) return false;
        at += end.size();
    }
    if (at == text.npos || text[at] != '<') return false;
    const std::string name = text.substr(at + 1, text.find_first_of(" \t\r\n/>", at) - at - 1);
    return name == "svg" || name.ends_with(":svg");
}

bool is_text(std::string_view start) {
    return std::none_of(start.begin(), start.end(), [](char c) {
        const auto byte = static_cast<unsigned char>(c);
        return (byte < 0x20 && std::isspace(byte) == 0) || byte == 0x7F;
    });
}

// What is no picture, in words.
std::string other_kind(const FileBytes& file) {
    constexpr std::uint64_t looked_at = 4096;
    const std::string start = file.read(0, looked_at);
    if (start.empty()) return "an empty file, ";
    if (start.starts_with("%PDF")) return "a PDF document, whose pages can be exported as pictures, ";
    if (start.starts_with("PK\3\4")) return "an archive, or a document that is one, ";
    return is_text(start) ? "a text, " : "";
}

std::string format_of(const FileBytes& file) {
    const std::string start = file.read(0, 32);
    for (const auto& [at, bytes, format] : signatures)
        if (start.size() >= at + bytes.size() && start.compare(at, bytes.size(), bytes) == 0) return format;
    if (is_pnm(start)) return "pnm";
    if (is_bmp(start)) return "bmp";
    if (is_tga(file, start)) return "targa";
    if (is_svg(file)) return "svg";
    if (start.starts_with("GIF8")) throw PictureProblem("a GIF, which is not read; save it as PNG");
    if (start.size() > 8 && start.compare(4, 4, "ftyp") == 0) throw PictureProblem("a movie, not a picture");
    throw PictureProblem(
        other_kind(file) +
        "no PNG, JPEG, EXR, TIFF, HDR, PNM, WebP, TGA, BMP, PSD, DDS, JPEG 2000, HEIF or SVG picture");
}

}  // namespace

Examined examine(const FileBytes& file) {
    constexpr std::pair<std::string_view, void (*)(const FileBytes&, Examined&)> examiners[] = {
        {"png", examine_png},     {"jpeg", examine_jpeg}, {"hdr", examine_hdr},
        {"openexr", examine_exr}, {"tiff", examine_tiff}, {"psd", examine_psd},
        {"targa", examine_targa}, {"bmp", examine_bmp},   {"dds", examine_dds},
        {"webp", examine_webp},   {"heif", examine_heif}, {"jpeg2000", examine_jpeg2000}};
    Examined found;
    found.format = format_of(file);
    for (const auto& [format, examiner] : examiners)
        if (format == found.format) examiner(file, found);
    return found;
}

}  // namespace nacre
