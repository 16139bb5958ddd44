#include "app/preview/object.h"

#include <algorithm>
#include <utility>

#include "core/exchange/file_ending.h"
#include "core/exchange/obj_file.h"
#include "core/geometry/shapes.h"
#include "core/geometry/tablecloth.h"

namespace nacre {
namespace {

SceneObject with_mesh(const std::string& name, Mesh mesh, double pitch) {
    return {name, std::make_shared<const Mesh>(std::move(mesh)), pitch, {}};
}

}  // namespace

std::vector<std::string> object_names() { return {"sphere", "torus", "plate", "tablecloth"}; }

bool names_object(const std::string& name) {
    const std::vector<std::string> names = object_names();
    if (std::find(names.begin(), names.end(), name) != names.end()) return true;
    return ending_of(name) == ".obj";
}

SceneObject make_object(const std::string& name) {
    if (name == "sphere") return {};
    if (name == "torus") return with_mesh(name, torus(), 50);
    if (name == "plate") return with_mesh(name, plate(), 0);
    if (name == "tablecloth") return with_mesh(name, cloth_mesh(draped_cloth()), 24);
    std::string note;
    SceneObject object = with_mesh(name, load_obj(name, &note), 15);
    object.note = std::move(note);
    return object;
}

}  // namespace nacre
