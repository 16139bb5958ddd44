#include <fmt/core.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "core/design/design_check.h"
#include "core/design/design_file.h"
#include "core/design/design_names.h"
#include "core/design/error.h"
#include "core/design/json_reader.h"
#include "core/design/json_text.h"
#include "core/design/layer_read.h"
#include "core/exchange/input_file.h"

namespace nacre {
namespace {

namespace fs = std::filesystem;

void check_version(ObjectReader& reader) {
    const std::string meaning = fmt::format("the version of the format, {}", design_version);
    const JsonValue version = reader.required("nacre", meaning);
    if (version.whole_number(1, std::numeric_limits<int>::max()) > design_version)
        version.fail(fmt::format("this program reads version {} of the format", design_version));
}

Distribution read_distribution(const JsonValue& json, const fs::path& base_dir) {
    ObjectReader reader(json);
    Distribution distribution;
    reader.number("mean_cosine_scale", distribution.mean_cosine_scale,
                  {limits::mean_cosine_scale_min, limits::mean_cosine_scale_max});
    const bool has_layers = reader.has("layers");
    reader.finish("the distribution");
    if (!has_layers) return distribution;
    const JsonValue layers = reader.at("layers");
    const std::string expected = fmt::format("must be a list of 1 to {} layers", limits::layers_max);
    const std::vector<JsonValue> elements = layers.elements(expected);
    if (elements.empty() || elements.size() > std::size_t{limits::layers_max}) layers.fail(expected);
    distribution.layers.clear();
    for (const JsonValue& layer : elements) distribution.layers.push_back(read_layer(layer, base_dir));
    return distribution;
}

Shadowing read_shadowing(const JsonValue& json) {
    ObjectReader reader(json);
    Shadowing shadowing;
    const std::size_t model = reader.choice("model", shadowing_names, 0);
    shadowing.model = static_cast<ShadowingModel>(model);
    if (shadowing.model == ShadowingModel::correlated)
        reader.number("width", shadowing.width, {limits::correlation_min, limits::correlation_max});
    reader.flag("clamp", shadowing.clamp);
    reader.finish(fmt::format("the shadowing model \"{}\"", shadowing_names[model]));
    return shadowing;
}

Fresnel read_fresnel(const JsonValue& json) {
    const Fresnel models[] = {SchlickFresnel{}, DielectricFresnel{}, ConductorFresnel{}, NoFresnel{}};
    static_assert(std::size(models) == std::variant_size_v<Fresnel>);
    ObjectReader reader(json);
    const std::size_t model = reader.choice("model", fresnel_names, 0);
    Fresnel fresnel = models[model];
    if (auto* const schlick = std::get_if<SchlickFresnel>(&fresnel)) {
        reader.colour("f0", schlick->f0, {0, 1});
    } else if (auto* const dielectric = std::get_if<DielectricFresnel>(&fresnel)) {
        reader.number("ior", dielectric->ior, {limits::ior_min, limits::ior_max});
    } else if (auto* const conductor = std::get_if<ConductorFresnel>(&fresnel)) {
        reader.colour("eta", conductor->eta, {limits::eta_min, limits::eta_max});
        reader.colour("k", conductor->k, {0, limits::k_max});
    }
    reader.finish(fmt::format("the Fresnel model \"{}\"", fresnel_names[model]));
    return fresnel;
}

Diffuse read_diffuse(const JsonValue& json) {
    const Diffuse models[] = {NoDiffuse{}, LambertianDiffuse{}, CoupledDiffuse{}, MetalDiffuse{}};
    static_assert(std::size(models) == std::variant_size_v<Diffuse>);
    ObjectReader reader(json);
    if (reader.has("model") && reader.at("model").is_text() && reader.at("model").text() == "facets")
        reader.at("model").fail("facets with a BRDF of their own have not arrived yet");
    const std::size_t model = reader.choice("model", diffuse_names, 0);
    Diffuse diffuse = models[model];
    if (auto* const lambertian = std::get_if<LambertianDiffuse>(&diffuse)) {
        reader.number("kd", lambertian->kd, {0, 1});
        reader.number("ks", lambertian->ks, {0, 1});
        reader.colour("albedo", lambertian->albedo, {0, 1});
    } else if (auto* const coupled = std::get_if<CoupledDiffuse>(&diffuse)) {
        reader.colour("albedo", coupled->albedo, {0, 1});
    }
    reader.finish(fmt::format("the diffuse model \"{}\"", diffuse_names[model]));
    return diffuse;
}

}  // namespace

Design parse_work(std::string_view json_text, const std::string& file_name_for_errors,
                  const fs::path& base_dir) {
    const JsonTree tree = parse_json(json_text, file_name_for_errors);
    ObjectReader reader(JsonValue(tree.root(), "", file_name_for_errors));
    check_version(reader);
    Design design;
    reader.text("name", design.name);
    reader.text("note", design.note);
    const bool has_distribution = reader.has("distribution");
    if (reader.has("shadowing")) design.shadowing = read_shadowing(reader.at("shadowing"));
    if (reader.has("fresnel")) design.fresnel = read_fresnel(reader.at("fresnel"));
    if (reader.has("diffuse")) design.diffuse = read_diffuse(reader.at("diffuse"));
    reader.finish("a design");
    if (has_distribution)
        design.distribution = read_distribution(reader.at("distribution"), absolute_folder(base_dir));
    return design;
}

Design parse_design(std::string_view json_text, const std::string& file_name_for_errors,
                    const fs::path& base_dir) {
    Design design = parse_work(json_text, file_name_for_errors, base_dir);
    check_design(design, file_name_for_errors);
    return design;
}

Design load_work(const fs::path& file) {
    return parse_work(read_text_file(file), file.string(), file.parent_path());
}

Design load_design(const fs::path& file) {
    Design design = load_work(file);
    check_design(design, file.string());
    return design;
}

}  // namespace nacre
