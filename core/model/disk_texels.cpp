#include "core/model/disk_texels.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <utility>

#include "core/model/texel_tents.h"

namespace nacre {
namespace {

std::size_t index_of(int side, int row, int column) {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(side) + static_cast<std::size_t>(column);
}

// One step toward the middle, where there is one.
int inward(int side, int at) {
    const int off = 2 * at + 1 - side;
    return std::abs(off) < 2 ? at : off > 0 ? at - 1 : at + 1;
}

// The columns of a row that are on the disk, the end not included.
struct Columns {
    int begin, end;
};

Columns columns_on_disk(int side, int row) {
    Columns columns{0, side};
    while (columns.begin < side / 2 && !on_disk(side, row, columns.begin)) ++columns.begin;
    columns.end = side - columns.begin;
    if (!on_disk(side, row, columns.begin)) columns.begin = columns.end = side / 2;
    return columns;
}

}  // namespace

TexelSources texel_sources(int side, int row, int column) {
    const int to_row = inward(side, row), to_column = inward(side, column);
    TexelSources sources;
    const auto add = [&](int r, int c) {
        if (on_disk(side, r, c))
            sources.index[static_cast<std::size_t>(sources.count++)] = index_of(side, r, c);
    };
    add(row, to_column);
    add(to_row, column);
    if (sources.count == 0) add(to_row, to_column);
    return sources;
}

Raster extended_past_rim(const Raster& picture) {
    Raster result = picture;
    const int side = picture.width;
    const auto extend = [&](int row, int column) {
        const TexelSources sources = texel_sources(side, row, column);
        float sum = 0;
        for (int i = 0; i < sources.count; ++i)
            sum += picture.values[sources.index[static_cast<std::size_t>(i)]] /
                   static_cast<float>(sources.count);
        result.values[index_of(side, row, column)] = sum;
    };
    for (int row = 0; row < side; ++row) {
        const Columns on = columns_on_disk(side, row);
        // No farther out than a column beyond the next row's.
        const Columns next = columns_on_disk(side, inward(side, row));
        const int begin = std::max(next.begin - 1, 0), end = std::min(next.end + 1, side);
        const auto values = result.values.begin() + static_cast<std::ptrdiff_t>(index_of(side, row, 0));
        std::fill(values, values + begin, 0.0F);
        std::fill(values + end, values + side, 0.0F);
        for (int column = begin; column < on.begin; ++column) extend(row, column);
        for (int column = on.end; column < end; ++column) extend(row, column);
    }
    return result;
}

double raster_mass(const Raster& picture) {
    const Raster read = extended_past_rim(picture);
    const TexelTents tents(picture.width);
    double sum = 0;
    for (int row = 0; row < picture.height; ++row) {
        double of_row = 0;
        for (int column = 0; column < picture.width; ++column) {
            const float value = read.values[index_of(picture.width, row, column)];
            if (value > 0) of_row += static_cast<double>(value) * tents.weight(row, column);
        }
        sum += of_row;
    }
    return sum;
}

float largest_on_disk(const Raster& picture) {
    float largest = 0;
    for (int row = 0; row < picture.height; ++row) {
        const Columns on = columns_on_disk(picture.width, row);
        const float* values = &picture.values[index_of(picture.width, row, 0)];
        for (int column = on.begin; column < on.end; ++column) largest = std::max(largest, values[column]);
    }
    return largest;
}

ScaledPicture scaled_picture(const Raster& picture) {
    std::vector<float> texels = extended_past_rim(picture).values;
    const float largest = largest_on_disk(picture);
    if (!(largest > 0)) return {std::move(texels), 1};
    const int exponent = std::ilogb(largest);
    ScaledPicture result{std::move(texels), std::scalbn(1.0, exponent)};
    for (float& texel : result.texels) texel = std::scalbn(texel, -exponent);
    return result;
}

}  // namespace nacre
