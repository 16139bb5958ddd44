#include "app/preview/upload.h"

#include <glm/gtc/type_ptr.hpp>

#include "core/model/parameter_fields.h"

namespace nacre {
namespace {

template <class Struct>
void upload_fields(const Program& program, const std::string& prefix, const Struct& fields) {
    visit_fields(fields, [&](const char* name, const auto& value) {
        set_uniform(program, (prefix + name).c_str(), value);
    });
}

}  // namespace

void set_uniform(const Program& program, const char* name, int value) {
    glUniform1i(program.uniform(name), value);
}

void set_uniform(const Program& program, const char* name, double value) {
    glUniform1f(program.uniform(name), static_cast<float>(value));
}

void set_uniform(const Program& program, const char* name, glm::dvec2 value) {
    glUniform2fv(program.uniform(name), 1, glm::value_ptr(glm::vec2(value)));
}

void set_uniform(const Program& program, const char* name, glm::dvec3 value) {
    glUniform3fv(program.uniform(name), 1, glm::value_ptr(glm::vec3(value)));
}

void set_uniform(const Program& program, const char* name, const glm::dmat3& value) {
    glUniformMatrix3fv(program.uniform(name), 1, GL_FALSE, glm::value_ptr(glm::mat3(value)));
}

void upload_surface(const Program& program, const Shading<double>& shading, int unit) {
    upload_fields(program, "surface.tables.", shading.surface.tables);
    upload_fields(program, "surface.", shading.surface);
    for (int i = 0; i < shading.layer_count; ++i)
        upload_fields(program, "layers[" + std::to_string(i) + "].", shading.layers[i]);
    set_uniform(program, "layer_count", shading.layer_count);
    set_uniform(program, "surface_data", unit);
}

void upload_closed_form(const Program& program, const Shading<double>::ClosedForm& form) {
    upload_fields(program, "closed_form.", form);
}

}  // namespace nacre
