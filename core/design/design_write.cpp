#include <fmt/core.h>

#include <algorithm>
#include <cassert>
#include <charconv>
#include <cmath>
#include <nlohmann/json.hpp>

#include "core/design/design_file.h"
#include "core/design/design_names.h"
#include "core/design/error.h"
#include "core/exchange/atomic_file.h"
#include "core/exchange/input_file.h"

namespace nacre {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view layer_indent = "      ";
constexpr std::string_view pixel_indent = "        ";

// The shortest text that reads back as the same number.
std::string number(double value) {
    if (std::isinf(value)) return "\"infinity\"";
    assert(!std::isnan(value));
    return fmt::format("{}", value + 0.0);
}

// The shortest text that reads back as the same float by way of a double, as JSON readers do. Of all
// positive floats only 7.038531e-26 rounds twice and misses; it is written as the double it equals.
void append_float(std::string& text, float value) {
    char digits[32];
    const char* const end = std::to_chars(digits, std::end(digits), value + 0.0f).ptr;
    double back = 0;
    std::from_chars(digits, end, back);
    if (static_cast<float>(back) == value)
        text.append(digits, static_cast<std::size_t>(end - digits));
    else
        text += fmt::format("{}", static_cast<double>(value));
}

// A byte that is not UTF-8 becomes the replacement character.
std::string quoted(const std::string& text) {
    return nlohmann::json(text).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

std::string quoted(std::string_view name) { return quoted(std::string(name)); }

std::string colour(const glm::dvec3& c) {
    return fmt::format("[{}, {}, {}]", number(c.x), number(c.y), number(c.z));
}

std::string raster_text(const Raster& raster) {
    std::string text =
        fmt::format("{{\"width\": {}, \"height\": {}, \"values\": [\n", raster.width, raster.height);
    const auto width = static_cast<std::size_t>(raster.width);
    assert(raster.values.size() == width * static_cast<std::size_t>(raster.height));
    for (std::size_t i = 0; i < raster.values.size(); ++i) {
        if (i % width == 0) text += pixel_indent;
        append_float(text, raster.values[i]);
        const bool last = i + 1 == raster.values.size();
        text += (i + 1) % width == 0 ? (last ? "\n" : ",\n") : ", ";
    }
    text += layer_indent;
    return text + "]}";
}

// Where the text will stand.
struct Target {
    fs::path base_dir;
    std::string file;
};

std::string picture_text(const Picture& picture, const std::string& where, const Target& target) {
    if (picture.file.empty()) {
        assert(picture.raster);
        return raster_text(*picture.raster);
    }
    const std::string path =
        fs::absolute(picture.file).lexically_normal().lexically_relative(target.base_dir).generic_string();
    try {
        return nlohmann::json(path).dump();
    } catch (const nlohmann::json::exception&) {
        throw UserError(target.file, where, "a picture's path must be UTF-8 to stand in a design", path);
    }
}

std::string alphas_text(double x, double y) {
    return fmt::format(", \"alpha_x\": {}, \"alpha_y\": {}", number(x), number(y));
}

std::string curve_text(const CurveLobe& curve) {
    std::string points;
    for (const auto& [theta, value] : curve.points)
        points += fmt::format("{}[{}, {}]", points.empty() ? "" : ", ", number(theta), number(value));
    return fmt::format(", \"points\": [{}]", points);
}

std::string lobe_text(const Lobe& lobe) {
    if (const auto* const gaussian = std::get_if<GaussianLobe>(&lobe))
        return fmt::format(", \"sigma_x\": {}, \"sigma_y\": {}", number(gaussian->sigma_x),
                           number(gaussian->sigma_y));
    if (const auto* const inverse = std::get_if<InverseGaussianLobe>(&lobe))
        return fmt::format(", \"sigma\": {}", number(inverse->sigma));
    if (const auto* const ggx = std::get_if<GgxLobe>(&lobe)) return alphas_text(ggx->alpha_x, ggx->alpha_y);
    if (const auto* const beckmann = std::get_if<BeckmannLobe>(&lobe))
        return alphas_text(beckmann->alpha_x, beckmann->alpha_y);
    if (const auto* const uniform = std::get_if<UniformLobe>(&lobe))
        return ", \"domain\": " + quoted(domain_names[static_cast<std::size_t>(uniform->domain)]);
    if (const auto* const curve = std::get_if<CurveLobe>(&lobe)) return curve_text(*curve);
    return {};
}

std::string layer_text(const Layer& layer, const std::string& where, const Target& target) {
    std::string text;
    if (!layer.name.empty()) text += fmt::format("\"name\": {}, ", quoted(layer.name));
    if (!layer.enabled) text += "\"enabled\": false, ";
    text += fmt::format("\"lobe\": {}, \"weight\": {}", quoted(lobe_names[layer.lobe.index()]),
                        number(layer.weight));
    text += lobe_text(layer.lobe);
    text += fmt::format(", \"tilt\": {}, \"azimuth\": {}, \"rotation\": {}", number(layer.tilt),
                        number(layer.azimuth), number(layer.rotation));
    if (const auto* const painted = std::get_if<PaintedLobe>(&layer.lobe))
        text += ", \"image\": " + picture_text(painted->image, where + ".image", target);
    if (layer.modulation)
        text += fmt::format(", \"modulation\": {{\"strength\": {}, \"image\": {}}}",
                            number(layer.modulation->strength),
                            picture_text(layer.modulation->image, where + ".modulation.image", target));
    return text;
}

std::string shadowing_text(const Shadowing& shadowing) {
    std::string text = "\"model\": " + quoted(shadowing_names[static_cast<std::size_t>(shadowing.model)]);
    if (shadowing.model == ShadowingModel::correlated) text += ", \"width\": " + number(shadowing.width);
    return text + ", \"clamp\": " + (shadowing.clamp ? "true" : "false");
}

std::string fresnel_text(const Fresnel& fresnel) {
    const std::string model = "\"model\": " + quoted(fresnel_names[fresnel.index()]);
    if (const auto* const schlick = std::get_if<SchlickFresnel>(&fresnel))
        return model + ", \"f0\": " + colour(schlick->f0);
    if (const auto* const dielectric = std::get_if<DielectricFresnel>(&fresnel))
        return model + ", \"ior\": " + number(dielectric->ior);
    if (const auto* const metal = std::get_if<ConductorFresnel>(&fresnel))
        return model + ", \"eta\": " + colour(metal->eta) + ", \"k\": " + colour(metal->k);
    return model;
}

std::string diffuse_text(const Diffuse& diffuse) {
    const std::string model = "\"model\": " + quoted(diffuse_names[diffuse.index()]);
    if (const auto* const lambertian = std::get_if<LambertianDiffuse>(&diffuse))
        return fmt::format("{}, \"kd\": {}, \"ks\": {}, \"albedo\": {}", model, number(lambertian->kd),
                           number(lambertian->ks), colour(lambertian->albedo));
    if (const auto* const coupled = std::get_if<CoupledDiffuse>(&diffuse))
        return model + ", \"albedo\": " + colour(coupled->albedo);
    return model;
}

std::string design_text(const Design& design, const Target& target) {
    std::string text = "{\n";
    text += fmt::format("  \"nacre\": {},\n", design_version);
    text += fmt::format("  \"name\": {},\n", quoted(design.name));
    if (!design.note.empty()) text += fmt::format("  \"note\": {},\n", quoted(design.note));
    text += "  \"distribution\": {\n    \"layers\": [\n";
    const std::vector<Layer>& layers = design.distribution.layers;
    for (std::size_t i = 0; i < layers.size(); ++i) {
        const std::string where = fmt::format("distribution.layers[{}]", i);
        text += fmt::format("{}{{{}}}{}\n", layer_indent, layer_text(layers[i], where, target),
                            i + 1 < layers.size() ? "," : "");
    }
    text += "    ],\n";
    text +=
        fmt::format("    \"mean_cosine_scale\": {}\n  }},\n", number(design.distribution.mean_cosine_scale));
    text += fmt::format("  \"shadowing\": {{{}}},\n", shadowing_text(design.shadowing));
    text += fmt::format("  \"fresnel\": {{{}}},\n", fresnel_text(design.fresnel));
    text += fmt::format("  \"diffuse\": {{{}}}\n}}\n", diffuse_text(design.diffuse));
    return text;
}

}  // namespace

std::string design_json(const Design& design, const fs::path& base_dir) {
    return design_text(design, {absolute_folder(base_dir), "design"});
}

FileContent save_design(const Design& design, const fs::path& file) {
    const std::string text = design_text(design, {absolute_folder(file.parent_path()), file.string()});
    if (text.size() > limits::file_bytes_max)
        throw UserError(
            file.string(), "write",
            fmt::format("the design needs more than the {} bytes a file may have", limits::file_bytes_max),
            fmt::format("{} bytes", text.size()));
    write_file_atomically(file, text);
    return content_of(text);
}

}  // namespace nacre
