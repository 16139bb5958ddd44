#include "core/formats/shading_values.h"

#include <fmt/core.h>

#include <map>
#include <stdexcept>

#include "core/model/parameter_fields.h"

namespace nacre {
namespace {

// What stands for each field.
class Values {
  public:
    explicit Values(Digits digits) : digits_(digits) {}

    void operator()(const char* field, int value) { text_[field] = std::to_string(value); }
    void operator()(const char* field, double value) { text_[field] = digits_of(value, digits_); }
    void operator()(const char* field, glm::dvec2 v) {
        text_[field] = fmt::format("{{{}, {}}}", digits_of(v.x, digits_), digits_of(v.y, digits_));
    }
    void operator()(const char* field, glm::dvec3 v) {
        text_[field] = fmt::format("{{{}, {}, {}}}", digits_of(v.x, digits_), digits_of(v.y, digits_),
                                   digits_of(v.z, digits_));
    }
    void operator()(const char* field, std::string value) { text_[field] = std::move(value); }

    std::string initialiser(const GlslProgram& program, std::string_view name,
                            const std::string& indent) const {
        const GlslStruct* known = program.find_struct(name);
        if (!known) throw std::logic_error(fmt::format("shader text: no struct {}", name));
        std::string text = "{\n";
        for (std::size_t i = 0; i < known->fields.size(); ++i) {
            const std::string& field = known->fields[i].name;
            text += fmt::format("{}    {}{} // {}\n", indent, text_.at(field),
                                i + 1 < known->fields.size() ? "," : "", field);
        }
        return text + indent + "}";
    }

  private:
    Digits digits_;
    std::map<std::string, std::string> text_;
};

template <class Struct>
Values values_of(const Struct& from, Digits digits) {
    Values values(digits);
    visit_fields(from, [&](const char* field, const auto& value) { values(field, value); });
    return values;
}

}  // namespace

std::string digits_of(double value, Digits digits) {
    std::string text =
        digits == Digits::of_double ? fmt::format("{}", value) : fmt::format("{}", static_cast<float>(value));
    if (text.find_first_of(".e") == std::string::npos) text += ".0";
    return text;
}

std::string surface_values(const Shading<double>& shading, const GlslProgram& program, Digits digits) {
    Values values = values_of(shading.surface, digits);
    values("tables", values_of(shading.surface.tables, digits).initialiser(program, "TableShape", "    "));
    return values.initialiser(program, "Surface", "");
}

std::string layer_values(const Shading<double>& shading, const GlslProgram& program, Digits digits) {
    std::string text;
    for (int i = 0; i < shading.layer_count; ++i)
        text += (i > 0 ? ",\n    " : "    ") +
                values_of(shading.layers[i], digits).initialiser(program, "Layer", "    ");
    return text;
}

}  // namespace nacre
