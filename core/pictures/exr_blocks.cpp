#include "core/pictures/exr_blocks.h"

#include <fmt/core.h>
#include <zlib.h>

#include <algorithm>
#include <array>
#include <glm/ext/vector_int2_sized.hpp>

#include "core/pictures/byte_order.h"
#include "core/pictures/picture_problem.h"

namespace nacre {
namespace {

enum Compression : unsigned { none, rle, zips, zip, piz, pxr24, b44, b44a, dwaa, dwab };

// Pixels that are stored together: a tile, or a number of lines that depends on the compression.
glm::i64vec2 block_size(const ExrHeader& header) {
    constexpr std::array<std::int64_t, 10> lines{1, 1, 1, 16, 32, 16, 32, 32, 32, 256};
    if (header.compression >= lines.size())
        throw PictureProblem(
            fmt::format("the EXR file's compression is of an unknown kind, {}", header.compression));
    if (!header.tile) return {header.width(), lines[header.compression]};
    const auto [width, height] = *header.tile;
    if (width < 1 || height < 1) throw PictureProblem("the EXR file's tiles have no size");
    return {width, height};
}

void check_claim(const FileBytes& file, const ExrHeader& header, glm::i64vec2 block) {
    constexpr double doubtful = 1 << 26, bytes_a_byte = 4096;
    if (!header.tile) block.y = std::min(block.y, header.height());
    const double bytes =
        static_cast<double>(block.x) * static_cast<double>(block.y) * static_cast<double>(header.pixel_bytes);
    if (bytes > std::max(doubtful, bytes_a_byte * static_cast<double>(file.size())))
        throw PictureProblem(
            fmt::format("blocks of {} x {} pixels in a file of {} bytes", block.x, block.y, file.size()));
}

// The inflated size of the data; of damaged data, the size that can be inflated.
std::int64_t inflated_size(const std::string& data) {
    std::array<unsigned char, 1 << 16> scratch;
    z_stream stream{};
    if (inflateInit(&stream) != Z_OK) throw std::bad_alloc();
    stream.next_in = reinterpret_cast<unsigned char*>(const_cast<char*>(data.data()));
    stream.avail_in = static_cast<uInt>(data.size());
    std::int64_t size = 0;
    int state = Z_OK;
    while (state == Z_OK) {
        stream.next_out = scratch.data();
        stream.avail_out = static_cast<uInt>(scratch.size());
        state = inflate(&stream, Z_NO_FLUSH);
        size += static_cast<std::int64_t>(scratch.size() - stream.avail_out);
    }
    inflateEnd(&stream);
    return size;
}

// Of runs: a count below 0 precedes that many literal bytes, any other one byte,
// repeated count + 1 times.
std::int64_t run_lengths_size(const std::string& data) {
    std::int64_t size = 0;
    for (std::size_t i = 0; i < data.size();) {
        const int count = static_cast<signed char>(data[i]);
        size += count < 0 ? -count : count + 1;
        i += count < 0 ? static_cast<std::size_t>(1 - count) : 2;
    }
    return size;
}

// The other compressions' decoders look themselves.
bool is_whole(const ExrHeader& header, const std::string& data, std::int64_t pixels) {
    const std::int64_t bytes = pixels * header.pixel_bytes;
    if (static_cast<std::int64_t>(data.size()) == bytes) return true;  // stored as it is
    if (header.compression == none) return false;
    if (header.compression == rle) return run_lengths_size(data) == bytes;
    if (header.compression == zips || header.compression == zip) return inflated_size(data) == bytes;
    if (header.compression == pxr24) return inflated_size(data) == pixels * header.pxr24_pixel_bytes;
    return true;
}

}  // namespace

void check_exr_blocks(const FileBytes& file, const ExrHeaders& headers) {
    constexpr std::uint64_t entry = 8;
    const ExrHeader& header = headers.parts[0];
    const glm::i64vec2 block = block_size(header);
    check_claim(file, header, block);
    const std::int64_t across = (header.width() + block.x - 1) / block.x;
    const std::int64_t count = across * ((header.height() + block.y - 1) / block.y);
    const auto incomplete = [&](std::int64_t i) {
        return PictureProblem(
            fmt::format("block {} of its {} blocks of pixels is missing or damaged: the EXR file is cut "
                        "short, changed or unfinished",
                        i + 1, count));
    };
    if ((file.size() - headers.end) / entry < static_cast<std::uint64_t>(count)) throw incomplete(count - 1);
    const std::uint64_t head_size = (headers.is_multipart ? 4u : 0u) + (header.tile ? 20u : 8u);
    for (std::int64_t i = 0; i < count; ++i) {
        const std::uint64_t place =
            little_endian(file.read(headers.end + static_cast<std::uint64_t>(i) * entry, entry), 0, entry);
        if (place < headers.end || place > file.size() || file.size() - place < head_size)
            throw incomplete(i);
        const std::uint64_t length = little_endian(file.read(place + head_size - 4, 4), 0, 4);
        if (length > file.size() - place - head_size) throw incomplete(i);
        const std::int64_t width = std::min(block.x, header.width() - i % across * block.x);
        const std::int64_t height = std::min(block.y, header.height() - i / across * block.y);
        if (!is_whole(header, file.read(place + head_size, length), width * height)) throw incomplete(i);
    }
}

}  // namespace nacre
