#include "core/exchange/table_manifest.h"

#include <fmt/core.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "core/design/design_names.h"
#include "core/exchange/error_json.h"

namespace nacre {
namespace {

using Json = nlohmann::ordered_json;
using Shader = Shading<double>;

Json numbers(dvec2 v) { return Json::array({v.x, v.y}); }
Json numbers(dvec3 v) { return Json::array({v.x, v.y, v.z}); }

// What each lobe is at h = (x, y, z) of its own frame, 0 where z <= 0 unless said otherwise; (i, j) is
// inverse_width.                                                        (shaders/shared/lobes.glsl)
const char* lobe_formula(int kind) {
    switch (kind) {
        case Shader::LOBE_GAUSSIAN:
            return "exp(-((x i/z)^2 + (y j/z)^2))";
        case Shader::LOBE_INVERSE_GAUSSIAN:
            return "exp(-(z i)^2/(x^2 + y^2)), 0 at x = y = 0";
        case Shader::LOBE_GGX:
            return "1/((x i)^2 + (y j)^2 + z^2)^2";
        case Shader::LOBE_BECKMANN:
            return "exp(-((x i/z)^2 + (y j/z)^2))/z^4";
        case Shader::LOBE_HEMISPHERE:
            return "1";
        case Shader::LOBE_SPHERE:
            return "1, also where z <= 0";
        case Shader::LOBE_CURVE:
            return "straight lines through `curve` over theta = acos(z), also where z <= 0; 0 outside it";
        default:
            return "`picture`";
    }
}

Json layer_json(const Tables& tables, int index) {
    const Shader::Layer& layer = tables.shading.layers[index];
    static constexpr const char* kinds[] = {"gaussian",   "inverse_gaussian", "ggx",   "beckmann",
                                            "hemisphere", "sphere",           "curve", "painted"};
    Json json = {{"kind", kinds[layer.kind]},
                 {"lobe", lobe_formula(layer.kind)},
                 {"scale", layer.scale},
                 {"axis_x", numbers(layer.axis_x)},
                 {"axis_y", numbers(layer.axis_y)},
                 {"axis_z", numbers(layer.axis_z)},
                 {"inverse_width", numbers(layer.inverse_width)}};
    if (layer.kind == Shader::LOBE_CURVE) {
        Json curve = Json::array();
        for (int i = 0; i < layer.data_size; ++i) {
            const auto at = static_cast<std::size_t>(layer.data_offset + 2 * i);
            curve.push_back({tables.data[at], tables.data[at + 1]});
        }
        json["curve"] = std::move(curve);
    }
    if (layer.kind == Shader::LOBE_PAINTED) json["picture"] = layer_picture_file(index, "painted");
    if (layer.picture_size > 0) {
        json["modulation"] = layer_picture_file(index, "modulation");
        json["modulation_strength"] = layer.picture_strength;
    }
    return json;
}

Json distribution_json(const Tables& tables) {
    Json layers = Json::array();
    for (int i = 0; i < tables.shading.layer_count; ++i) layers.push_back(layer_json(tables, i));
    return {{"p",
             "density of facet normals h on the sphere, 1/sr, integral 1: the sum over the layers of scale * "
             "lobe"},
            {"own_frame", "h in a layer's frame is (h.axis_x, h.axis_y, h.axis_z); theta in radians"},
            {"pictures",
             "side x side texels, the upper hemisphere seen from above: column = side (1 + x/sqrt(1+z))/2 - "
             "1/2, row = "
             "side (1 - y/sqrt(1+z))/2 - 1/2, both kept in [0, side-1], bilinear; row 0 is the first scan "
             "line; 0 "
             "where z <= 0"},
            {"modulation", "the lobe times 1 - modulation_strength + modulation_strength * picture"},
            {"layers", std::move(layers)}};
}

const char* fold_rule(Symmetry symmetry) {
    switch (symmetry) {
        case Symmetry::isotropic:
            return "x' and y' as they are; psi = rho = 0 everywhere";
        case Symmetry::quarter:
            return "replace x' by |x'| and y' by |y'|";
        case Symmetry::half:
            return "replace y' by |y'|";
        case Symmetry::none:
            return "x' and y' as they are";
    }
    return "";
}

const char* row_rule(Symmetry symmetry) {
    switch (symmetry) {
        case Symmetry::isotropic:
            return "there is but row 0";
        case Symmetry::quarter:
            return "row j stands at j/(n-1)";
        case Symmetry::half:
            return "row j stands at j/(n-1) * 2";
        case Symmetry::none:
            return "row j stands at j/n * 4; row n is row 0 again";
    }
    return "";
}

Json evaluation_json(const Tables& tables) {
    const Symmetry symmetry = tables.plan.symmetry.symmetry;
    Json steps = {
        "k = (x, y, z): unit vector away from the surface, z = k.normal >= 0, x = k.tangent, y = k.bitangent",
        "x' = axis[0] x + axis[1] y; y' = axis[0] y - axis[1] x",
        fmt::format("fold: {}", fold_rule(symmetry)),
        "r = sqrt(x'^2 + y'^2); psi = turns(stretch[0] (x' + lean r), stretch[1] y' sqrt(1 - lean^2))",
        "turns(a, b), an azimuth in quarter turns: t = (|b| - |a|)/(|a| + |b|), -1 at 0/0; u = 1/2 + t (6 - "
        "t^2)/10; "
        "2 - u in its place where a < 0; then 4 minus it where b < 0",
        "q = sqrt((stretch[0] x')^2 + (stretch[1] y')^2)",
        "w = 2 q/(z g_normal + 2 q); 0 where the denominator is 0",
        "g = max(0, x moment[0] + y moment[1] + (z g_normal + 2 q) A(w, psi))",
        "P = N z/g; with clamp P = min(1, N z/g)"};
    if (tables.plan.albedo) {
        steps.push_back("s = sqrt(x^2 + y^2); v = (w + s/(z + s))/2; rho = (psi + turns(x', y'))/2");
        steps.push_back("kept = min(1, g/(N z)) with clamp (1 at z = 0), 1 without");
        steps.push_back(
            "R1 = max(0, albedo(v, rho)) kept: the directional albedo of the specular term with F = 1");
        if (tables.plan.fresnel_tables > 0)
            steps.push_back(
                "R0 = max(0, F0 max(0, albedo(v, rho)) + residual(v, rho)) kept, F0 = `fresnel_at_n`");
        steps.push_back("R, the design's own albedo, is `albedo_of_design`");
    }
    return steps;
}

// What R0 and R mean with each Fresnel model.
void add_fresnel_rules(const Tables& tables, Json& json) {
    switch (tables.shading.kinds.fresnel) {
        case FresnelKind::none:
            json["albedo_of_design"] = "R = R1";
            break;
        case FresnelKind::schlick:
            json["fresnel_at_n"] = "(1 - z)^5";
            json["albedo_of_design"] = "R = f0 R1 + (1 - f0) R0";
            break;
        case FresnelKind::dielectric:
        case FresnelKind::conductor:
            json["fresnel_at_n"] = "the exact F at the cosine z, each colour";
            json["albedo_of_design"] = "R = R0, each colour";
            break;
    }
}

Json material_json(const Design& design, const Tables& tables) {
    const Shader& shading = tables.shading;
    const auto& surface = shading.surface;
    Json json = {{"fresnel", fresnel_names[design.fresnel.index()]}};
    if (shading.kinds.fresnel == FresnelKind::schlick) json["f0"] = numbers(surface.f0);
    if (shading.kinds.fresnel == FresnelKind::dielectric) json["ior"] = surface.eta.x;
    if (shading.kinds.fresnel == FresnelKind::conductor) {
        json["eta"] = numbers(surface.eta);
        json["k"] = numbers(surface.kappa);
    }
    json["shadowing"] = shadowing_names[static_cast<std::size_t>(design.shadowing.model)];
    if (shading.kinds.visibility == VisibilityKind::correlated)
        json["correlation_width_degrees"] = surface.correlation * (180 / std::numbers::pi);
    json["clamp"] = shading.kinds.clamp;
    json["diffuse"] = diffuse_names[design.diffuse.index()];
    if (shading.kinds.diffuse == DiffuseKind::lambertian) {
        json["kd"] = surface.kd;
        json["ks"] = surface.ks;
    }
    if (shading.kinds.diffuse != DiffuseKind::none) json["diffuse_albedo"] = numbers(surface.albedo);
    if (tables.plan.albedo) json["coupling"] = numbers(surface.coupling);
    return json;
}

const char* visibility_rule(VisibilityKind kind) {
    switch (kind) {
        case VisibilityKind::uncorrelated:
            return "V = N/(G1 G2)";
        case VisibilityKind::correlated:
            return "V = (1-t) N/(G1 G2) + t/max(G1 z2, G2 z1), t = exp(-(d/correlation_width)^2/2), d = the "
                   "angle between the "
                   "directions' projections onto the surface";
        case VisibilityKind::smith_correlated:
            return "V = N/(G1 G2)/(p1 + p2 - p1 p2), p = min(1, N z/G)";
    }
    return "";
}

const char* diffuse_rule(DiffuseKind kind) {
    switch (kind) {
        case DiffuseKind::none:
            return "rho = specular";
        case DiffuseKind::lambertian:
            return "rho = ks specular + kd diffuse_albedo/pi";
        case DiffuseKind::coupled:
            return "rho = specular + coupling diffuse_albedo (1 - R(k1)) (1 - R(k2))";
        case DiffuseKind::metal:
            return "rho = specular + coupling diffuse_albedo (f - R(k1))+ (f - R(k2))+, f = diffuse_albedo";
    }
    return "";
}

Json brdf_json(const Tables& tables) {
    return {
        "1/sr; k1 toward the light, k2 toward the viewer, h = (k1 + k2)/|k1 + k2|, 0 where z1 <= 0 or z2 <= "
        "0",
        "G = max(g, N z) with clamp, G = g without", visibility_rule(tables.shading.kinds.visibility),
        "specular = p(h) F(k1.h) V/4", diffuse_rule(tables.shading.kinds.diffuse)};
}

Json pictures_json(const std::vector<TablePicture>& pictures) {
    Json list = Json::array();
    for (const TablePicture& picture : pictures) {
        Json json = {{"file", picture.file},     {"quantity", picture.quantity}, {"width", picture.size.x},
                     {"height", picture.size.y}, {"channels", picture.channels}, {"x", picture.x}};
        json["y"] = picture.y;
        list.push_back(std::move(json));
    }
    return list;
}

}  // namespace

std::string layer_picture_file(int layer, const std::string& kind) {
    return fmt::format("layer-{}-{}.exr", layer + 1, kind);
}

std::string table_manifest(const Design& design, const Tables& tables,
                           const std::vector<TablePicture>& pictures, const TableErrors& errors) {
    const auto& surface = tables.shading.surface;
    const auto& shape = surface.tables;
    const Symmetry symmetry = tables.plan.symmetry.symmetry;
    Json json = {{"format", "nacre tables"}, {"version", 1}, {"name", design.name}, {"note", design.note}};
    json["constants"] = {{"N", surface.N},
                         {"g_normal", shape.g_normal},
                         {"moment", numbers(shape.moment)},
                         {"axis", numbers(shape.axis)},
                         {"stretch", numbers(shape.stretch)},
                         {"lean", shape.lean},
                         {"mean_normal", numbers(tables.mean)},
                         {"mean_albedo", tables.mean_albedo}};
    json["material"] = material_json(design, tables);
    json["distribution"] = distribution_json(tables);
    json["symmetry"] = name_of(symmetry);
    json["evaluate"] = evaluation_json(tables);
    if (tables.plan.albedo) add_fresnel_rules(tables, json);
    json["brdf"] = brdf_json(tables);
    json["tables"] = pictures_json(pictures);
    json["texels"] = {
        {"w, v", "column i of n stands at i/(n-1): texels on both ends, not at centres"},
        {"psi, rho", row_rule(symmetry)},
        {"between",
         "linear in both; no mipmaps, no sRGB, no 8 bit; clamp to the edge but where row n is row 0"},
        {"orientation",
         "row 0 (psi = 0 or rho = 0) is the first scan line of the file, column 0 its leftmost texel. "
         "corners.exr holds "
         "1 in the first line's first texel, 2 in its last, 3 and 4 in the last line's first and last"}};
    json["units"] =
        "g, q: areas per area of facets; A, R and P: parts of 1; psi and rho in quarter turns, other "
        "angles in radians unless said; colours "
        "linear Rec. 709";
    json["error"] = {{"g", error_json(errors.area)},
                     {"g_is", "|g - exact|/max(exact, N z (clamp), q/20)"},
                     {"R", error_json(errors.albedo)},
                     {"R_is", "|R - exact|"},
                     {"tolerance", tables.tolerance},
                     {"by_the_bake", errors_json(tables.errors)},
                     {"against", "adaptive integration in double"}};
    json["bake_seconds"] = tables.seconds;
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace nacre
