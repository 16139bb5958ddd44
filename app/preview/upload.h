// A baked surface's parameters as uniforms.
#pragma once

#include "app/preview/gl_objects.h"
#include "core/model/shading.h"

namespace nacre {

// `program` is in use; `unit` is the texture unit that holds the surface's data.
void upload_surface(const Program& program, const Shading<double>& shading, int unit);

// The model that a variant with closed_form shows.
void upload_closed_form(const Program& program, const Shading<double>::ClosedForm& form);

void set_uniform(const Program& program, const char* name, int value);
void set_uniform(const Program& program, const char* name, double value);
void set_uniform(const Program& program, const char* name, glm::dvec2 value);
void set_uniform(const Program& program, const char* name, glm::dvec3 value);
void set_uniform(const Program& program, const char* name, const glm::dmat3& value);

}  // namespace nacre
