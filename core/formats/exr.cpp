// Tables as EXR pictures with a manifest.
#include "core/formats/export_format.h"
#include "core/formats/table_files.h"
#include "core/verify/reference.h"
#include "core/verify/table_error.h"

namespace nacre {
namespace {

namespace fs = std::filesystem;

constexpr double baked = 0.3;  // of the progress: to measure takes longer than to bake

ExportWriter prepare(const Design& design, const ExportSettings& settings, const std::stop_token& stop,
                     const std::function<void(double)>& progress) {
    BakeOptions options = settings.bake;
    options.albedo = true;
    const auto part = [&](double from, double to) {
        return [&progress, from, to](double done) {
            if (progress) progress(from + (to - from) * done);
        };
    };
    const auto tables = bake(design, options, stop, part(0, baked));
    const TableErrors errors = measure_table_errors(*tables, Reference(design), stop, {}, part(baked, 1));
    return ExportWriter([design, tables, errors](const fs::path& folder) {
        return write_table_files(folder, design, *tables, errors);
    });
}

std::vector<fs::path> files(const Design& design, const fs::path& folder) {
    return table_files(folder, design);
}

}  // namespace

const ExportFormat exr_format{.name = "exr",
                              .title = "Tables as EXR pictures",
                              .about = "a folder of tables as EXR pictures, with manifest.json",
                              .next =
                                  "Load each .exr file of {file} as a texture of floats: linear between "
                                  "texels, clamped to its edges, no sRGB, no mipmaps.\n"
                                  "Read corners.exr the same way: 1 and 2 stand in its first line's ends, 3 "
                                  "and 4 in its last's. Else the loader flips pictures.\n"
                                  "Evaluate what manifest.json says under evaluate and brdf, in that order, "
                                  "with its constants; examples/read_tables.py does so.\n"
                                  "Multiply by the light and by the cosine of its angle. docs/tables.md "
                                  "explains every key.",
                              .extension = "",
                              .has_names = false,
                              .has_error = false,
                              .holds = Holdings(Holding::exact),
                              .files = files,
                              .prepare = prepare};

}  // namespace nacre
