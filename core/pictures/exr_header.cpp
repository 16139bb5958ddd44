#include "core/pictures/exr_header.h"

#include <algorithm>
#include <bit>
#include <set>
#include <string_view>

#include "core/pictures/byte_order.h"
#include "core/pictures/picture_problem.h"

namespace nacre {
namespace {

constexpr std::uint64_t name_max = 255;       // bytes
constexpr std::uint64_t kept_max = 1u << 20;  // bytes of an attribute that is needed
constexpr std::uint64_t header_max = 1u << 26;

std::int64_t signed_number(std::string_view bytes, std::size_t at) {
    return static_cast<std::int32_t>(static_cast<std::uint32_t>(little_endian(bytes, at, 4)));
}

double real_number(std::string_view bytes, std::size_t at) {
    return static_cast<double>(std::bit_cast<float>(static_cast<std::uint32_t>(little_endian(bytes, at, 4))));
}

bool makes_pixels(std::string_view name) {
    constexpr std::string_view names[] = {
        "channels",         "compression", "dataWindow", "displayWindow",     "lineOrder",
        "pixelAspectRatio", "tiles",       "type",       "screenWindowWidth", "screenWindowCenter",
        "version",          "chunkCount",  "name",       "Orientation"};
    return std::find(std::begin(names), std::end(names), name) != std::end(names);
}

// Reads the file from a place on.
class Cursor {
  public:
    Cursor(const FileBytes& file, std::uint64_t at) : file_(file), at_(at) {}
    std::uint64_t at() const { return at_; }
    std::string bytes(std::uint64_t length) {
        const std::string found = file_.read(at_, length);
        if (found.size() < length) throw PictureProblem("the EXR file's header is cut short");
        at_ += length;
        return found;
    }
    // Up to a zero byte.
    std::string text() {
        std::string found = file_.read(at_, name_max + 1);
        const std::size_t end = found.find('\0');
        if (end == found.npos) throw PictureProblem("the EXR file's header is damaged");
        found.resize(end);
        at_ += end + 1;
        return found;
    }
    void skip(std::uint64_t length) {
        if (length > file_.size() - at_) throw PictureProblem("the EXR file's header is cut short");
        at_ += length;
    }

  private:
    const FileBytes& file_;
    std::uint64_t at_;
};

// Each: name, type, linearity, then how many pixels apart its samples stand.
void read_channels(std::string_view data, ExrHeader& header) {
    constexpr std::size_t rest = 16;
    while (!data.empty() && data[0] != '\0') {
        const std::size_t end = data.find('\0');
        if (end == data.npos || data.size() - end - 1 < rest)
            throw PictureProblem("the EXR file's list of channels is damaged");
        if (little_endian(data, end + 9, 4) != 1 || little_endian(data, end + 13, 4) != 1)
            header.subsampled.emplace_back(data.substr(0, end));
        constexpr std::uint64_t half = 1, real = 2;
        const std::uint64_t type = little_endian(data, end + 1, 4);
        header.pixel_bytes += type == half ? 2 : 4;
        header.pxr24_pixel_bytes += type == half ? 2 : type == real ? 3 : 4;
        data.remove_prefix(end + 1 + rest);
    }
}

void read_attribute(const std::string& name, std::string_view data, ExrHeader& header) {
    const auto box = [&] {
        return std::array<std::int64_t, 4>{signed_number(data, 0), signed_number(data, 4),
                                           signed_number(data, 8), signed_number(data, 12)};
    };
    if (name == "channels") read_channels(data, header);
    if (name == "compression") header.compression = static_cast<unsigned>(little_endian(data, 0, 1));
    if (name == "dataWindow") header.data_window = box();
    if (name == "displayWindow") header.display_window = box();
    if (name == "name") header.name = data;
    if (name == "type") header.type = data;
    if (name == "envmap") header.is_cube = data.starts_with('\1');
    if (name == "tiles") header.tile = {signed_number(data, 0), signed_number(data, 4)};
    if (name == "chromaticities" && data.size() == 32) {
        std::array<double, 8> xy{};
        for (std::size_t i = 0; i < xy.size(); ++i) xy[i] = real_number(data, 4 * i);
        header.chromaticities = xy;
    }
}

std::string attribute(const std::string& name, const std::string& type, std::uint64_t length) {
    std::string bytes = name + '\0' + type + '\0';
    for (unsigned shift = 0; shift < 32; shift += 8) bytes += static_cast<char>(length >> shift);
    return bytes;
}

// One part's. What the decoder needs comes first in what it is shown, then one attribute without a meaning
// that reaches over the rest, so that every place in the file stays.
ExrHeader read_header(Cursor& cursor, std::vector<Piece>& pieces) {
    ExrHeader header;
    std::set<std::string> seen;
    const std::uint64_t start = cursor.at();
    std::string kept;
    for (std::string name = cursor.text(); !name.empty(); name = cursor.text()) {
        const std::string type = cursor.text();
        const std::uint64_t length = little_endian(cursor.bytes(4), 0, 4);
        const bool is_needed = makes_pixels(name);
        const bool is_read = is_needed || name == "chromaticities" || name == "envmap";
        if (cursor.at() - start > header_max || (is_read && length > kept_max))
            throw PictureProblem("the EXR file's header is too long");
        if (!is_read) {
            cursor.skip(length);
            continue;
        }
        if (!seen.insert(name).second)
            throw PictureProblem("the EXR file has the attribute " + name + " twice");
        const std::string data = cursor.bytes(length);
        read_attribute(name, data, header);
        if (is_needed) kept += attribute(name, type, length) + data;
    }
    const std::uint64_t hidden = cursor.at() - 1 - start - kept.size();
    if (hidden > 0) {
        const std::string filler = attribute("-", "-", 0);
        if (hidden < filler.size()) throw PictureProblem("the EXR file's header is damaged");
        kept += attribute("-", "-", hidden - filler.size());
    }
    if (!kept.empty()) pieces.push_back({kept, 0, 0});
    pieces.push_back({{}, start + kept.size(), cursor.at() - start - kept.size()});
    if (header.width() < 1 || header.height() < 1 || header.display_window[2] < header.display_window[0] ||
        header.display_window[3] < header.display_window[1])
        throw PictureProblem("the EXR file's header describes no picture");
    return header;
}

}  // namespace

ExrHeaders read_exr_headers(const FileBytes& file) {
    constexpr unsigned deep = 0x800, several = 0x1000;
    constexpr std::size_t parts_max = 1024;
    ExrHeaders found;
    const auto flags = static_cast<unsigned>(little_endian(file.read(4, 4), 0, 4));
    found.pieces.push_back({{}, 0, 8});
    Cursor cursor(file, 8);
    do {
        if (found.parts.size() == parts_max) throw PictureProblem("the EXR file has too many parts");
        found.parts.push_back(read_header(cursor, found.pieces));
    } while ((flags & several) != 0 && !file.read(cursor.at(), 1).starts_with('\0'));
    found.is_deep =
        found.parts[0].type.starts_with("deep") || ((flags & deep) != 0 && (flags & several) == 0);
    found.is_multipart = (flags & several) != 0;
    found.end = cursor.at() + ((flags & several) != 0 ? 1 : 0);
    if (found.end > file.size()) throw PictureProblem("the EXR file is cut short");
    found.pieces.push_back({{}, cursor.at(), file.size() - cursor.at()});
    return found;
}

}  // namespace nacre
