#include "core/formats/c_header.h"

#include <fmt/core.h>

#include <set>

#include "core/base/error.h"
#include "core/formats/c_writer.h"
#include "core/formats/export_program.h"
#include "core/formats/shading_values.h"

namespace nacre {
namespace {

constexpr std::string_view head = R"(//
// Directions are unit vectors away from the surface in its own frame: x tangent, y bitangent, z normal. k1
// points toward the light, k2 toward the viewer. Colours are linear red, green and blue, Rec. 709.
//
//   void @brdf(const @real k1[3], const @real k2[3], @real rho[3])
//       1/sr, without the cosine; 0 where a direction is not above the horizon.
//   @real @sample(const @real k2[3], const @real u[3], @real k1[3])
//       Draws k1 by three numbers from 0 to 1, 1 left out; returns its density in 1/sr, 0 where it is lost.
//   @real @pdf(const @real k1[3], const @real k2[3])
//       The density of k1 in @sample().
)";

constexpr std::string_view albedo_head = R"(//   void @albedo(const @real k[3], @real albedo[3])
//       The part of uniform light that leaves toward k, k[2] > 0.
)";

constexpr std::string_view opening = R"(//
// C99 or C++. @real is a double, or a float if @FLOAT or NACRE_FLOAT is defined before this is included.
#ifndef @BRDF_H
#define @BRDF_H

#include <float.h>
#include <math.h>

#if defined(@FLOAT) || defined(NACRE_FLOAT)
typedef float @real;
#define @MATH(function) function##f
#define @LARGEST FLT_MAX
#else
typedef double @real;
#define @MATH(function) function
#define @LARGEST DBL_MAX
#endif
)";

constexpr std::string_view calls = R"(
static inline @vec3 @vector(const @real k[3]) {
    @vec3 v;
    v.x = k[0];
    v.y = k[1];
    v.z = k[2];
    return v;
}

static inline void @brdf(const @real k1[3], const @real k2[3], @real rho[3]) {
    @vec3 value = @evaluated_brdf(@vector(k1), @vector(k2));
    rho[0] = value.x;
    rho[1] = value.y;
    rho[2] = value.z;
}

static inline @real @pdf(const @real k1[3], const @real k2[3]) {
    return @drawn_density(@vector(k1), @vector(k2));
}

static inline @real @sample(const @real k2[3], const @real u[3], @real k1[3]) {
    @vec3 drawn = @drawn_direction(@vector(k2), @vector(u));
    k1[0] = drawn.x;
    k1[1] = drawn.y;
    k1[2] = drawn.z;
    return @drawn_density(drawn, @vector(k2));
}
)";

constexpr std::string_view albedo_call = R"(
static inline void @albedo(const @real k[3], @real albedo[3]) {{
    @vec3 value = @{}(@direction(@vector(k)));
    albedo[0] = value.x;
    albedo[1] = value.y;
    albedo[2] = value.z;
}}
)";

std::string data_text(const std::vector<float>& data, const std::string& prefix) {
    std::string text = fmt::format("\nstatic const float {}_data[{}] = {{", prefix, data.size());
    for (std::size_t i = 0; i < data.size(); ++i)
        text += fmt::format("{}{}{}f", i > 0 ? "," : "", i % 10 == 0 ? "\n    " : " ",
                            digits_of(static_cast<double>(data[i]), Digits::of_float));
    return text + "\n};\n";
}

std::string tables_text(const Shading<double>& shading, const ExportProgram& program,
                        const std::string& prefix) {
    const GlslProgram& tree = program.tree;
    return fmt::format(
               "\nstatic const {0}_Surface {0}_surface = {1};\n\nstatic const int {0}_layer_count = {2};\n\n"
               "static const {0}_Layer {0}_layers[{2}] = {{\n{3}\n}};\n",
               prefix, surface_values(shading, tree, Digits::of_double), shading.layer_count,
               layer_values(shading, tree, Digits::of_double)) +
           data_text(program.data, prefix);
}

}  // namespace

std::string c_header(const Design& design, const Tables& tables, const std::string& prefix) {
    const ExportProgram program = export_program(tables);
    CWriter writer(program.tree, prefix);
    const std::string albedo = program.albedo;
    std::set<std::string> roots{"brdf", "drawn_direction", "drawn_density"};
    if (!albedo.empty()) roots.insert({albedo, "direction"});
    const std::string constants = writer.constants();
    const std::string functions = writer.functions(roots, "static inline ");
    std::string text = fmt::format("// {}: a BRDF made by Nacre (Ashikhmin, Premoze, Shirley 2000).\n",
                                   one_line(design.name, 80));
    text += with_prefix(head, prefix);
    if (!albedo.empty()) text += with_prefix(albedo_head, prefix);
    text += with_prefix(opening, prefix) + writer.structs() + "\n" + constants +
            tables_text(tables.shading, program, prefix) + writer.helpers() + functions +
            with_prefix(calls, prefix);
    if (!albedo.empty()) text += with_prefix(fmt::format(fmt::runtime(albedo_call), albedo), prefix);
    return text + "\n#endif\n";
}

}  // namespace nacre
