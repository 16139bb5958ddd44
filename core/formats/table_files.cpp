#include "core/formats/table_files.h"

#include <fmt/core.h>

#include <span>

#include "core/bake/momentum_tables.h"
#include "core/base/system/atomic_file.h"
#include "core/base/system/output_folder.h"
#include "core/formats/coat_manifest.h"
#include "core/formats/table_manifest.h"
#include "core/image/image_file.h"

namespace nacre {
namespace {

namespace fs = std::filesystem;

using Shader = Shading<double>;

std::vector<float> part(const Tables& tables, int offset, int count) {
    const auto begin = tables.data.begin() + offset;
    return {begin, begin + count};
}

// Tables of R for each colour lie one after the other in the data and side by side in a pixel.
TablePicture albedo_picture(const Tables& tables, const char* quantity, int offset, int channels) {
    const auto& shape = tables.shading.surface.tables;
    const int size = shape.nodes_v * shape.nodes_rho;
    TablePicture picture{std::string(quantity) + ".exr",   quantity, "v", "rho",
                         {shape.nodes_v, shape.nodes_rho}, {"Y"},    {}};
    if (channels == 3) picture.channels = {"R", "G", "B"};
    for (int i = 0; i < size; ++i)
        for (int c = 0; c < channels; ++c)
            picture.values.push_back(tables.data[static_cast<std::size_t>(offset + c * size + i)]);
    return picture;
}

// A momentum table's axes; see shaders/multibounce/momentum.glsl.
TablePicture momentum_picture(const Tables& tables, const char* quantity, int offset, bool difference) {
    const glm::ivec2 size = momentum_size(tables.shading, difference);
    const int nodes = tables.shading.surface.tables.momentum_nodes;
    TablePicture picture{fmt::format("bounce-{}.exr", quantity),
                         quantity,
                         "abs(x') from 0 to 2",
                         "abs(y') from 0 to 2",
                         size,
                         {"Y"},
                         part(tables, offset, size.x * size.y)};
    if (size.x > nodes) picture.x = "x' from -2 to 2";
    if (size.y > nodes) picture.y = "y' from -2 to 2";
    if (size.y > nodes && difference)
        picture.x = "x' from 0 to 2, after (-x', -y') in the place of (x', y') where x' < 0";
    if (size.y == 1) {
        picture.x = "sqrt(x'^2 + y'^2) from 0 to 2";
        picture.y = "";
    }
    return picture;
}

void add_bounce_pictures(const Tables& tables, std::vector<TablePicture>& pictures) {
    const auto& shape = tables.shading.surface.tables;
    const ShadingKinds& kinds = tables.shading.kinds;
    const int factors = kinds.bounce_factors();
    const auto add = [&](const char* quantity, int offset, int channels) {
        pictures.push_back(albedo_picture(tables, quantity, offset, channels));
        pictures.back().file = fmt::format("bounce-{}.exr", quantity);
    };
    if (kinds.tint == Tint::varied) add("whole", shape.whole_offset, 1);
    if (factors > 0) add("factor", shape.factor_offset, factors);
    if (!tables.bounces->fitted) return;
    pictures.push_back(momentum_picture(tables, "amplitude", shape.amplitude_offset, false));
    add("brought", shape.row_offset, 1);
    if (factors > 0) add("spread", shape.spread_offset, factors);
    pictures.push_back(momentum_picture(tables, "sum", shape.sum_offset, false));
    pictures.push_back(momentum_picture(tables, "difference", shape.difference_offset, true));
}

// Table by table, one below the other.
void add_facet_pictures(const Tables& tables, std::vector<TablePicture>& pictures) {
    const auto& shape = tables.shading.surface.tables;
    const int size = shape.facet_nodes * shape.facet_rows, terms = shape.facet_classes * shape.facet_terms;
    pictures.push_back({"facet-terms.exr",
                        "facet_terms",
                        "w",
                        "psi, term after term",
                        {shape.facet_nodes, shape.facet_rows * terms},
                        {"Y"},
                        part(tables, shape.facet_offset, size * terms)});
    pictures.push_back({"facet-albedo.exr",
                        "facet_albedo",
                        "w",
                        "psi",
                        {shape.facet_nodes, shape.facet_rows},
                        {"Y"},
                        part(tables, shape.facet_offset + size * terms, size)});
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
        if (lobe_reads_picture(layer.kind)) add(i, "painted", layer.data_offset, layer.data_size);
        if (layer.picture_size > 0) add(i, "modulation", layer.picture_offset, layer.picture_size);
    }
}

// For whoever loads the tables: which corner is which.
TablePicture corners_picture() {
    return {"corners.exr", "corners", "column", "row", {4, 3}, {"Y"}, {1, 0, 0, 2, 0, 0, 0, 0, 3, 0, 0, 4}};
}

constexpr const char* manifest_name = "manifest.json";

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
    const AlbedoLayout layout = tables.needs.layout();
    if (tables.needs.albedo)
        pictures.push_back(albedo_picture(tables, "albedo", shape.albedo_offset, layout.full()));
    if (tables.needs.albedo && layout.factors() > 0)
        pictures.push_back(albedo_picture(tables, "residual", shape.residual_offset, layout.factors()));
    if (tables.bounces) add_bounce_pictures(tables, pictures);
    if (tables.shading.kinds.matt_facets()) add_facet_pictures(tables, pictures);
    if (tables.shading.kinds.coated()) add_coat_pictures(tables, pictures);
    add_layer_pictures(tables, pictures);
    pictures.push_back(corners_picture());
    return pictures;
}

std::vector<fs::path> table_files(const fs::path& folder, const Design& design) {
    std::vector<fs::path> files;
    for (const char* name : {"area.exr", "albedo.exr", "residual.exr", "corners.exr", manifest_name})
        files.push_back(folder / name);
    if (has_bounces(design.multibounce))
        for (const char* name : {"whole", "factor", "amplitude", "brought", "spread", "sum", "difference"})
            files.push_back(folder / fmt::format("bounce-{}.exr", name));
    if (has_matt_facets(design.diffuse))
        for (const char* name : {"facet-terms.exr", "facet-albedo.exr"}) files.push_back(folder / name);
    if (is_coated(design.coat))
        for (const char* name : {"coat-albedo.exr", "coat-whole.exr", "coat-inner.exr"})
            files.push_back(folder / name);
    for (int layer = 0; layer < static_cast<int>(design.distribution.layers.size()); ++layer)
        for (const char* kind : {"painted", "modulation"})
            files.push_back(folder / layer_picture_file(layer, kind));
    return files;
}

// The manifest is never beside tables that it does not describe, nor tables of two designs together.
std::vector<fs::path> write_table_files(const fs::path& folder, const Design& design, const Tables& tables,
                                        const TableErrors& errors) {
    const OutputFolder made(folder);
    const std::vector<TablePicture> pictures = table_pictures(tables);
    const std::string manifest = table_manifest(design, tables, pictures, errors);
    std::vector<ImageBytes> encoded;
    for (const TablePicture& picture : pictures)
        encoded.push_back(exr_bytes(picture.size, picture.channels, picture.values));
    std::vector<FileToWrite> files;
    for (std::size_t i = 0; i < pictures.size(); ++i)
        files.push_back({folder / pictures[i].file, text_of(encoded[i])});
    files.push_back({folder / manifest_name, manifest});
    write_files_atomically(files);
    std::vector<fs::path> written;
    for (const FileToWrite& file : files) written.push_back(file.file);
    return written;
}

}  // namespace nacre
