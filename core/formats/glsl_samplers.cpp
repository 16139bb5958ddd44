// A GLSL function that reads its tables from a texture, and the texture.
#include "core/base/system/atomic_file.h"
#include "core/formats/export_format.h"
#include "core/formats/glsl_sampler.h"

namespace nacre {
namespace {

namespace fs = std::filesystem;

fs::path tables_beside(fs::path file) { return file.replace_extension(".f32"); }

std::vector<fs::path> files(const Design&, const fs::path& file) { return {file, tables_beside(file)}; }

ExportWriter prepare(const Design& design, const ExportSettings& settings, const std::stop_token& stop,
                     const std::function<void(double)>& progress) {
    const auto tables = bake(design, settings.bake, stop, progress);
    return ExportWriter([text = glsl_sampler_text(design, *tables, settings.prefix),
                         bytes = texture_bytes(sampler_data(*tables))](const fs::path& file) {
        write_files_atomically({{tables_beside(file), bytes}, {file, text}});
        return std::vector<fs::path>{file, tables_beside(file)};
    });
}

}  // namespace

const ExportFormat glsl_samplers_format{
    .name = "glsl-samplers",
    .title = "GLSL function with a texture",
    .about =
        "the function {prefix}_brdf(k1, k2) in one file, and beside it its tables as the texture "
        "{prefix}_data",
    .next =
        "Load the .f32 file beside {file} as a texture of 32-bit floats: one channel, 1024 texels a row, "
        "nearest.\n"
        "Paste {file} into the fragment shader, after #version 330 or later and before main().\n"
        "Bind the texture to the uniform {prefix}_data.\n"
        "Add {prefix}_brdf(to_light, to_viewer) * light * to_light.z for each light, in linear colours.\n"
        "docs/renderers/glsl-samplers.md has the lines to type.",
    .extension = ".glsl",
    .has_names = true,
    .has_error = false,
    .holds = Holdings(Holding::exact),
    .files = files,
    .prepare = prepare};

}  // namespace nacre
