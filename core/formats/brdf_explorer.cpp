// The text file of Disney's BRDF Explorer: the GLSL function with its tables as constants.
#include <fmt/core.h>

#include "core/base/error.h"
#include "core/formats/export_format.h"
#include "core/formats/glsl_export.h"

namespace nacre {
namespace {

constexpr std::size_t quick_numbers = 8192;  // that drivers compile within seconds

ExportWriter prepare(const Design& design, const ExportSettings& settings, const std::stop_token& stop,
                     const std::function<void(double)>& progress) {
    const auto tables = bake(design, settings.bake, stop, progress);
    ExportWriter writer(fmt::format(
        "analytic\n\n# {}, made by Nacre\n\n::begin parameters\n::end parameters\n\n::begin shader\n\n{}\n"
        "vec3 BRDF(vec3 L, vec3 V, vec3 N, vec3 X, vec3 Y) {{\n"
        "    return {}_brdf(vec3(dot(L, X), dot(L, Y), dot(L, N)), vec3(dot(V, X), dot(V, Y), dot(V, "
        "N)));\n}}\n\n"
        "::end shader\n",
        one_line(design.name, 80), glsl_export(design, *tables, settings.prefix), settings.prefix));
    if (tables->data.size() > quick_numbers)
        writer.notes = {
            fmt::format("Its {} numbers are constants, since the format has no textures: drivers may take "
                        "minutes to compile them.",
                        tables->data.size())};
    return writer;
}

}  // namespace

const ExportFormat brdf_explorer_format{
    .name = "brdf",
    .title = "BRDF Explorer",
    .about = "one .brdf file for Disney's BRDF Explorer, with the tables as constants",
    .next =
        "In BRDF Explorer choose File, Open BRDF, and {file}.\n"
        "Set incidentPhi and incidentTheta as for any other; it multiplies by the cosine itself.",
    .extension = ".brdf",
    .has_names = true,
    .has_error = false,
    .holds = Holdings(Holding::exact),
    .files = one_file,
    .prepare = prepare};

}  // namespace nacre
