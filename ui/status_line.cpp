#include "ui/status_line.h"

#include <imgui.h>

#include <algorithm>

#include "core/base/utf8.h"
#include "ui/item_map.h"
#include "ui/theme.h"
#include "ui/widgets.h"

namespace nacre::ui {
namespace {

// A dot that tells whether the picture is final without anything moving.
void dot(const Colour& colour) {
    const float size = ImGui::GetFontSize();
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    ImGui::GetWindowDrawList()->AddCircleFilled({corner.x + size * 0.3f, corner.y + size * 0.54f},
                                                size * 0.24f, ImGui::GetColorU32(colour));
    ImGui::Dummy(ImVec2(size * 0.6f, size));
    ImGui::SameLine();
}

void part(const char* name, const std::string& text, const Colour& colour, const char* about) {
    ImGui::PushStyleColor(ImGuiCol_Text, colour);
    ImGui::TextUnformatted(as_utf8(text).c_str());
    ImGui::PopStyleColor();
    note_item(name);
    tooltip_for_item(about);
}

// The next part stands where it would after `widest`, so that nothing moves while numbers change.
void next_part(const char* widest) {
    const float left = ImGui::GetItemRectMin().x - ImGui::GetWindowPos().x;
    ImGui::SameLine(left + ImGui::CalcTextSize(widest).x + ImGui::GetFontSize());
}

std::string list_of(const std::vector<std::string>& left_out) {
    std::string text = "Left out of tables and shader, since this design does not need it:";
    for (const std::string& line : left_out) text += "\n\u2013 " + line;
    return text;
}

void tables_parts(const TablesStatus& baked, bool expert) {
    part("Quality", baked.quality, palette::text_dim,
         "A draft follows the hand, within a few percent; the final tables come when it rests, "
         "within a thousandth or as near as they can.");
    if (!expert) return;
    next_part("Draft");
    part("Validity", baked.validity, baked.creates_energy ? palette::amber : palette::text_dim,
         baked.valid
             ? "The mean facet normal lies along n, as on every real surface: \u222b h p(h) dh is "
               "parallel to n, and facets show as much area as the surface has."
             : "The mean facet normal \u222b h p(h) dh is tilted away from n: seen from one side the "
               "facets show more area than the surface has. While Conserve energy is on, visibility is held "
               "at 1 there, so nothing reflects more than it gets, but the highlight is dimmer on that "
               "side. Balance and Straighten bring the mean to n.");
    next_part("mean normal tilted 90.0\u00b0");
    part("Left out", std::to_string(baked.left_out.size()) + " left out", palette::text_dim, nullptr);
    if (ImGui::IsItemHovered()) tooltip_for_item(list_of(baked.left_out).c_str());
    next_part("10 left out");
    part(
        "Baked tables", baked.tables, palette::text_dim,
        "What was baked for this picture: nodes of each table along the angle from the normal and around it; "
        "the symmetry that was used; memory; the time it took; and "
        "the worst errors, measured between the nodes: of the projected area g(k) = \u222b max(h\u00b7k, 0) "
        "p(h) dh, relative, and of the albedo R(k), as a fraction of the incident light.");
}

// Draws only left of `right`, pixels from the window's left.
template <class Contents>
void clipped(float right, const Contents& contents) {
    const ImVec2 low = ImGui::GetWindowPos(), size = ImGui::GetWindowSize();
    ImGui::PushClipRect(low, {low.x + std::max(right, 0.0f), low.y + size.y}, true);
    contents();
    ImGui::PopClipRect();
}

}  // namespace

float status_height() { return ImGui::GetFontSize() * 1.9f; }

void status_line(const Status& status) {
    const bool refused = !status.problem.empty(), warned = !status.warning.empty();
    const float gap = ImGui::GetFontSize();
    const float end = ImGui::GetWindowWidth() - status.kept_free - ImGui::GetStyle().WindowPadding.x;
    dot(refused ? palette::red : status.working ? palette::amber : palette::accent);
    if (refused)
        return clipped(end, [&] { part("Problem", status.problem, palette::red, status.problem.c_str()); });
    // What was done last stands at the right, before what was baked where both do not fit.
    const std::string& said = warned ? status.warning : status.message;
    const float first = ImGui::GetCursorPosX();
    const float left = std::max(first, end - ImGui::CalcTextSize(said.c_str()).x);
    clipped(said.empty() ? end : left - gap, [&] {
        if (status.baked)
            tables_parts(*status.baked, status.expert);
        else
            part("Baked tables", "baking\u2026", palette::text_dim,
                 "The first tables of this design are on the way.");
    });
    if (said.empty()) return;
    ImGui::SameLine(left);
    clipped(end, [&] { part("Said last", said, warned ? palette::amber : palette::text_dim, said.c_str()); });
}

}  // namespace nacre::ui
