// The merged picture of Photoshop files: channel after channel, as it is or in PackBits.
#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <cstring>
#include <utility>

#include "core/pictures/byte_order.h"
#include "core/pictures/decoders.h"
#include "core/pictures/picture_problem.h"
#include "core/pictures/psd_file.h"

namespace nacre {
namespace {

enum Compression : std::uint64_t { none = 0, pack_bits = 1 };

struct StoredRow {
    std::uint64_t at, length;
};

// Whether `packed` fills the row. (TIFF 6.0, section 9)
bool unpack(std::string_view packed, std::string& row) {
    std::size_t from = 0, to = 0;
    while (to < row.size() && from < packed.size()) {
        const int head = static_cast<signed char>(packed[from++]);
        if (head == -128) continue;
        const auto count = static_cast<std::size_t>(head < 0 ? 1 - head : 1 + head);
        const std::size_t stored = head < 0 ? 1 : count;
        if (count > row.size() - to || stored > packed.size() - from) return false;
        if (head < 0)
            std::memset(&row[to], packed[from], count);
        else
            std::memcpy(&row[to], &packed[from], count);
        from += stored;
        to += count;
    }
    return to == row.size();
}

class PsdDecoder : public Decoder {
  public:
    explicit PsdDecoder(OpenedFile file) : file_(std::move(file)), psd_(read_psd_file(*file_.bytes)) {
        header_.size = psd_.size;
        header_.channels = psd_.mode == PsdMode::grey || psd_.mode == PsdMode::bitmap ? 1 : 3;
        header_.encoded = psd_.depth != 32;
        header_.bits = static_cast<int>(std::max(psd_.depth, 8u));
        header_.has_alpha = (psd_.has_alpha || psd_.transparent_index) && file_.use == PictureUse::light;
        row_bytes_ = (static_cast<std::uint64_t>(header_.size.x) * psd_.depth + 7) / 8;
        find_rows();
    }

    void decode_rows(const std::function<void(int, PixelRow)>& take) override {
        const std::size_t channels = rows_.size() / static_cast<std::size_t>(header_.size.y);
        std::array<std::string, 5> stored;
        std::vector<glm::vec4> row(static_cast<std::size_t>(header_.size.x));
        for (int y = 0; y < header_.size.y; ++y) {
            for (std::size_t c = 0; c < channels; ++c) read_row(c, y, stored[c]);
            for (std::size_t x = 0; x < row.size(); ++x) row[x] = pixel(stored, x);
            take(y, row);
        }
    }

  private:
    // Of each channel that is used; the file must have them all.
    void find_rows() {
        const FileBytes& bytes = *file_.bytes;
        const std::uint64_t height = static_cast<std::uint64_t>(header_.size.y);
        const std::uint64_t used = (psd_.inks() + (psd_.has_alpha ? 1 : 0)) * height;
        const std::uint64_t all = psd_.channels * height;
        const std::uint64_t compression = big_endian(bytes.read(psd_.picture, 2), 0, 2);
        if (compression != none && compression != pack_bits)
            throw PictureProblem(fmt::format(
                "the PSD file's merged picture is compressed by method {}, 0 and 1 are read", compression));
        packed_ = compression == pack_bits;
        const std::size_t count_size = packed_ ? (psd_.is_large ? 4 : 2) : 0;
        std::uint64_t at = psd_.picture + 2;
        const std::string counts = bytes.read(at, used * count_size);
        at += all * count_size;
        for (std::uint64_t i = 0; i < used; ++i) {
            const std::uint64_t length =
                packed_ ? big_endian(counts, i * count_size, count_size) : row_bytes_;
            if (at > bytes.size() || length > bytes.size() - at)
                throw PictureProblem("the PSD file is cut short");
            rows_.push_back({at, length});
            at += length;
        }
    }

    void read_row(std::size_t channel, int y, std::string& row) {
        const auto height = static_cast<std::size_t>(header_.size.y);
        const StoredRow& place = rows_[channel * height + static_cast<std::size_t>(y)];
        row.resize(row_bytes_);
        if (packed_) packed_row_.resize(place.length);
        std::string& target = packed_ ? packed_row_ : row;
        const bool whole = file_.bytes->read(place.at, target.data(), target.size()) == target.size();
        if (!whole || (packed_ && !unpack(packed_row_, row)))
            throw PictureProblem(
                fmt::format("the PSD file is damaged: row {} of channel {}", y + 1, channel + 1));
    }

    float value(const std::string& row, std::size_t x) const {
        if (psd_.depth == 32)
            return std::bit_cast<float>(static_cast<std::uint32_t>(big_endian(row, 4 * x, 4)));
        if (psd_.depth == 16) return static_cast<float>(big_endian(row, 2 * x, 2)) / 65535.0f;
        return static_cast<float>(big_endian(row, x, 1)) / 255.0f;
    }

    glm::vec4 pixel(const std::array<std::string, 5>& rows, std::size_t x) const {
        if (psd_.mode == PsdMode::bitmap) {  // 1 is black
            const bool is_black = (big_endian(rows[0], x / 8, 1) >> (7 - x % 8) & 1) != 0;
            return is_black ? glm::vec4(0, 0, 0, 1) : glm::vec4(1);
        }
        if (psd_.mode == PsdMode::indexed) {
            const std::size_t index = big_endian(rows[0], x, 1);
            const bool is_none = header_.has_alpha && psd_.transparent_index == index;
            return {value(psd_.palette, index), value(psd_.palette, index + 256),
                    value(psd_.palette, index + 512), is_none ? 0.0f : 1.0f};
        }
        const unsigned inks = psd_.inks();
        glm::vec4 colour(value(rows[0], x));
        if (inks > 1) colour = {colour.r, value(rows[1], x), value(rows[2], x), 1};
        if (psd_.mode == PsdMode::cmyk) colour *= value(rows[3], x);  // 0 is full ink
        colour.a = psd_.has_alpha ? value(rows[inks], x) : 1.0f;
        return psd_.has_alpha ? without_white(colour) : colour;
    }

    // The merged picture lies on white. What rounding leaves below black or above white is one or the other.
    glm::vec4 without_white(glm::vec4 colour) const {
        const float alpha = colour.a;
        if (!(alpha > 0)) return glm::vec4(0, 0, 0, alpha);
        for (int c = 0; c < 3; ++c) {
            const float bare = 1 - (1 - colour[c]) / alpha;
            colour[c] =
                header_.encoded ? std::clamp(bare, 0.0f, 1.0f) : std::max(bare, std::min(colour[c], 0.0f));
        }
        return colour;
    }

    OpenedFile file_;
    PsdFile psd_;
    std::uint64_t row_bytes_ = 0;
    bool packed_ = false;
    std::vector<StoredRow> rows_;  // of the first channel, then of the next
    std::string packed_row_;
};

}  // namespace

std::unique_ptr<Decoder> make_psd_decoder(OpenedFile file) {
    return std::make_unique<PsdDecoder>(std::move(file));
}

}  // namespace nacre
