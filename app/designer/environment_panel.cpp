#include "app/designer/environment_panel.h"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <utility>
#include <vector>

#include "app/designer/picture_trouble.h"
#include "core/formats/environment_file.h"
#include "core/image/picture.h"
#include "core/light/procedural.h"
#include "ui/item_map.h"
#include "ui/widgets.h"

namespace nacre {
namespace {

namespace fs = std::filesystem;

FileQuestion picture_question(const fs::path& folder) {
    return {.purpose = ui::FileDialog::Purpose::open,
            .title = "Open environment map",
            .folder = folder,
            .kind = "Lat-long picture",
            .extensions = picture_extensions()};
}

// An entry of the list of environments; without words about it, it speaks for itself.
struct Entry {
    std::string name;  // of the environment
    std::string label;
    const char* about = nullptr;
};

// A list whose entries can be found by their labels. Returns whether another was chosen.
bool choose(const std::vector<Entry>& entries, std::size_t& chosen) {
    constexpr const char* about =
        "An environment replaces the lights: a lat-long picture whose middle is behind the object. The "
        "preview grows finer while nothing moves.";
    const std::size_t before = chosen;
    ui::row_label("Environment", about);
    if (ImGui::BeginCombo("##Environment", entries[chosen].label.c_str())) {
        for (std::size_t i = 0; i < entries.size(); ++i) {
            ImGui::PushID(static_cast<int>(i));
            if (ImGui::Selectable(entries[i].label.c_str(), i == before)) chosen = i;
            ImGui::PopID();
            ui::note_item(entries[i].label);
            if (entries[i].about) ui::tooltip_for_item(entries[i].about);
        }
        ImGui::EndCombo();
    }
    ui::note_item("Environment");
    ui::tooltip_for_item(about);
    return chosen != before;
}

bool is_procedural(const std::string& name) {
    const auto& known = procedural_environments();
    return std::any_of(known.begin(), known.end(),
                       [&](const ProceduralEnvironment* e) { return e->name == name; });
}

}  // namespace

EnvironmentPanel::EnvironmentPanel()
    : job_([](const std::string& name, const std::stop_token&, const auto& publish) {
          HeldFiles held;
          if (!is_procedural(name)) held = held_now(std::array<fs::path, 1>{name});
          publish({load_environment(name), std::move(held)});
      }) {}

void EnvironmentPanel::want(std::string name_or_file) {
    wanted_ = std::move(name_or_file);
    asked_ = job_.submit(*wanted_);
}

void EnvironmentPanel::rows(SceneEnvironment& environment, const std::optional<DialogProgram>& dialogs) {
    std::string present = environment.picture ? environment.picture->name : "";
    if (wanted_) present = *wanted_;
    if (!present.empty() && !is_procedural(present)) last_file_ = present;

    std::vector<Entry> entries = {{"", "None"}};
    for (const ProceduralEnvironment* known : procedural_environments())
        entries.push_back({known->name, known->label, known->about});
    if (!last_file_.empty())
        entries.push_back({last_file_, ui::as_label(fs::path(last_file_).filename().string())});
    const std::size_t open_picture = entries.size();
    const auto is_present = [&](const Entry& entry) { return entry.name == present; };
    auto chosen =
        static_cast<std::size_t>(std::find_if(entries.begin(), entries.end(), is_present) - entries.begin());
    entries.push_back({"", "Open picture\u2026"});
    if (choose(entries, chosen)) {
        if (chosen == open_picture) {
            chooser_.ask(picture_question(fs::path(last_file_).parent_path()), dialogs);
        } else if (chosen == 0) {
            environment.picture.reset();
            held_.clear();
            wanted_.reset();
        } else {
            want(entries[chosen].name);
        }
    }
    if (!environment.picture) return;
    ui::notes_row(environment.picture->notes);
    const SceneEnvironment usual;
    ui::slider(
        {.label = "Rotation##Environment rotation",
         .low = -180,
         .high = 180,
         .least = -360,
         .most = 360,
         .reset = usual.rotation,
         .format = "%.1f\u00b0",
         .logarithmic = false,
         .tooltip =
             "Turns the environment about the vertical, to the right. Dragging on the object does too."},
        environment.rotation);
    ui::slider({.label = "Brightness##Environment brightness",
                .low = 0.05,
                .high = 20,
                .least = 0,
                .most = 1e4,
                .reset = usual.brightness,
                .format = "%.2f",
                .logarithmic = true,
                .tooltip = "A factor of the environment's radiance."},
               environment.brightness);
    ui::checkbox("Show as background", environment.visible, "Shows the environment behind the object.");
    ui::checkbox("Keep scene lights", environment.with_lights,
                 "The lights below shine together with the environment.");
}

void EnvironmentPanel::follow(SceneEnvironment& environment) {
    if (auto published = job_.poll(); published && wanted_ && published->revision == asked_) {
        const std::string name = *std::exchange(wanted_, std::nullopt);
        if (published->result) {
            environment.picture = std::move(published->result->picture);
            held_ = std::move(published->result->held);
        } else {
            problem_ = picture_trouble(name, published->error);
            if (last_file_ == name) last_file_.clear();
        }
    }
}

void EnvironmentPanel::talk() {
    if (!problem_.empty()) {
        if (ui::question("Cannot open the environment map", problem_, {"OK"})) problem_.clear();
        return;
    }
    const auto answer = chooser_.draw();
    if (answer && !answer->chosen.empty()) want(answer->chosen.string());
}

}  // namespace nacre
