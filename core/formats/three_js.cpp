#include "core/formats/three_js.h"

#include <fmt/core.h>

#include <nlohmann/json.hpp>

#include "core/base/error.h"
#include "core/formats/glsl_sampler.h"
#include "core/formats/web_fill.h"
#include "core/formats/web_text.h"

namespace nacre {

std::string three_js_module(const Design& design, const Tables& tables, const std::string& prefix,
                            const std::string& file) {
    const bool ambient = tables.needs.albedo;
    const std::vector<float> data = sampler_data(tables);
    // A JSON text is one of JavaScript too; in ASCII it also ends no line of a comment.
    const auto quoted = [](const std::string& text) { return nlohmann::json(text).dump(-1, ' ', true); };
    return filled(
        web_text("three.js"),
        {{"name", quoted(one_line(design.name.empty() ? "Untitled" : design.name, 80))},
         {"file", quoted("./" + one_line(file, 80))},
         {"prefix", prefix},
         {"glsl", quoted(glsl_sampler_text(design, tables, prefix))},
         {"rows", fmt::format("{}", texture_rows(data.size()))},
         {"tables", base64(texture_bytes(data))},
         {"ambient", ambient ? " and by its ambient light" : ""},
         {"ambient_light", ambient ? filled(web_text("three_ambient.frag"), {{"prefix", prefix}}) : ""}});
}

}  // namespace nacre
