#include "app/cli/contact_sheet.h"

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>
#include <utility>

#include "app/cli/caption.h"

namespace nacre::cli {
namespace {

// All in pixels.
constexpr int thumbnail_max = 256;
constexpr int gap = 12;
constexpr int caption = 30;  // the band under a picture
constexpr int letters = 18;

constexpr float background = 0.10f, text_grey = 0.95f;  // sRGB

std::size_t texel(glm::ivec2 size, int x, int y) {
    return 3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(size.x) + static_cast<std::size_t>(x));
}

glm::ivec2 thumbnail_size(glm::ivec2 full) {
    const double scale = std::min(1.0, static_cast<double>(thumbnail_max) / std::max(full.x, full.y));
    return glm::max(glm::ivec2(glm::round(glm::dvec2(full) * scale)), glm::ivec2(1));
}

// The picture's pixels that a smaller pixel covers, averaged.
RenderedImage thumbnail_of(const RenderedImage& from) {
    RenderedImage to{thumbnail_size(from.size), {}};
    to.rgb.resize(texel(to.size, 0, to.size.y));
    for (int y = 0; y < to.size.y; ++y)
        for (int x = 0; x < to.size.x; ++x) {
            const glm::ivec2 first = glm::ivec2{x, y} * from.size / to.size;
            const glm::ivec2 last = glm::max(glm::ivec2{x + 1, y + 1} * from.size / to.size, first + 1);
            const auto count = static_cast<float>((last.x - first.x) * (last.y - first.y));
            for (std::size_t c = 0; c < 3; ++c) {
                float sum = 0;
                for (int j = first.y; j < last.y; ++j)
                    for (int i = first.x; i < last.x; ++i) sum += from.rgb[texel(from.size, i, j) + c];
                to.rgb[texel(to.size, x, y) + c] = sum / count;
            }
        }
    return to;
}

void copy(const RenderedImage& from, RenderedImage& to, glm::ivec2 place) {
    for (int y = 0; y < from.size.y; ++y)
        std::copy_n(from.rgb.begin() + static_cast<std::ptrdiff_t>(texel(from.size, 0, y)), 3 * from.size.x,
                    to.rgb.begin() + static_cast<std::ptrdiff_t>(texel(to.size, place.x, place.y + y)));
}

}  // namespace

void ContactSheet::add(std::string name, const RenderedImage& image) {
    thumbnails_.push_back({std::move(name), thumbnail_of(image)});
}

RenderedImage ContactSheet::take() {
    const glm::ivec2 size = thumbnails_.front().image.size;
    const int count = static_cast<int>(thumbnails_.size());
    const int columns = static_cast<int>(std::ceil(std::sqrt(static_cast<double>(count))));
    const int rows = (count + columns - 1) / columns;
    const glm::ivec2 cell{size.x + gap, size.y + caption + gap};
    RenderedImage sheet{{columns * cell.x + gap, rows * cell.y + gap}, {}};
    sheet.rgb.assign(texel(sheet.size, 0, sheet.size.y), background);
    const CaptionFont font(letters);
    for (int i = 0; i < count; ++i) {
        const Thumbnail& thumbnail = thumbnails_[static_cast<std::size_t>(i)];
        const glm::ivec2 place = gap + cell * glm::ivec2{i % columns, i / columns};
        copy(thumbnail.image, sheet, place);
        font.draw(sheet, thumbnail.name, place.x + 0.5 * size.x, place.y + size.y + (caption - letters) / 2,
                  size.x, text_grey);
    }
    thumbnails_.clear();
    return sheet;
}

}  // namespace nacre::cli
