#include "app/designer/normal_choice.h"

#include <imgui.h>

#include <exception>

#include "ui/item_map.h"
#include "ui/theme.h"
#include "ui/widgets.h"

namespace nacre {
namespace {

struct Option {
    const char* label;
    const char* tooltip;
};

// Two buttons side by side, the chosen one lit. Returns whether the other was chosen.
bool either(const char* label, const Option& no, const Option& yes, bool& value) {
    const bool before = value;
    ui::row_label(label, nullptr);
    for (const bool second : {false, true}) {
        const Option& option = second ? yes : no;
        if (second) ImGui::SameLine(0, ImGui::GetStyle().ItemInnerSpacing.x);
        const bool lit = before == second;
        if (lit) ImGui::PushStyleColor(ImGuiCol_Button, ui::palette::accent_dim);
        if (ui::button(option.label, option.tooltip)) value = second;
        if (lit) ImGui::PopStyleColor();
    }
    return value != before;
}

}  // namespace

void NormalChoice::look_at(const std::filesystem::path& file) {
    file_ = file;
    picture_.reset();
    note_.clear();
    // What is wrong is told when the picture is used: it may not be used as normals at all.
    try {
        picture_ = load_colours(file, &picture_notes_);
        look_ = look_at_normal_map(*picture_);
    } catch (const std::exception&) {
        picture_.reset();
        return;
    }
    reading_ = look_.reading;
    reading_.green_down = green_down_;
    if (const auto before = chosen_.find(file); before != chosen_.end()) reading_ = before->second;
    count();
}

void NormalChoice::count() {
    note_ = picture_->channels < 2 ? std::string() : note_on(count_normals(*picture_, reading_));
}

void NormalChoice::draw() {
    if (!picture_ || picture_->channels < 2) return;
    const NormalReading before = reading_;
    either(
        "Numbers",
        {"0.5 is zero", "For normals: each number c means 2 c - 1, as in pictures without negative numbers."},
        {"Signed", "For normals: numbers are used as they are, negative ones too."}, reading_.is_signed);
    either("Channels", {"x, y and z", "For normals: red, green and blue are x, y and z."},
           {"x and y", "For normals: red and green are x and y; blue is not read, z makes the length 1."},
           reading_.two_channels);
    either("Green", {"Up (OpenGL)", "For normals: green is y toward the picture's upper edge."},
           {"Down (DirectX)", "For normals: green is y toward the picture's lower edge."},
           reading_.green_down);
    if (reading_ != before) {
        chosen_[file_] = reading_;
        green_down_ = reading_.green_down;
        count();
    }
    if (look_.green_down && *look_.green_down != reading_.green_down)
        ui::text_row("", *look_.green_down ? "Its slopes fit together better with green down."
                                           : "Its slopes fit together better with green up.");
    if (!note_.empty()) ui::text_row("", "As normals: " + note_ + ".");
}

const ColourPicture& NormalChoice::picture() {
    if (!picture_) picture_ = load_colours(file_, &picture_notes_);
    return *picture_;
}

PictureNotes NormalChoice::notes() const {
    PictureNotes notes = picture_notes_;
    if (!note_.empty()) notes.insert(notes.begin(), note_);
    return notes;
}

}  // namespace nacre
