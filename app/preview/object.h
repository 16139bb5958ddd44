// What the preview shows the surface on.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "core/geometry/mesh.h"

namespace nacre {

struct SceneObject {
    std::string name = "sphere";       // of object_names(), or the path of an OBJ file
    std::shared_ptr<const Mesh> mesh;  // none: the sphere, which is drawn by its formula
    double pitch = 0;  // degrees that the object leans toward the viewer before the camera's own
    std::string note;  // what of a file was left out or made up, in one line; mostly empty

    bool operator==(const SceneObject&) const = default;
};

// "sphere", "torus", "plate", "tablecloth".
std::vector<std::string> object_names();

// Whether it is one of object_names() or ends in .obj.
bool names_object(const std::string& name);

// One of object_names(), or an OBJ file by its path, which ends in .obj. What is wrong is a UserError. A
// large file takes seconds: call it off the interface's thread.
SceneObject make_object(const std::string& name);

}  // namespace nacre
