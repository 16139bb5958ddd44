// An OBJ file: what is read is a mesh that can be drawn.
#include <cmath>

#include "core/formats/obj_file.h"
#include "tests/fuzz/target.h"

using namespace nacre;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    fuzz::reads([&] {
        const Mesh mesh = parse_obj(fuzz::text_of(data, size), "fuzz.obj");
        fuzz::require(mesh.indices.size() % 3 == 0, "three corners a triangle");
        for (const std::uint32_t index : mesh.indices)
            fuzz::require(index < mesh.positions.size(), "every corner is a point");
        fuzz::require(mesh.normals.size() == mesh.positions.size(), "a normal a point");
        for (std::size_t i = 0; i < mesh.positions.size(); ++i)
            for (int c = 0; c < 3; ++c)
                fuzz::require(std::isfinite(mesh.positions[i][c]) && std::isfinite(mesh.normals[i][c]),
                              "positions and normals are finite");
    });
    return 0;
}
