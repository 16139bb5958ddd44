#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "app/cli/bake_options.h"
#include "app/cli/design_input.h"
#include "app/cli/output.h"
#include "app/cli/verbs.h"
#include "core/design/design_check.h"
#include "core/formats/error_json.h"
#include "core/formats/table_files.h"
#include "core/shading/shader_variant.h"

namespace nacre::cli {
namespace {

struct InfoOptions {
    std::string design;
    bool json = false;
    BakeOptions bake = {};
};

struct LayerInfo {
    std::string name;
    std::string lobe;
    double share;  // of the facets' area
    bool modulated;
    dvec3 tint;
};

std::vector<LayerInfo> layers_of(const Design& design) {
    double whole = 0;
    for (const Layer& layer : design.distribution.layers) whole += layer.enabled ? layer.weight : 0;
    std::vector<LayerInfo> infos;
    for (const Layer& layer : design.distribution.layers)
        infos.push_back({one_line(layer.name), std::string(kind_name(layer.lobe)),
                         layer.enabled ? layer.weight / whole : 0, layer.modulation.has_value(), layer.tint});
    return infos;
}

template <class Variant>
std::string_view kind_name_of(int kind) {
    return KindSet<Variant>::names[static_cast<std::size_t>(kind)];
}

// How F is a table, if it is.
std::string curve_text(const Shading<double>& shading) {
    if (!shading.fresnel_curve) return "";
    const FresnelCurve& curve = *shading.fresnel_curve;
    return fmt::format(", a table of {} colours{}", curve.nodes,
                       curve.clipped > 5e-4 ? fmt::format(", clipped by up to {:.2g}", curve.clipped) : "");
}

// What the shader of these tables is made of.
std::vector<std::string> shader_parts(const Tables& tables) {
    const ShaderVariant variant = variant_of(tables.shading);
    const ShadingKinds& kinds = variant.kinds;
    std::vector<std::string> parts;
    for (const int lobe : variant.lobes) parts.push_back(fmt::format("lobe {}", kind_name_of<Lobe>(lobe)));
    if (variant.modulation) parts.emplace_back("modulation by a picture");
    if (kinds.tint == Tint::shared) parts.emplace_back("one tint of all layers");
    if (kinds.tint == Tint::varied) parts.emplace_back("a tint of each layer");
    if (kinds.coated()) parts.push_back(fmt::format("coat {}", kind_name_of<Coat>(kinds.coat)));
    if (kinds.retro)
        parts.push_back(fmt::format("retro-reflection, weight {:g}", tables.shading.surface.retro));
    parts.push_back(fmt::format("shadowing {}{}", kind_name_of<MaskingModel>(kinds.masking),
                                kinds.clamp ? ", clamped" : ""));
    if (kinds.fresnel != kind_index<Fresnel, NoFresnel>())
        parts.push_back(
            fmt::format("fresnel {}{}", kind_name_of<Fresnel>(kinds.fresnel), curve_text(tables.shading)));
    if (kinds.bounces())
        parts.push_back(fmt::format("multiple bounces {}", kind_name_of<Multibounce>(kinds.multibounce)));
    if (kinds.diffuse != kind_index<Diffuse, NoDiffuse>())
        parts.push_back(fmt::format("diffuse {}", kind_name_of<Diffuse>(kinds.diffuse)));
    parts.emplace_back("table of g");
    if (kinds.albedo) parts.emplace_back("tables of R");
    return parts;
}

// The pictures that hold tables or layers; the marked corners are for files alone.
std::vector<TablePicture> tables_in_use(const Tables& tables) {
    std::vector<TablePicture> pictures = table_pictures(tables);
    std::erase_if(pictures, [](const TablePicture& picture) { return picture.quantity == "corners"; });
    return pictures;
}

std::string name_of_table(const TablePicture& picture) {
    return picture.file.substr(0, picture.file.rfind('.'));
}

// The error that is claimed, and the worst that each size showed which was tried; the last but for a larger
// one that turned out no better was taken.
std::string size_reason(const char* quantity, const TableError& error, const std::vector<TriedSize>& tried) {
    std::vector<std::string> sizes;
    for (const TriedSize& size : tried)
        sizes.push_back(fmt::format("{} x {} with {:.1e}", size.nodes.polar, size.nodes.azimuth, size.worst));
    return fmt::format("  {}  worst {:.1e}, root mean square {:.1e}, {} directions; tried: {}\n", quantity,
                       error.worst, error.root_mean_square, error.directions, fmt::join(sizes, ", "));
}

std::string bounce_reason(const BounceFigures& bounces) {
    return fmt::format(
        "  bounces  {} walks{}\n", bounces.walks,
        bounces.misplaced ? fmt::format(", {:.2g} % of all energy misplaced", 100 * *bounces.misplaced) : "");
}

std::string facet_reason(const TableError& error) {
    return fmt::format("  facets  worst {:.1e}, root mean square {:.1e}, {} pairs of directions\n",
                       error.worst, error.root_mean_square, error.directions);
}

nlohmann::ordered_json bounce_json(const BounceFigures& bounces) {
    nlohmann::ordered_json json = {{"walks", bounces.walks}};
    if (bounces.misplaced) json["misplaced"] = *bounces.misplaced;
    return json;
}

nlohmann::ordered_json size_json(const TableError& error, const std::vector<TriedSize>& tried) {
    nlohmann::ordered_json sizes = nlohmann::ordered_json::array();
    for (const TriedSize& size : tried)
        sizes.push_back({{"nodes", {size.nodes.polar, size.nodes.azimuth}}, {"worst", size.worst}});
    nlohmann::ordered_json json = error_json(error);
    json["tried"] = std::move(sizes);
    return json;
}

std::string tint_text(dvec3 tint) {
    if (tint == dvec3{1}) return "";
    return fmt::format(", tint {:.4g} {:.4g} {:.4g}", tint.x, tint.y, tint.z);
}

std::string specular_text(const Specular& specular) {
    const std::string note = energy_note(specular.intensity);
    return fmt::format("\nspecular term\n  intensity {:g}{}\n", specular.intensity,
                       note.empty() ? "" : "  " + note);
}

std::string text_info(const Design& design, const Tables& tables) {
    const dvec3 mean = tables.mean;
    std::string text = fmt::format("{}\n", design.name.empty() ? "unnamed design" : one_line(design.name));
    if (!design.note.empty()) text += fmt::format("  {}\n", one_line(design.note));
    text += "\nlayers\n";
    for (const LayerInfo& layer : layers_of(design))
        text += fmt::format("  {:5.1f} %  {}{}{}{}\n", 100 * layer.share, layer.lobe,
                            layer.modulated ? ", modulated" : "", tint_text(layer.tint),
                            layer.name.empty() ? "" : "  " + layer.name);
    text += fmt::format(
        "\ndistribution\n  N         {:.6g}\n  H         {:.6g} {:.6g} {:.6g}\n  symmetry  {}\n",
        tables.shading.surface.N, mean.x, mean.y, mean.z, name_of(tables.needs.symmetry.symmetry));
    if (design.specular != Specular{}) text += specular_text(design.specular);
    text += "\ntables\n";
    for (const TablePicture& picture : tables_in_use(tables))
        text += fmt::format("  {:<20} {:>4} x {:<4} {:>8} bytes\n", name_of_table(picture), picture.size.x,
                            picture.size.y, picture.values.size() * sizeof(float));
    text += fmt::format("  {} bytes in all, baked in {:.3f} s\n", tables.table_floats() * sizeof(float),
                        tables.seconds);
    text += fmt::format("\nsizes, for errors within {:.1e}\n", tables.tolerance);
    text += size_reason("g", tables.errors.area, tables.tried_area);
    if (tables.needs.albedo) text += size_reason("R", tables.errors.albedo, tables.tried_albedo);
    if (tables.bounces) text += bounce_reason(*tables.bounces);
    if (tables.shading.kinds.matt_facets()) text += facet_reason(tables.errors.facets);
    text += fmt::format("\nshader\n  {}\n\nleft out\n", fmt::join(shader_parts(tables), "\n  "));
    for (const Omission& omission : tables.omissions)
        text += fmt::format("  {}: {}\n", omission.what, omission.why);
    return text;
}

std::string json_info(const Design& design, const Tables& tables) {
    using Json = nlohmann::ordered_json;
    Json layers = Json::array(), pictures = Json::array(), omissions = Json::array();
    for (const LayerInfo& layer : layers_of(design))
        layers.push_back({{"name", layer.name},
                          {"lobe", layer.lobe},
                          {"share", layer.share},
                          {"modulated", layer.modulated},
                          {"tint", {layer.tint.x, layer.tint.y, layer.tint.z}}});
    for (const TablePicture& picture : tables_in_use(tables))
        pictures.push_back({{"name", name_of_table(picture)},
                            {"width", picture.size.x},
                            {"height", picture.size.y},
                            {"channels", picture.channels.size()},
                            {"bytes", picture.values.size() * sizeof(float)}});
    for (const Omission& omission : tables.omissions)
        omissions.push_back({{"what", omission.what}, {"why", omission.why}});
    Json json = {{"name", design.name},
                 {"note", design.note},
                 {"layers", std::move(layers)},
                 {"N", tables.shading.surface.N},
                 {"H", {tables.mean.x, tables.mean.y, tables.mean.z}},
                 {"symmetry", name_of(tables.needs.symmetry.symmetry)},
                 {"specular_intensity", design.specular.intensity},
                 {"retro_weight", design.retro.weight},
                 {"creates_energy", !energy_note(design.specular.intensity).empty()},
                 {"tables", std::move(pictures)},
                 {"bake_seconds", tables.seconds},
                 {"table_bytes", tables.table_floats() * sizeof(float)},
                 {"tolerance", tables.tolerance},
                 {"g", size_json(tables.errors.area, tables.tried_area)},
                 {"R", size_json(tables.errors.albedo, tables.tried_albedo)},
                 {"shader", shader_parts(tables)},
                 {"left_out", std::move(omissions)}};
    if (tables.bounces) json["bounces"] = bounce_json(*tables.bounces);
    if (tables.shading.kinds.matt_facets()) json["facets"] = error_json(tables.errors.facets);
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

int info(const InfoOptions& options, const Interrupt& interrupt) {
    const Design design = read_design(options.design);
    const auto tables = bake_design(design, options.design, options.bake, interrupt);
    write_output(options.json ? json_info(design, *tables) : text_info(design, *tables));
    return 0;
}

void declare(Command& command, Action& action) {
    const auto options = std::make_shared<InfoOptions>();
    command.option("DESIGN", options->design, "a .nacre file; - is standard input").required();
    add_tolerance_option(command, options->bake);
    command.flag("--json", options->json, "the same as JSON");
    command.when_chosen([options, &action] {
        action = [options](Interrupt& interrupt) { return info(*options, interrupt); };
    });
}

}  // namespace

const Verb info_verb{"info", "what a design is, what it needs and what it can do without", declare};

}  // namespace nacre::cli
