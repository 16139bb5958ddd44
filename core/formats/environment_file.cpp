#include "core/formats/environment_file.h"

#include <utility>

#include "core/image/picture.h"
#include "core/light/procedural.h"

namespace nacre {

std::shared_ptr<const Environment> load_environment(const std::string& name_or_file) {
    if (auto picture = procedural_environment(name_or_file))
        return make_environment(name_or_file, *std::move(picture));
    PictureNotes notes;
    LatLong picture = load_lat_long(name_or_file, &notes);
    return make_environment(name_or_file, std::move(picture), std::move(notes));
}

}  // namespace nacre
