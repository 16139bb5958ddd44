#include <fmt/core.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "core/base/error.h"
#include "core/base/input_file.h"
#include "core/base/json_reader.h"
#include "core/base/json_text.h"
#include "core/design/design_check.h"
#include "core/design/design_file.h"
#include "core/design/kind_read.h"
#include "core/design/layer_read.h"

namespace nacre {
namespace {

namespace fs = std::filesystem;

void check_version(ObjectReader& reader) {
    const std::string meaning = fmt::format("the version of the format, 1 to {}", design_version);
    const JsonValue json = reader.required("nacre", meaning);
    const int version = json.whole_number(1, std::numeric_limits<int>::max());
    if (version > design_version)
        throw UserError(json.file(), json.path(),
                        fmt::format("made by a newer Nacre (version {}): this one reads versions 1 to {}",
                                    version, design_version));
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

// The object of a model that has no key besides its parameters; `subject` names it in messages.
template <class Variant>
Variant read_model(const JsonValue& json, std::string_view subject) {
    ObjectReader reader(json);
    const Variant model = read_kind<Variant>(reader, "model");
    reader.finish(fmt::format("the {} model \"{}\"", subject, kind_name(model)));
    return model;
}

Shadowing read_shadowing(const JsonValue& json) {
    ObjectReader reader(json);
    Shadowing shadowing;
    shadowing.model = read_kind<MaskingModel>(reader, "model");
    reader.flag("clamp", shadowing.clamp);
    reader.finish(fmt::format("the shadowing model \"{}\"", kind_name(shadowing.model)));
    return shadowing;
}

Specular read_specular(const JsonValue& json) {
    ObjectReader reader(json);
    Specular specular;
    reader.number("intensity", specular.intensity, {0, limits::intensity_max});
    reader.finish("the specular term");
    return specular;
}

Retro read_retro(const JsonValue& json) {
    ObjectReader reader(json);
    Retro retro;
    kind_detail::read_parameters(reader, retro);
    reader.finish("retro-reflection");
    return retro;
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
    if (reader.has("fresnel")) design.fresnel = read_model<Fresnel>(reader.at("fresnel"), "Fresnel");
    if (reader.has("diffuse")) design.diffuse = read_model<Diffuse>(reader.at("diffuse"), "diffuse");
    if (reader.has("multibounce"))
        design.multibounce = read_model<Multibounce>(reader.at("multibounce"), "multibounce");
    if (reader.has("specular")) design.specular = read_specular(reader.at("specular"));
    if (reader.has("retro")) design.retro = read_retro(reader.at("retro"));
    if (reader.has("coat")) design.coat = read_model<Coat>(reader.at("coat"), "coat");
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
