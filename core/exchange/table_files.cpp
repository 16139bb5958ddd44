#include "core/exchange/table_files.h"

#include <fmt/core.h>

#include <span>
#include <system_error>

#include "core/design/error.h"
#include "core/exchange/atomic_file.h"
#include "core/exchange/image_file.h"
#include "core/exchange/table_manifest.h"

namespace nacre {
namespace {

namespace fs = std::filesystem;

using Shader = Shading<double>;

std::vector<float> part(const Tables& tables, int offset, int count) {
    const auto begin = tables.data.begin() + offset;
    return {begin, begin + count};
}

// The Fresnel residuals lie one after the other in the data and side by side in a pixel.
TablePicture residual_picture(const Tables& tables) {
    const auto& shape = tables.shading.surface.tables;
    const int size = shape.nodes_v * shape.nodes_rho, channels = tables.plan.fresnel_tables;
    TablePicture picture{"residual.exr", "residual", "v", "rho", {shape.nodes_v, shape.nodes_rho}, {"Y"}, {}};
    if (channels == 3) picture.channels = {"R", "G", "B"};
    for (int i = 0; i < size; ++i)
        for (int c = 0; c < channels; ++c)
            picture.values.push_back(
                tables.data[static_cast<std::size_t>(shape.residual_offset + c * size + i)]);
    return picture;
}

void add_layer_pictures(const Tables& tables, std::vector<TablePicture>& pictures) {
    auto add = [&](int layer, const char* kind, int offset, int side) {
        pictures.push_back({layer_picture_file(layer, kind),
                            kind,
                            "column",
                            "row",
                            {side, side},
                            {"Y"},
                            part(tables, offset, side * side)});
    };
    for (int i = 0; i < tables.shading.layer_count; ++i) {
        const Shader::Layer& layer = tables.shading.layers[i];
        if (layer.kind == Shader::LOBE_PAINTED) add(i, "painted", layer.data_offset, layer.data_size);
        if (layer.picture_size > 0) add(i, "modulation", layer.picture_offset, layer.picture_size);
    }
}

// For whoever loads the tables: which corner is which.
TablePicture corners_picture() {
    return {"corners.exr", "corners", "column", "row", {4, 3}, {"Y"}, {1, 0, 0, 2, 0, 0, 0, 0, 3, 0, 0, 4}};
}

void make_folder(const fs::path& folder) {
    std::error_code error;
    fs::create_directories(folder, error);
    if (error || !fs::is_directory(folder))
        throw UserError(folder.string(), "write", "the folder cannot be made",
                        error ? error.message() : "it is no folder");
}

}  // namespace

std::vector<TablePicture> table_pictures(const Tables& tables) {
    const auto& shape = tables.shading.surface.tables;
    std::vector<TablePicture> pictures;
    pictures.push_back({"area.exr",
                        "A",
                        "w",
                        "psi",
                        {shape.nodes_w, shape.nodes_psi},
                        {"Y"},
                        part(tables, shape.area_offset, shape.nodes_w * shape.nodes_psi)});
    if (tables.plan.albedo)
        pictures.push_back({"albedo.exr",
                            "albedo",
                            "v",
                            "rho",
                            {shape.nodes_v, shape.nodes_rho},
                            {"Y"},
                            part(tables, shape.albedo_offset, shape.nodes_v * shape.nodes_rho)});
    if (tables.plan.albedo && tables.plan.fresnel_tables > 0) pictures.push_back(residual_picture(tables));
    add_layer_pictures(tables, pictures);
    pictures.push_back(corners_picture());
    return pictures;
}

void write_table_files(const fs::path& folder, const Design& design, const Tables& tables,
                       const TableErrors& errors) {
    make_folder(folder);
    const std::vector<TablePicture> pictures = table_pictures(tables);
    for (const TablePicture& picture : pictures)
        write_exr(folder / picture.file, picture.size, picture.channels, picture.values);
    write_file_atomically(folder / "manifest.json", table_manifest(design, tables, pictures, errors));
}

}  // namespace nacre
