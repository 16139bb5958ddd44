// docs/file-format.md has every lobe and model with every key, as their lists of parameters have it.
#include <doctest/doctest.h>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cstdlib>

#include "core/design/design.h"
#include "tests/core/temporary_folder.h"

using namespace nacre;
using namespace nacre::test;

namespace {

constexpr const char* begin_mark = "<!-- kinds, by scripts/update-format -->\n";
constexpr const char* end_mark = "<!-- end of kinds -->\n";

// Line breaks and bars would end a cell of a table.
std::string cell(std::string_view text) {
    std::string result;
    for (const char c : text) {
        if (c == '|') result += '\\';
        result += c == '\n' ? ' ' : c;
    }
    return result;
}

std::string colour(const glm::dvec3& c) { return fmt::format("[{}, {}, {}]", c.x, c.y, c.z); }

// What a parameter may be, and what it is where the key is missing.
struct Allowed {
    std::string value;
    std::string otherwise;
};

template <class T>
Allowed allowed(const NumberParameter<T>& p) {
    return {fmt::format("number from {} to {}{}", p.bounds.low, p.bounds.high,
                        p.may_be_infinite ? ", or `\"infinity\"`" : ""),
            fmt::format("{}", T{}.*p.member)};
}
template <class T>
Allowed allowed(const ColourParameter<T>& p) {
    return {fmt::format("colour, three numbers from {} to {}", p.bounds.low, p.bounds.high),
            colour(T{}.*p.member)};
}
template <class T>
Allowed allowed(const TripleParameter<T>& p) {
    return {fmt::format("three numbers from {} to {}", p.bounds.low, p.bounds.high), colour(T{}.*p.member)};
}
template <class T, class Enum, std::size_t count>
Allowed allowed(const ChoiceParameter<T, Enum, count>& p) {
    return {fmt::format("`\"{}\"`", fmt::join(p.names, "\"` or `\"")),
            fmt::format("`\"{}\"`", p.names.at(static_cast<std::size_t>(T{}.*p.member)))};
}
template <class T>
Allowed allowed(const CurveParameter<T>& p) {
    std::vector<std::string> points;
    for (const T otherwise; const auto& [theta, value] : otherwise.*p.member)
        points.push_back(fmt::format("[{}, {}]", theta, value));
    return {
        fmt::format(
            "2 to {} points `[theta, value]`: theta from {} to {} degrees, rising; value from {} to {}",
            p.points_max, p.theta_bounds.low, p.theta_bounds.high, p.value_bounds.low, p.value_bounds.high),
        fmt::format("[{}]", fmt::join(points, ", "))};
}
template <class T>
Allowed allowed(const ColourCurveParameter<T>& p) {
    std::vector<std::string> points;
    for (const T otherwise; const auto& [theta, c] : otherwise.*p.member)
        points.push_back(fmt::format("[{}, {}, {}, {}]", theta, c.x, c.y, c.z));
    return {
        fmt::format(
            "1 to {} points `[theta, red, green, blue]`: theta from {} to {} degrees, rising; colours from "
            "{} to {}",
            p.points_max, p.theta_bounds.low, p.theta_bounds.high, p.value_bounds.low, p.value_bounds.high),
        fmt::format("[{}]", fmt::join(points, ", "))};
}
template <class T, class Row>
Allowed allowed(const ListParameter<T, Row>& p) {
    std::vector<std::string> keys, defaults;
    visit_parameters<Row>([&](const auto& parameter) {
        keys.push_back(fmt::format("`{}` ({}; default {}): {}", parameter.text.key, allowed(parameter).value,
                                   allowed(parameter).otherwise, cell(parameter.text.tooltip)));
        defaults.push_back(fmt::format("\"{}\": {}", parameter.text.key, allowed(parameter).otherwise));
    });
    return {fmt::format("list of at most {} objects: {}", p.rows_max, fmt::join(keys, " ")),
            fmt::format("[{{{}}}]", fmt::join(defaults, ", "))};
}
template <class T, class Set>
Allowed allowed(const KindParameter<T, Set>& p) {
    const Set otherwise = T{}.*p.member;
    std::string parameters;
    const auto append = [&]<class Kind>(const Kind& kind) {
        visit_parameters<Kind>([&]<class Parameter>(const Parameter& parameter) {
            if constexpr (requires { parameter.names; })
                parameters +=
                    fmt::format(", \"{}\": \"{}\"", parameter.text.key,
                                parameter.names.at(static_cast<std::size_t>(kind.*parameter.member)));
        });
    };
    std::visit(append, otherwise);
    return {fmt::format("`\"{}\"`, with that model's own keys beside it",
                        fmt::join(KindSet<Set>::names, "\"` or `\"")),
            fmt::format("\"{}\"{}", kind_name(otherwise), parameters)};
}
template <class T>
Allowed allowed(const PictureParameter<T>&) {
    return {"a picture", "required"};
}

template <class Variant>
std::string kinds_text(const char* title, const char* key) {
    std::string text = fmt::format("### {}\n\n", title);
    for (std::size_t i = 0; i < KindSet<Variant>::count; ++i) {
        text += fmt::format("`\"{}\": \"{}\"`{}: {}\n\n", key, KindSet<Variant>::names[i],
                            (i == 0 ? " (where the key is missing)" : "") +
                                (file_version(KindSet<Variant>::made(i)) > 1
                                     ? fmt::format(" (version {})", file_version(KindSet<Variant>::made(i)))
                                     : std::string()),
                            cell(KindSet<Variant>::explanations[i]));
        std::string rows;
        std::visit(
            [&]<class T>(const T&) {
                visit_parameters<T>([&](const auto& parameter) {
                    const Allowed a = allowed(parameter);
                    rows += fmt::format("| `{}` | {} | {} | {} |\n", parameter.text.key, a.value, a.otherwise,
                                        cell(parameter.text.tooltip));
                });
            },
            KindSet<Variant>::made(i));
        if (!rows.empty())
            text += "| key | value | default | meaning |\n| --- | --- | --- | --- |\n" + rows + "\n";
    }
    return text;
}

}  // namespace

TEST_CASE("file format: the document has every kind with every key") {
    const std::string kinds =
        "\n" + kinds_text<Lobe>("Lobes of a layer", "lobe") +
        kinds_text<MaskingModel>("`shadowing`", "model") + kinds_text<Fresnel>("`fresnel`", "model") +
        kinds_text<Diffuse>("`diffuse`", "model") + kinds_text<Multibounce>("`multibounce`", "model") +
        kinds_text<Coat>("`coat`", "model");
    const std::filesystem::path file = NACRE_SOURCE_DIR "/docs/file-format.md";
    std::string text = read_all(file);
    const std::size_t begin = text.find(begin_mark), end = text.find(end_mark);
    REQUIRE(begin != text.npos);
    REQUIRE(end != text.npos);
    const std::size_t from = begin + std::string_view(begin_mark).size();
    if (std::getenv("NACRE_UPDATE_FORMAT") != nullptr) write_all(file, text.replace(from, end - from, kinds));
    CHECK_MESSAGE(read_all(file).substr(from, kinds.size()) == kinds,
                  "scripts/update-format writes the lists of docs/file-format.md anew");
}
