#include "core/formats/glsl_export.h"

#include <fmt/core.h>

#include <vector>

#include "core/formats/glsl_text.h"

namespace nacre {
namespace {

// Stands in the text, where GLSL has no such sign, for the tables' numbers: they hold no names.
constexpr char numbers_here = '@';

std::string numbers(const std::vector<float>& data) {
    std::string text;
    for (std::size_t i = 0; i < data.size(); ++i) {
        if (i > 0) text += ',';
        text += i % 12 == 0 ? "\n    " : " ";
        text += glsl_number(static_cast<double>(data[i]));
    }
    return text;
}

}  // namespace

std::string glsl_export(const Design& design, const Tables& tables, const std::string& prefix) {
    const std::string data = fmt::format(
        "const float data[{0}] = float[{0}]({1});\n\nfloat fetch(int index) {{\n    return "
        "data[index];\n}}\n",
        tables.data.size(), numbers_here);
    std::string text = glsl_function(design, tables, prefix, data);
    text.replace(text.rfind(numbers_here), 1, numbers(tables.data));
    return text;
}

}  // namespace nacre
