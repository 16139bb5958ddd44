#include "core/formats/hlsl_export.h"

#include <fmt/core.h>

#include <set>

#include "core/base/error.h"
#include "core/formats/export_program.h"
#include "core/formats/hlsl_writer.h"
#include "core/formats/shading_values.h"

namespace nacre {
namespace {

std::string head(const std::string& name, const std::string& prefix, bool albedo) {
    std::string text = fmt::format(
        "// {0}: a BRDF made by Nacre (Ashikhmin, Premoze, Shirley 2000). HLSL, shader model 5 or later.\n"
        "//\n"
        "// Directions are unit vectors away from the surface in its own frame: x tangent, y bitangent, z "
        "normal. "
        "k1 points\n"
        "// toward the light, k2 toward the viewer. Colours are linear red, green and blue, Rec. 709.\n"
        "//\n"
        "//   float3 {1}_brdf(float3 k1, float3 k2)\n"
        "//       1/sr, without the cosine; 0 where a direction is not above the horizon.\n"
        "//   float4 {1}_sample(float3 k2, float3 u)\n"
        "//       k1 drawn by three numbers from 0 to 1, 1 left out, and in w its density in 1/sr, or 0 "
        "where the "
        "sample is lost.\n"
        "//   float {1}_pdf(float3 k1, float3 k2)\n"
        "//       The density of k1 in {1}_sample().\n",
        name, prefix);
    if (albedo)
        text += fmt::format(
            "//   float3 {}_albedo(float3 k)\n//       The part of uniform light that leaves toward k, k.z > "
            "0.\n",
            prefix);
    return text + fmt::format("\n#define {}_LARGEST 3.402823466e+38\n", prefix);
}

std::string tables_text(const Shading<double>& shading, const ExportProgram& program,
                        const std::string& prefix) {
    std::string text = fmt::format(
        "\nstatic const {0}_Surface {0}_surface = {1};\n\nstatic const int {0}_layer_count = {2};\n\n"
        "static const {0}_Layer {0}_layers[{2}] = {{\n{3}\n}};\n\nstatic const float {0}_data[{4}] = {{",
        prefix, surface_values(shading, program.tree, Digits::of_float), shading.layer_count,
        layer_values(shading, program.tree, Digits::of_float), program.data.size());
    for (std::size_t i = 0; i < program.data.size(); ++i)
        text += fmt::format("{}{}{}", i > 0 ? "," : "", i % 12 == 0 ? "\n    " : " ",
                            digits_of(static_cast<double>(program.data[i]), Digits::of_float));
    return text + "\n};\n";
}

std::string calls(const std::string& prefix, const std::string& albedo) {
    std::string text = fmt::format(
        "\nfloat4 {0}_sample(float3 k2, float3 u) {{\n    float3 k1 = {0}_drawn_direction(k2, u);\n"
        "    return float4(k1, {0}_drawn_density(k1, k2));\n}}\n"
        "\nfloat {0}_pdf(float3 k1, float3 k2) {{\n    return {0}_drawn_density(k1, k2);\n}}\n",
        prefix);
    if (!albedo.empty())
        text += fmt::format("\nfloat3 {0}_albedo(float3 k) {{\n    return {0}_{1}({0}_direction(k));\n}}\n",
                            prefix, albedo);
    return text;
}

}  // namespace

std::string hlsl_export(const Design& design, const Tables& tables, const std::string& prefix) {
    const ExportProgram program = export_program(tables);
    HlslWriter writer(program.tree, prefix);
    const std::string albedo = program.albedo;
    std::set<std::string> roots{"brdf", "drawn_direction", "drawn_density"};
    if (!albedo.empty()) roots.insert({albedo, "direction"});
    return head(one_line(design.name, 80), prefix, !albedo.empty()) + writer.structs() + "\n" +
           writer.constants() + tables_text(tables.shading, program, prefix) + writer.functions(roots, "") +
           calls(prefix, albedo);
}

}  // namespace nacre
