// The header of an OpenEXR file. (OpenEXR File Layout)
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/pictures/file_bytes.h"

namespace nacre {

struct ExrHeader {
    std::array<std::int64_t, 4> data_window{}, display_window{};  // least x, y, largest x, y
    unsigned compression = 0;
    std::optional<std::array<std::int64_t, 2>> tile;      // width and height
    std::vector<std::string> subsampled;                  // channels
    std::int64_t pixel_bytes = 0, pxr24_pixel_bytes = 0;  // as decoded, and as Pxr24 keeps them
    std::optional<std::array<double, 8>> chromaticities;
    bool is_cube = false;
    std::string name, type;

    std::int64_t width() const { return data_window[2] - data_window[0] + 1; }
    std::int64_t height() const { return data_window[3] - data_window[1] + 1; }
};

struct ExrHeaders {
    std::vector<ExrHeader> parts;
    bool is_deep = false, is_multipart = false;
    std::uint64_t end = 0;      // where the table of blocks begins
    std::vector<Piece> pieces;  // the file; what makes no pixels hidden from the decoder
};

// A PictureProblem where it is damaged.
ExrHeaders read_exr_headers(const FileBytes& file);

}  // namespace nacre
