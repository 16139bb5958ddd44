// What the preview shows the surface on.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "core/geometry/mesh.h"

namespace nacre {

struct SceneObject {
    std::string name = "sphere";       // of object_names(), or the path of an OBJ file
    std::shared_ptr<const Mesh> mesh;  // none: the sphere, which is drawn by its formula
    double pitch = 0;  // degrees by which the object is tilted toward the viewer before the camera's own
    std::string note;  // what of a file was left out or made up, in one line; mostly empty

    bool operator==(const SceneObject&) const = default;
};

// An object that needs no file: one file for each, app/preview/objects/NAME.cpp, and its line in
// object_list.inc.
struct ObjectKind {
    const char* name;   // on the command line
    const char* label;  // in the window
    const char* about;
    Mesh (*mesh)();  // null: the sphere
    double pitch;    // see SceneObject
};

std::span<const ObjectKind* const> object_kinds();

#define OBJECT(name) extern const ObjectKind name##_object;
#include "app/preview/object_list.inc"
#undef OBJECT

std::vector<std::string> object_names();

// Whether it is one of object_names() or ends in .obj.
bool names_object(const std::string& name);

// One of object_names(), or an OBJ file by its path, which ends in .obj. What is wrong is a UserError. A
// large file takes seconds: call it off the interface's thread.
SceneObject make_object(const std::string& name);

}  // namespace nacre
