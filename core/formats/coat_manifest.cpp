#include "core/formats/coat_manifest.h"

#include "core/formats/json_numbers.h"

namespace nacre {
namespace {

using Json = nlohmann::ordered_json;

// Three tables of one quantity lie one after the other in the data and side by side in a pixel.
TablePicture colour_picture(const Tables& tables, const char* quantity, int offset) {
    const auto& shape = tables.shading.surface.tables;
    const int size = shape.coat_nodes * shape.coat_rows;
    TablePicture picture{std::string("coat-") + quantity + ".exr",
                         std::string("coat_") + quantity,
                         "root",
                         "rho",
                         {shape.coat_nodes, shape.coat_rows},
                         {"R", "G", "B"},
                         {}};
    for (int i = 0; i < size; ++i)
        for (int c = 0; c < 3; ++c)
            picture.values.push_back(tables.data[static_cast<std::size_t>(offset + c * size + i)]);
    return picture;
}

}  // namespace

Json coat_json(const Design& design, const Tables& tables) {
    const auto text = [&](const auto& of) { return std::visit(of, design.coat); };
    Json json;
    json["constants"] = {{"coat_depth", json_numbers(tables.shading.surface.coat_depth)},
                         {"coat_even", json_numbers(tables.shading.surface.coat_even)}};
    json["inside"] = {
        "xi = x/coat_ior; yi = y/coat_ior; zi = sqrt(1 - xi^2 - yi^2): k' = (xi, yi, zi), k refracted at the "
        "coat. "
        "`evaluate` and `brdf` are of k1' and k2': what their rho is without the coat is rho_b here"};
    json["evaluate"] = {
        "root = sqrt(z)",
        "Rc = max(0, min(1, coat_albedo(root, 0)))",
        "t = (1 - Rc) exp((-1) coat_depth/zi): each colour",
        "u = max(0, coat_whole(root, rho)); b = max(0, coat_inner(root, rho)): rho is that of k'",
        text([]<class T>(const T&) { return T::area_formula; }),
        "A = Rc + t u: the albedo of the whole"};
    json["brdf"] = {
        "c = dot(k1, normalize(k1 + k2)); hz = dot(n, normalize(k1 + k2)): k1 and k2 themselves, n = (0, 0, "
        "1)",
        text([]<class T>(const T&) { return T::formula; }),
        "root = sqrt(max(0, coat_ior^2 - 1 + c^2)); rs = (c - root)/(c + root); "
        "rp = (coat_ior^2 c - root)/(coat_ior^2 c + root); Fc = (rs^2 + rp^2)/2",
        "rho = D Fc/(4 gc1 gc2) + (t1 t2 (rho_b + b1 b2 coat_even))/coat_ior^2: each colour"};
    return json;
}

void add_coat_pictures(const Tables& tables, std::vector<TablePicture>& pictures) {
    const auto& shape = tables.shading.surface.tables;
    const auto begin = tables.data.begin() + shape.coat_offset;
    pictures.push_back({"coat-albedo.exr",
                        "coat_albedo",
                        "root",
                        "",
                        {shape.coat_albedo_nodes, 1},
                        {"Y"},
                        {begin, begin + shape.coat_albedo_nodes}});
    const int size = 3 * shape.coat_nodes * shape.coat_rows,
              inside = shape.coat_offset + shape.coat_albedo_nodes;
    pictures.push_back(colour_picture(tables, "whole", inside));
    pictures.push_back(colour_picture(tables, "inner", inside + size));
}

}  // namespace nacre
