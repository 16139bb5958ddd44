// A mesh in the memory of the graphics processor. Needs a current OpenGL 3.3 core context.
#pragma once

#include "app/preview/gl_objects.h"
#include "core/geometry/mesh.h"

namespace nacre {

class MeshBuffer {
  public:
    MeshBuffer();
    ~MeshBuffer();
    MeshBuffer(const MeshBuffer&) = delete;
    MeshBuffer& operator=(const MeshBuffer&) = delete;

    void store(const Mesh& mesh);
    // Positions, normals and tangents at the locations 0, 1 and 2 of what is in use.
    void draw() const;

  private:
    GLuint array_ = 0;
    GLuint buffers_[4] = {};
    GLsizei indices_ = 0;
};

}  // namespace nacre
