#include "app/preview/object.h"

#include <algorithm>
#include <array>
#include <utility>

#include "core/base/file_extension.h"
#include "core/formats/obj_file.h"

namespace nacre {

std::span<const ObjectKind* const> object_kinds() {
    static const std::array list{
#define OBJECT(name) &name##_object,
#include "app/preview/object_list.inc"
#undef OBJECT
    };
    return list;
}

std::vector<std::string> object_names() {
    std::vector<std::string> names;
    for (const ObjectKind* kind : object_kinds()) names.emplace_back(kind->name);
    return names;
}

bool names_object(const std::string& name) {
    const std::vector<std::string> names = object_names();
    if (std::find(names.begin(), names.end(), name) != names.end()) return true;
    return extension_of(name) == ".obj";
}

SceneObject make_object(const std::string& name) {
    constexpr double file_pitch = 15;
    for (const ObjectKind* kind : object_kinds())
        if (kind->name == name)
            return {name, kind->mesh ? std::make_shared<const Mesh>(kind->mesh()) : nullptr, kind->pitch, {}};
    std::string note;
    SceneObject object{name, std::make_shared<const Mesh>(load_obj(name, &note)), file_pitch, {}};
    object.note = std::move(note);
    return object;
}

}  // namespace nacre
