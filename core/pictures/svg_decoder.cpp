#include <cairo.h>
#include <librsvg/rsvg.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include "core/base/limits.h"
#include "core/pictures/decoders.h"
#include "core/pictures/picture_problem.h"

// Pixels of the longer side. The fuzz target draws small, so that it looks at many drawings.
#ifndef NACRE_DRAWN_SIDE
#define NACRE_DRAWN_SIDE limits::raster_max
#endif

namespace nacre {
namespace {

constexpr double side_max = NACRE_DRAWN_SIDE;
constexpr double slimmest = 1.0 / side_max;  // the shorter side over the longer one

struct Unref {
    void operator()(RsvgHandle* handle) const { g_object_unref(handle); }
    void operator()(cairo_surface_t* surface) const { cairo_surface_destroy(surface); }
    void operator()(cairo_t* cairo) const { cairo_destroy(cairo); }
};

// Width over height, as the file has it: its view box, its size, or what is drawn in it.
double aspect_of(RsvgHandle* handle) {
    gboolean has_width = FALSE, has_height = FALSE, has_box = FALSE;
    RsvgLength width, height;
    RsvgRectangle box, ink;
    rsvg_handle_get_intrinsic_dimensions(handle, &has_width, &width, &has_height, &height, &has_box, &box);
    double pixels_wide = 0, pixels_high = 0;
    if (rsvg_handle_get_intrinsic_size_in_pixels(handle, &pixels_wide, &pixels_high) != FALSE &&
        pixels_wide > 0 && pixels_high > 0)
        return pixels_wide / pixels_high;
    if (has_box != FALSE && box.width > 0 && box.height > 0) return box.width / box.height;
    if (rsvg_handle_get_geometry_for_element(handle, nullptr, &ink, nullptr, nullptr) != FALSE &&
        ink.width > 0 && ink.height > 0)
        return ink.width / ink.height;
    throw PictureProblem("the SVG file draws nothing");
}

class SvgDecoder : public Decoder {
  public:
    explicit SvgDecoder(OpenedFile file) {
        const std::string bytes = file.bytes->read(0, file.bytes->size());
        GError* error = nullptr;
        handle_.reset(
            rsvg_handle_new_from_data(reinterpret_cast<const guint8*>(bytes.data()), bytes.size(), &error));
        if (!handle_) throw PictureProblem("the SVG file is damaged: " + text_of(error));
        const double aspect = std::clamp(aspect_of(handle_.get()), slimmest, 1 / slimmest);
        header_.size = {static_cast<int>(std::lround(side_max * std::min(aspect, 1.0))),
                        static_cast<int>(std::lround(side_max / std::max(aspect, 1.0)))};
        header_.size = glm::max(header_.size, glm::ivec2(1));
        header_.encoded = true;
        header_.bits = 8;
        header_.has_alpha = file.use == PictureUse::light;
    }

    void decode_rows(const std::function<void(int, PixelRow)>& take) override {
        const std::unique_ptr<cairo_surface_t, Unref> surface(
            cairo_image_surface_create(CAIRO_FORMAT_ARGB32, header_.size.x, header_.size.y));
        const std::unique_ptr<cairo_t, Unref> cairo(cairo_create(surface.get()));
        const RsvgRectangle all{0, 0, double(header_.size.x), double(header_.size.y)};
        GError* error = nullptr;
        if (rsvg_handle_render_document(handle_.get(), cairo.get(), &all, &error) == FALSE)
            throw PictureProblem("the SVG file cannot be drawn: " + text_of(error));
        cairo_surface_flush(surface.get());
        const unsigned char* const pixels = cairo_image_surface_get_data(surface.get());
        if (pixels == nullptr || cairo_status(cairo.get()) != CAIRO_STATUS_SUCCESS)
            throw PictureProblem("the SVG file cannot be drawn");
        const int stride = cairo_image_surface_get_stride(surface.get());
        std::vector<glm::vec4> row(static_cast<std::size_t>(header_.size.x));
        for (int y = 0; y < header_.size.y; ++y) {
            const auto* from = reinterpret_cast<const std::uint32_t*>(pixels + std::ptrdiff_t{y} * stride);
            std::transform(from, from + header_.size.x, row.begin(),
                           [this](std::uint32_t pixel) { return straight(pixel); });
            take(y, row);
        }
    }

  private:
    static std::string text_of(GError* error) {
        const std::string text = error != nullptr ? error->message : "no reason is given";
        g_clear_error(&error);
        return text;
    }

    // Of 8 bits a channel, alpha highest, which the colours have been multiplied by.
    glm::vec4 straight(std::uint32_t pixel) const {
        const auto part = [pixel](int shift) { return static_cast<float>((pixel >> shift) & 0xFF) / 255.0f; };
        const float alpha = part(24);
        if (!(alpha > 0)) return glm::vec4(0, 0, 0, header_.has_alpha ? 0.0f : 1.0f);
        const glm::vec3 colour = glm::min(glm::vec3(part(16), part(8), part(0)) / alpha, 1.0f);
        return {colour, header_.has_alpha ? alpha : 1.0f};
    }

    std::unique_ptr<RsvgHandle, Unref> handle_;
};

}  // namespace

std::unique_ptr<Decoder> make_svg_decoder(OpenedFile file) {
    return std::make_unique<SvgDecoder>(std::move(file));
}

}  // namespace nacre
