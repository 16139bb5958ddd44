#include "core/image/picture_module.h"

#include "core/image/clear_part.h"
#include "core/image/image_file.h"

[[gnu::visibility("default")]] const nacre::PictureModule* nacre_picture_module() {
    static constexpr nacre::PictureModule module{.version = NACRE_VERSION,
                                                 .load_picture = nacre::load_picture,
                                                 .load_stamp = nacre::load_stamp,
                                                 .load_colours = nacre::load_colours,
                                                 .load_clear_part = nacre::load_clear_part,
                                                 .load_lat_long = nacre::load_lat_long,
                                                 .png_bytes = nacre::png_bytes,
                                                 .exr_bytes = nacre::exr_bytes};
    return &module;
}
