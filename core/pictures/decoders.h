// What open_picture() chooses from.
#pragma once

#include <memory>

#include "core/pictures/decoder.h"
#include "core/pictures/examined.h"

namespace nacre {

struct OpenedFile {
    std::unique_ptr<FileBytes> bytes;
    Examined examined;
    PictureLimits limits;
    PictureUse use;
};

// A PictureProblem where a picture of that size is larger than the limits.
void check_size(glm::dvec2 stored, int orientation, const PictureLimits& limits);

// All formats but the following, with OpenImageIO.
std::unique_ptr<Decoder> make_oiio_decoder(OpenedFile file);

// OpenImageIO multiplies WebP's colours by alpha in 8 bits, and leaves what a first frame does not cover as
// the memory was.
std::unique_ptr<Decoder> make_webp_decoder(OpenedFile file);

// OpenImageIO believes a PSD's numbers: it reads and writes past its rows where they do not fit each other.
std::unique_ptr<Decoder> make_psd_decoder(OpenedFile file);

// Drawn with librsvg, its longer side limits::raster_max pixels. Nothing that the file refers to is loaded.
std::unique_ptr<Decoder> make_svg_decoder(OpenedFile file);

}  // namespace nacre
