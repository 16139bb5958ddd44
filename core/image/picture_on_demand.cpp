// The functions of picture.h, clear_part.h and image_file.h that need OpenImageIO: each loads the library of
// core/pictures when it is first called, and passes the call on.
#include <filesystem>
#include <stdexcept>
#include <string>
#include <string_view>
#include <system_error>

#include "core/base/system/shared_library.h"
#include "core/image/clear_part.h"
#include "core/image/image_file.h"
#include "core/image/picture.h"
#include "core/image/picture_cache.h"
#include "core/image/picture_module.h"

namespace nacre {
namespace {

namespace fs = std::filesystem;

constexpr const char* library_name = "libnacre-pictures.so";

// Beside the program in the build tree, below lib/ where it is installed. The program of another project has
// the folder in its run path, where the loader looks for a name without one.
fs::path find_library() {
    const fs::path program = program_folder();
    for (const fs::path& candidate :
         {program / library_name, program / NACRE_PRIVATE_LIBRARIES / library_name}) {
        std::error_code error;
        if (fs::exists(candidate, error)) return candidate.lexically_normal();
    }
    return library_name;
}

void* find_entry() {
    const fs::path library = find_library();
    try {
        return symbol_of_library(library, "nacre_picture_module");
    } catch (const std::runtime_error& error) {
        if (library.has_parent_path()) throw;
        throw std::runtime_error(std::string(library_name) +
                                 ", which reads and writes pictures, is missing beside the program, at " +
                                 NACRE_PRIVATE_LIBRARIES " and in the run path (" + error.what() + ")");
    }
}

// Stays loaded for as long as the program runs.
const PictureModule* load_module() {
    const PictureModule* const module = reinterpret_cast<decltype(&nacre_picture_module)>(find_entry())();
    if (module->version != std::string_view(NACRE_VERSION))
        throw std::runtime_error(std::string(library_name) + " is of Nacre " + module->version +
                                 ", this program of " + NACRE_VERSION);
    return module;
}

const PictureModule& pictures() {
    static const PictureModule* const loaded = load_module();
    return *loaded;
}

std::shared_ptr<const Raster> shared_raster(const fs::path& file, const std::string& error_file,
                                            const std::string& error_where, PictureShape shape,
                                            PictureNotes* notes) {
    return decoded_once<Raster>(
        file, shape == PictureShape::square ? "square" : "any", notes,
        [&](PictureNotes& found) {
            return pictures().load_picture(file, error_file, error_where, shape, &found);
        },
        [](const Raster& raster) { return raster.values.size() * sizeof(float); });
}

}  // namespace

Raster load_picture(const fs::path& file, const std::string& error_file, const std::string& error_where,
                    PictureShape shape, PictureNotes* notes) {
    return *shared_raster(file, error_file, error_where, shape, notes);
}

std::shared_ptr<const Raster> load_shared_picture(const fs::path& file, const std::string& error_file,
                                                  const std::string& error_where, PictureNotes& notes) {
    return shared_raster(file, error_file, error_where, PictureShape::square, &notes);
}

Raster load_stamp(const fs::path& file, PictureNotes* notes) {
    return *decoded_once<Raster>(
        file, "stamp", notes, [&](PictureNotes& found) { return pictures().load_stamp(file, &found); },
        [](const Raster& raster) { return raster.values.size() * sizeof(float); });
}

ColourPicture load_colours(const fs::path& file, PictureNotes* notes) {
    return *decoded_once<ColourPicture>(
        file, "colours", notes, [&](PictureNotes& found) { return pictures().load_colours(file, &found); },
        [](const ColourPicture& picture) { return picture.colours.size() * sizeof(glm::vec3); });
}

double load_clear_part(const fs::path& file) { return pictures().load_clear_part(file); }

LatLong load_lat_long(const fs::path& file, PictureNotes* notes) {
    return *decoded_once<LatLong>(
        file, "environment", notes,
        [&](PictureNotes& found) { return pictures().load_lat_long(file, &found); },
        [](const LatLong& picture) { return picture.radiance.size() * sizeof(glm::vec3); });
}

ImageBytes png_bytes(glm::ivec2 size, std::span<const std::uint8_t> pixels) {
    return pictures().png_bytes(size, pixels);
}

ImageBytes exr_bytes(glm::ivec2 size, const std::vector<std::string>& channels,
                     std::span<const float> values) {
    return pictures().exr_bytes(size, channels, values);
}

}  // namespace nacre
