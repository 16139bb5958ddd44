// TIFF files reduced to the first directory's fields that make pixels: what else stands in them costs
// nothing, whatever its number and length. (TIFF 6.0, sections 2 and 8; BigTIFF)
#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <set>
#include <string>

#include "core/pictures/byte_order.h"
#include "core/pictures/examined.h"
#include "core/pictures/picture_problem.h"

namespace nacre {
namespace {

constexpr std::uint64_t width = 256, height = 257;

// Sizes, strips, tiles, colours and what the codecs need, and where on its page a picture lies.
bool makes_pixels(std::uint64_t field) {
    constexpr std::uint64_t fields[] = {
        width, height, 258, 259, 262, 263, 264, 265, 266,   273,   274,   277,   278,   279,  280,
        281,   282,    283, 284, 286, 287, 292, 293, 296,   305,   317,   318,   319,   320,  322,
        323,   324,    325, 332, 334, 338, 339, 340, 341,   347,   512,   513,   514,   515,  517,
        518,   519,    520, 521, 529, 530, 531, 532, 32996, 32997, 32998, 33300, 33301, 50674};
    return std::find(std::begin(fields), std::end(fields), field) != std::end(fields);
}

// How the file writes its numbers.
struct Layout {
    bool is_little, is_big_tiff;

    std::uint64_t number(std::string_view data, std::size_t at, std::size_t length) const {
        return is_little ? little_endian(data, at, length) : big_endian(data, at, length);
    }
    std::string bytes(std::uint64_t value, std::size_t length) const {
        std::string result;
        for (std::size_t i = 0; i < length; ++i)
            result += static_cast<char>(value >> (8 * (is_little ? i : length - 1 - i)));
        return result;
    }
    std::size_t offset_size() const { return is_big_tiff ? 8 : 4; }
    std::size_t count_size() const { return is_big_tiff ? 8 : 2; }  // of the number of entries
    std::size_t entry_size() const { return 4 + 2 * offset_size(); }
};

// The bytes of a value of each of TIFF's types; 0: there is no such type.
std::uint64_t value_size(std::uint64_t type) {
    constexpr std::array<std::uint64_t, 19> sizes{0, 1, 1, 2, 4, 8, 1, 1, 2, 4, 8, 4, 8, 4, 0, 0, 8, 8, 8};
    return type < sizes.size() ? sizes[type] : 0;
}

struct Entry {
    std::uint64_t field, type, count;
    std::uint64_t value;  // the first one, where it is in the entry
};

Entry read_entry(const Layout& layout, std::string_view data) {
    const std::uint64_t type = layout.number(data, 2, 2), size = value_size(type);
    const std::size_t at = 4 + layout.offset_size();
    return {layout.number(data, 0, 2), type, layout.number(data, 4, layout.offset_size()),
            size > 0 ? layout.number(data, at, std::min<std::size_t>(size, layout.offset_size())) : 0};
}

// Its values must be within the file.
void check_entry(const FileBytes& file, const Layout& layout, const Entry& entry, std::string_view data) {
    const std::uint64_t size = value_size(entry.type);
    if (size == 0)
        throw PictureProblem(
            fmt::format("the TIFF file's field {} is of an unknown type, {}", entry.field, entry.type));
    if (entry.count <= layout.offset_size() / size) return;
    const std::uint64_t place = layout.number(data, 4 + layout.offset_size(), layout.offset_size());
    if (place > file.size() || entry.count > (file.size() - place) / size)
        throw PictureProblem(fmt::format("the TIFF file is cut short: its field {} has {} values at byte {}",
                                         entry.field, entry.count, place));
}

}  // namespace

void examine_tiff(const FileBytes& file, Examined& found) {
    const std::string start = file.read(0, 16);
    Layout layout{start[0] == 'I', false};
    layout.is_big_tiff = layout.number(start, 2, 2) == 43;
    const std::uint64_t directory = layout.number(start, layout.offset_size(), layout.offset_size());
    const auto cut_short = [] { return PictureProblem("the TIFF file is cut short"); };
    if (directory < 8 || directory > file.size() || file.size() - directory < layout.count_size())
        throw cut_short();
    const std::uint64_t entries = layout.number(file.read(directory, 8), 0, layout.count_size());
    const std::uint64_t first = directory + layout.count_size();
    if (entries > (file.size() - first) / layout.entry_size()) throw cut_short();
    std::set<std::uint64_t> seen;
    std::string kept;
    for (std::uint64_t i = 0; i < entries; ++i) {
        const std::string data = file.read(first + i * layout.entry_size(), layout.entry_size());
        const Entry entry = read_entry(layout, data);
        if (!makes_pixels(entry.field) || !seen.insert(entry.field).second) continue;
        check_entry(file, layout, entry, data);
        kept += data;
        if (entry.field == width) found.size.x = static_cast<double>(entry.value);
        if (entry.field == height) found.size.y = static_cast<double>(entry.value);
    }
    if (found.size.x < 1 || found.size.y < 1) throw PictureProblem("the TIFF file's picture has no size");
    // The next directory, where there is none, is at 0.
    const std::string shorter =
        layout.bytes(seen.size(), layout.count_size()) + kept + std::string(layout.offset_size(), '\0');
    const std::uint64_t rest = std::min(directory + shorter.size(), file.size());
    found.pieces = {{{}, 0, directory}, {shorter, 0, 0}, {{}, rest, file.size() - rest}};
}

}  // namespace nacre
