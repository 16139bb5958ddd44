#include "core/exchange/table_files.h"

#include <fmt/core.h>
#include <stdlib.h>

#include <cerrno>
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

// Its error is about the file that `folder` was to have.
void write_picture(const fs::path& staging, const fs::path& folder, const TablePicture& picture) {
    try {
        write_exr(staging / picture.file, picture.size, picture.channels, picture.values);
    } catch (const UserError& error) {
        throw UserError((folder / picture.file).string(), error.where, error.problem, error.found);
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

constexpr const char* manifest_name = "manifest.json";

// A hidden folder within another, for files on their way there.
class Staging {
  public:
    explicit Staging(const fs::path& folder) : folder_(folder) {
        std::string name = (folder / ".nacre-export-XXXXXX").string();
        if (::mkdtemp(name.data()) == nullptr)
            throw UserError(folder.string(), "write", "nothing can be written there",
                            std::generic_category().message(errno));
        path_ = name;
    }
    Staging(const Staging&) = delete;
    Staging& operator=(const Staging&) = delete;
    ~Staging() {
        std::error_code ignored;
        fs::remove_all(path_, ignored);
    }

    const fs::path& path() const { return path_; }
    void hand_over(const std::string& name) const {
        std::error_code error;
        fs::rename(path_ / name, folder_ / name, error);
        if (error)
            throw UserError((folder_ / name).string(), "write", "the file cannot be written",
                            error.message());
    }

  private:
    fs::path folder_, path_;
};

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

// Everything is written into a hidden folder first, so that a full disk or a kill leaves what was there. The
// old manifest goes before the first table is replaced, and the new one comes after the last: it never stands
// beside tables that it does not describe.
void write_table_files(const fs::path& folder, const Design& design, const Tables& tables,
                       const TableErrors& errors) {
    make_folder(folder);
    const std::vector<TablePicture> pictures = table_pictures(tables);
    const Staging staging(folder);
    for (const TablePicture& picture : pictures) write_picture(staging.path(), folder, picture);
    write_file_atomically(staging.path() / manifest_name, table_manifest(design, tables, pictures, errors));
    std::error_code error;
    fs::remove(folder / manifest_name, error);
    if (error)
        throw UserError((folder / manifest_name).string(), "write", "the file cannot be replaced",
                        error.message());
    for (const TablePicture& picture : pictures) staging.hand_over(picture.file);
    staging.hand_over(manifest_name);
}

}  // namespace nacre
