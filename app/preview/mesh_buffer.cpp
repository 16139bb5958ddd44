#include "app/preview/mesh_buffer.h"

namespace nacre {

MeshBuffer::MeshBuffer() {
    glGenVertexArrays(1, &array_);
    glGenBuffers(4, buffers_);
}

MeshBuffer::~MeshBuffer() {
    glDeleteBuffers(4, buffers_);
    glDeleteVertexArrays(1, &array_);
}

void MeshBuffer::store(const Mesh& mesh) {
    glBindVertexArray(array_);
    GLuint location = 0;
    for (const auto* field : {&mesh.positions, &mesh.normals, &mesh.tangents}) {
        glBindBuffer(GL_ARRAY_BUFFER, buffers_[location]);
        glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(field->size() * sizeof(glm::vec3)),
                     field->data(), GL_STATIC_DRAW);
        glVertexAttribPointer(location, 3, GL_FLOAT, GL_FALSE, sizeof(glm::vec3), nullptr);
        glEnableVertexAttribArray(location++);
    }
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffers_[location]);
    glBufferData(GL_ELEMENT_ARRAY_BUFFER,
                 static_cast<GLsizeiptr>(mesh.indices.size() * sizeof(std::uint32_t)), mesh.indices.data(),
                 GL_STATIC_DRAW);
    glBindVertexArray(0);
    glBindBuffer(GL_ARRAY_BUFFER, 0);
    indices_ = static_cast<GLsizei>(mesh.indices.size());
}

void MeshBuffer::draw() const {
    glBindVertexArray(array_);
    glDrawElements(GL_TRIANGLES, indices_, GL_UNSIGNED_INT, nullptr);
    glBindVertexArray(0);
}

}  // namespace nacre
