#include "app/designer/settings.h"

#include <fmt/format.h>

#include <utility>

namespace nacre {
namespace {

namespace fs = std::filesystem;

constexpr int version = 1;
constexpr double drawer_largest = 1000;  // text sizes: more than any screen has

void read_folder(ObjectReader& object, std::string_view key, fs::path& folder) {
    if (object.has(key)) folder = read_path(object.at(key));
}

void read_border(ObjectReader& object, std::string_view key, Range range, float& border) {
    double value = static_cast<double>(border);
    object.number(key, value, range);
    border = static_cast<float>(value);
}

Settings read_settings(ObjectReader& object) {
    Settings settings;
    object.required("nacre_settings", "the version of the settings").whole_number(version, version);
    read_border(object, "panel", {panel_min, panel_max}, settings.layout.panel);
    read_border(object, "canvas", {canvas_min, canvas_max}, settings.layout.canvas);
    read_border(object, "drawer", {drawer_min, drawer_largest}, settings.layout.drawer);
    object.flag("system_dialogs", settings.system_dialogs);
    if (object.has("habits")) settings.habits = read_habits(object.at("habits"));
    read_folder(object, "design_folder", settings.design_folder);
    read_folder(object, "picture_folder", settings.picture_folder);
    read_folder(object, "export_folder", settings.export_folder);
    object.finish("the settings");
    return settings;
}

}  // namespace

Settings parse_settings(const std::string& text, const std::string& name) {
    Settings settings;
    read_object(text, name, [&](ObjectReader& object) { settings = read_settings(object); });
    return settings;
}

std::string settings_text(const Settings& settings) {
    std::string text = fmt::format("{{\n  \"nacre_settings\": {},\n", version);
    text += fmt::format("  \"panel\": {},\n", settings.layout.panel);
    text += fmt::format("  \"canvas\": {},\n", settings.layout.canvas);
    text += fmt::format("  \"drawer\": {},\n", settings.layout.drawer);
    text += fmt::format("  \"habits\": {},\n", habits_text(settings.habits));
    const auto path = [&](const char* key, const fs::path& value) {
        if (value.empty()) return;
        if (const auto json = json_path(value)) text += fmt::format("  \"{}\": {},\n", key, *json);
    };
    path("design_folder", settings.design_folder);
    path("picture_folder", settings.picture_folder);
    path("export_folder", settings.export_folder);
    return text + fmt::format("  \"system_dialogs\": {}\n}}\n", settings.system_dialogs);
}

SettingsFile::SettingsFile(const fs::path& folder, Settings first)
    : values(std::move(first)), file_(folder.empty() ? fs::path() : folder / "settings.json") {
    file_.read([this](const std::string& text, const std::string& name) {
        first_run_ = false;
        values = parse_settings(text, name);
    });
    kept_ = values;
}

void SettingsFile::keep() {
    if (values == kept_) return;
    kept_ = values;
    file_.write(settings_text(values));
}

}  // namespace nacre
