#include "core/formats/table_manifest.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "core/design/design_check.h"
#include "core/formats/coat_manifest.h"
#include "core/formats/distribution_json.h"
#include "core/formats/error_json.h"
#include "core/formats/json_numbers.h"
#include "core/formats/material_json.h"

namespace nacre {
namespace {

using Json = nlohmann::ordered_json;

const char* fold_rule(Symmetry symmetry) {
    switch (symmetry) {
        case Symmetry::quarter:
            return "x' = abs(x'); y' = abs(y')";
        case Symmetry::half:
            return "y' = abs(y')";
        case Symmetry::isotropic:
        case Symmetry::none:
            return "x' = x'; y' = y'";
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

// What light meets that bounces on; see shaders/shared/multibounce.glsl.
void add_bounce_steps(const Design& design, const Tables& tables, Json& steps) {
    const ShadingKinds& kinds = tables.shading.kinds;
    const bool varied = kinds.tint == Tint::varied, fitted = tables.bounces->fitted;
    const char* const tint = kinds.tint == Tint::shared ? "tint " : "";
    const auto with_factor = [&](const char* one, const char* factor) {
        if (kinds.bounce_factors() == 0) return fmt::format("{}{}", tint, one);
        if (kinds.bounce_factors() == 3) return fmt::format("{}{}(v, rho)", tint, factor);
        return fmt::format("{}(f0 {} + (1 - f0) {}(v, rho))", tint, one, factor);
    };
    steps.push_back(varied ? "E = max(0, whole(v, rho)) kept" : "E = R1");
    steps.push_back(std::visit([]<class T>(const T&) { return T::rest_formula; }, design.multibounce));
    steps.push_back(
        fmt::format("Fb = {}: the mean Fresnel factor of light that bounces on", with_factor("1", "factor")));
    const std::string spread = fitted ? fmt::format("a {} + ", with_factor("brought(v, rho)", "spread")) : "";
    steps.push_back(
        fmt::format("RM = Fb bounce_scale ({}bounce_mean e): the albedo of what bounces bring", spread));
    if (fitted)
        steps.push_back(
            "amplitude(x, y), sum(t) and difference(t): of t = (x, y, z), each its table at x' = axis[0] x + "
            "axis[1] y, "
            "y' = axis[0] y - axis[1] x, whose texels lie evenly in what its `x` and `y` say");
}

// How classes of terms differ; see shaders/shared/matt_facets.glsl.
const char* facet_rule(Symmetry symmetry) {
    switch (symmetry) {
        case Symmetry::isotropic:
            return "s_0 is 1 and s_c is cos(c d), d the angle in azimuth from a to b";
        case Symmetry::quarter:
            return "s_0 is 1; s_1 is -1 where y' (not folded) of a and of b have different signs, else 1; "
                   "s_2 is the "
                   "same of x'; s_3 is s_1 s_2";
        case Symmetry::half:
            return "s_0 is 1; s_1 is -1 where y' (not folded) of a and of b have different signs, else 1";
        case Symmetry::none:
            return "there is but class 0, and s_0 is 1";
    }
    return "";
}

// What matt facets show of each other.
void add_facet_steps(Symmetry symmetry, bool clamp, Json& steps) {
    steps.push_back(clamp ? "K = sqrt(max(g, N z)^2 + (z g_normal + 2 q)^2/64)"
                          : "K = sqrt(g^2 + (z g_normal + 2 q)^2/64)");
    steps.push_back("Ef = max(0, min(1, facet_albedo(w, psi)))");
    steps.push_back(
        fmt::format("facets(a, b): the larger of 0 and the sum over classes c of s_c times the sum over i of "
                    "u(a) u(b), u being "
                    "that of term c facet_terms + i at (w, psi), whose table begins in the row of that "
                    "number times the rows of "
                    "facet-albedo.exr; {}",
                    facet_rule(symmetry)));
}

Json evaluation_json(const Design& design, const Tables& tables) {
    const Symmetry symmetry = tables.needs.symmetry.symmetry;
    const bool clamp = design.shadowing.clamp, round = symmetry == Symmetry::isotropic;
    Json steps = {
        "k = (x, y, z): unit vector away from the surface, z = k.normal >= 0, x = k.tangent, y = k.bitangent",
        "x' = axis[0] x + axis[1] y; y' = axis[0] y - axis[1] x",
        fold_rule(symmetry),
        round
            ? "psi = 0"
            : "r = sqrt(x'^2 + y'^2); psi = turns(stretch[0] (x' + lean r), stretch[1] y' sqrt(1 - lean^2))",
        "turns(a, b), an azimuth in quarter turns: t = (|b| - |a|)/(|a| + |b|), -1 at 0/0; u = 1/2 + t (6 - "
        "t^2)/10; "
        "2 - u in its place where a < 0; then 4 minus it where b < 0",
        "q = sqrt((stretch[0] x')^2 + (stretch[1] y')^2)",
        "w = 2 q/(z g_normal + 2 q): 0 where the denominator is 0",
        "g = max(0, x moment[0] + y moment[1] + (z g_normal + 2 q) A(w, psi))",
        clamp ? "P = min(1, N z/g)" : "P = N z/g"};
    if (tables.shading.kinds.matt_facets()) add_facet_steps(symmetry, clamp, steps);
    if (tables.needs.albedo) {
        steps.push_back(fmt::format("s = sqrt(x^2 + y^2); v = (w + s/(z + s))/2; rho = {}",
                                    round ? "0" : "(psi + turns(x', y'))/2"));
        steps.push_back(clamp ? "kept = min(1, g/(N z)): 1 at z = 0" : "kept = 1");
        steps.push_back(
            "R1 = max(0, albedo(v, rho)) kept: the directional albedo of the specular term with F = 1");
        if (tables.needs.fresnel_tables > 0)
            steps.push_back(
                "R0 = max(0, F0 max(0, albedo(v, rho)) + residual(v, rho)) kept: F0 is `fresnel_at_n`");
        if (tables.bounces) add_bounce_steps(design, tables, steps);
        steps.push_back("R, the design's own albedo, is `albedo_of_design`");
    }
    return steps;
}

// What R0 and R mean with each Fresnel model.
void add_fresnel_rules(const Tables& tables, Json& json) {
    const bool shared = tables.needs.tint == Tint::shared;
    switch (tables.shading.kinds.fresnel_tables()) {
        case FresnelTables::none:
            json["albedo_of_design"] = shared ? "R = tint R1" : "R = R1";
            break;
        case FresnelTables::linear:
            json["fresnel_at_n"] = "F0 = (1 - z)^5";
            json["albedo_of_design"] = shared ? "R = tint (f0 R1 + (1 - f0) R0)" : "R = f0 R1 + (1 - f0) R0";
            break;
        case FresnelTables::exact:
            json["fresnel_at_n"] = "F0 = F(z): the F of `brdf` at c = z, each colour";
            json["albedo_of_design"] = shared ? "R = tint R0: each colour" : "R = R0: each colour";
            break;
    }
    if (!tables.bounces) return;
    std::string rule = json["albedo_of_design"];
    rule.insert(std::min(rule.find(':'), rule.size()), " + RM");
    json["albedo_of_design"] = rule;
}

template <class Variant>
const char* formula_of(const Variant& model) {
    return std::visit([]<class T>(const T&) { return T::formula; }, model);
}

std::string specular_formula(const Design& design, Tint tint) {
    const char* const intensity = has_intensity(design) ? "specular_intensity " : "";
    std::string mirrored =
        fmt::format("{}{}(h) F V/4", tint == Tint::shared ? "tint " : "", tint == Tint::varied ? "q" : "p");
    const bool bounces = has_bounces(design.multibounce);
    if (bounces) mirrored += " + Fb1 Fb2 bounce_scale M";
    if (!is_retro(design))
        return bounces ? fmt::format("specular = {}({})", intensity, mirrored)
                       : fmt::format("specular = {}{}", intensity, mirrored);
    return fmt::format(
        "m = {}; specular = {}((1 - retro) m + 0.5 retro (mirrored(k1, T(k2)) + mirrored(T(k1), k2))): "
        "mirrored(a, b) is m of k1 = a and k2 = b; T(k) = (-x, -y, z)",
        mirrored, intensity);
}

Json brdf_json(const Design& design, Tint tint) {
    Json steps = {
        "h = normalize(k1 + k2); c = dot(k1, h): k1 toward the light, k2 toward the viewer; rho, 1/sr, is 0 "
        "where "
        "z1 <= 0 or z2 <= 0",
        design.shadowing.clamp ? "G1 = max(g1, N z1); G2 = max(g2, N z2)" : "G1 = g1; G2 = g2",
        formula_of(design.shadowing.model), formula_of(design.fresnel)};
    if (has_bounces(design.multibounce)) steps.push_back(formula_of(design.multibounce));
    steps.push_back(specular_formula(design, tint));
    steps.push_back(formula_of(design.diffuse));
    return steps;
}

Json pictures_json(const std::vector<TablePicture>& pictures) {
    Json list = Json::array();
    for (const TablePicture& picture : pictures) {
        list.push_back({{"file", picture.file},
                        {"quantity", picture.quantity},
                        {"width", picture.size.x},
                        {"height", picture.size.y},
                        {"channels", picture.channels},
                        {"x", picture.x},
                        {"y", picture.y}});
    }
    return list;
}

Json constants_json(const Tables& tables) {
    const auto& surface = tables.shading.surface;
    const auto& shape = surface.tables;
    Json json = {{"N", surface.N},
                 {"g_normal", shape.g_normal},
                 {"moment", json_numbers(shape.moment)},
                 {"axis", json_numbers(shape.axis)},
                 {"stretch", json_numbers(shape.stretch)},
                 {"lean", shape.lean},
                 {"mean_normal", json_numbers(tables.mean)},
                 {"mean_albedo", tables.mean_albedo.x}};
    if (tables.needs.tint == Tint::varied) json["mean_albedo"] = json_numbers(tables.mean_albedo);
    if (tables.bounces) {
        json["bounce_scale"] = json_numbers(surface.bounce_scale);
        json["bounce_mean"] = json_numbers(surface.bounce_mean);
        json["bounce_even"] = surface.bounce_even;
    }
    if (tables.shading.kinds.matt_facets()) {
        json["facet_classes"] = shape.facet_classes;
        json["facet_terms"] = shape.facet_terms;
        json["facet_scale"] = json_numbers(surface.facet_scale);
        json["facet_even"] = surface.facet_even;
    }
    return json;
}

}  // namespace

std::string layer_picture_file(int layer, const std::string& kind) {
    return fmt::format("layer-{}-{}.exr", layer + 1, kind);
}

std::string table_manifest(const Design& design, const Tables& tables,
                           const std::vector<TablePicture>& pictures, const TableErrors& errors) {
    const Symmetry symmetry = tables.needs.symmetry.symmetry;
    Json json = {{"format", "nacre tables"}, {"version", 1}, {"name", design.name}, {"note", design.note}};
    json["constants"] = constants_json(tables);
    json["material"] = material_json(design, tables);
    json["distribution"] = distribution_json(design, tables);
    json["symmetry"] = name_of(symmetry);
    if (const std::string note = energy_note(design.specular.intensity); !note.empty())
        json["validity"] = note;
    json["evaluate"] = evaluation_json(design, tables);
    if (tables.needs.albedo) add_fresnel_rules(tables, json);
    json["brdf"] = brdf_json(design, tables.needs.tint);
    if (tables.needs.albedo && is_retro(design))
        json["albedo_in_brdf"] =
            "(1 - 0.5 retro) R(k) + 0.5 retro R(T(k)): what R(k) is in `brdf`, of R(k) as above; T(k) = (-x, "
            "-y, z)";
    if (is_coated(design.coat)) json["coat"] = coat_json(design, tables);
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
                     {"g_is", "|G - exact G|/max(exact G, q/20)"},
                     {"R", error_json(errors.albedo)},
                     {"R_is", "|R - exact|"},
                     {"tolerance", tables.tolerance},
                     {"by_the_bake", errors_json(tables.errors)},
                     {"against", "adaptive integration in double"}};
    if (tables.bounces && tables.bounces->misplaced) {
        json["error"]["bounces"] = *tables.bounces->misplaced;
        json["error"]["bounces_is"] =
            "the part of all energy that goes to another place than random walks send it";
    }
    if (tables.shading.kinds.matt_facets())
        json["error"]["facets_is"] = "|facets - exact N Q/(K1 K2)|, Q the integral of (k1.h)+ (k2.h)+ p(h)";
    json["bake_seconds"] = tables.seconds;
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace nacre
