#include "core/formats/export_format.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>

#include "core/base/error.h"
#include "core/base/system/atomic_file.h"
#include "core/base/utf8.h"

namespace nacre {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t prefix_max = 64;      // characters
constexpr std::size_t file_name_max = 120;  // of it, in a step

}  // namespace

std::vector<fs::path> ExportWriter::operator()(const fs::path& output) const {
    if (fill_) return fill_(output);
    write_file_atomically(output, bytes_);
    return {output};
}

std::span<const ExportFormat* const> export_formats() {
    static const std::array formats{
#define FORMAT(name) &name##_format,
#include "core/formats/format_list.inc"
#undef FORMAT
    };
    return formats;
}

DesignHolding holding_of(const ExportFormat& format, const Design& design) {
    std::string refused, fitted;
    for (const FeatureInfo& info : all_features()) {
        const Holding holding = format.holds[info.feature];
        if (holding == Holding::exact || !has_feature(design, info.feature)) continue;
        std::string& list = holding == Holding::refused ? refused : fitted;
        list += (list.empty() ? "" : ", ") + std::string(info.title);
    }
    if (!refused.empty())
        return {true, fmt::format("This design has what the format cannot hold: {}.", refused)};
    if (fitted.empty()) return {false, "Holds this design exactly."};
    return {false, fmt::format("Holds this design approximately: {}.", fitted)};
}

ExportWriter prepare_export(const ExportFormat& format, const Design& design, const ExportSettings& settings,
                            const std::stop_token& stop, const std::function<void(double)>& progress) {
    if (const DesignHolding holding = holding_of(format, design); holding.refused)
        throw UserError("", fmt::format("export to {}", format.name), holding.text);
    return format.prepare(design, settings, stop, progress);
}

std::string formats_json() {
    using Json = nlohmann::ordered_json;
    const ExportSettings otherwise;
    Json list = Json::array();
    for (const ExportFormat* format : export_formats()) {
        Json options = {{"tolerance", otherwise.bake.tolerance}};
        if (format->has_names) options["prefix"] = otherwise.prefix;
        if (format->has_error) options["error"] = otherwise.error;
        Json holds = Json::object();
        for (const FeatureInfo& info : all_features())
            holds[std::string(info.name)] = name_of(format->holds[info.feature]);
        list.push_back({{"name", format->name},
                        {"title", format->title},
                        {"about", about(*format, otherwise.prefix)},
                        {"extension", format->extension},
                        {"defaults", options},
                        {"holds", holds}});
    }
    return list.dump(2) + "\n";
}

std::vector<fs::path> one_file(const Design&, const fs::path& file) { return {file}; }

std::string about(const ExportFormat& format, std::string_view prefix) {
    return fmt::format(fmt::runtime(format.about), fmt::arg("prefix", prefix));
}

std::vector<std::string> next_steps(NextSteps next, std::string_view prefix, const fs::path& output) {
    const fs::path whole = output.has_filename() ? output : output.parent_path();
    const std::string text =
        fmt::format(fmt::runtime(next.text()), fmt::arg("prefix", prefix),
                    fmt::arg("file", one_line(as_utf8(whole.filename().string()), file_name_max)));
    std::vector<std::string> steps(1);
    for (const char c : text)
        if (c == '\n')
            steps.emplace_back();
        else
            steps.back() += c;
    return steps;
}

std::vector<std::string> next_steps(const ExportFormat& format, std::string_view prefix,
                                    const fs::path& output) {
    return next_steps(format.next, prefix, output);
}

std::string prefix_problem(std::string_view prefix) {
    const auto letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); };
    const auto allowed = [&](char c) { return letter(c) || (c >= '0' && c <= '9') || c == '_'; };
    const bool sound = !prefix.empty() && prefix.size() <= prefix_max && letter(prefix.front()) &&
                       std::all_of(prefix.begin(), prefix.end(), allowed);
    if (!sound)
        return fmt::format("must be 1 to {} letters a to z, digits and underscores, a letter first",
                           prefix_max);
    // GLSL keeps these for itself (GLSL 3.30, 3.7); the underscore that joins prefix and name counts too.
    if (prefix.starts_with("gl_") || prefix == "gl") return "must not begin with gl_";
    if (prefix.find("__") != prefix.npos || prefix.back() == '_')
        return "must hold no two underscores in a row and end in none: one is put after it";
    return {};
}

const ExportFormat* export_format(std::string_view name) {
    for (const ExportFormat* format : export_formats())
        if (format->name == name) return format;
    return nullptr;
}

}  // namespace nacre
