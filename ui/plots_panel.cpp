#include "ui/plots_panel.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "ui/item_map.h"
#include "ui/plot_view.h"
#include "ui/theme.h"
#include "ui/widgets.h"

namespace nacre::ui {
namespace {

struct KindEntry {
    PlotKind kind;
    const char* label;
    const char* tooltip;
};

constexpr KindEntry kinds[] = {
    {PlotKind::albedo, "Albedo R##Plot albedo",
     "How much of the light from one direction the highlight sends back in all: R(k), the integral of the "
     "specular term (eq. 29). Shown for the material and for facets of f0 = 0 and 1. At 1 no light is lost."},
    {PlotKind::masking, "Masking P##Plot masking",
     "How much of the facets turned to a direction are seen from it, P(k) = (k.n) N / g(k) (eq. 25). Where "
     "it "
     "falls the surface shadows itself: the rim grows darker."},
    {PlotKind::density, "Density p##Plot density",
     "How many facets face each way, p(h): the form of the highlight itself."},
    {PlotKind::fresnel, "Fresnel F##Plot fresnel",
     "How much light one facet reflects, over the angle at which it is met."},
    {PlotKind::lobe, "Lobe##Plot lobe",
     "What leaves in the plane of incidence when light falls in along k1. Drag in the plot to move k1."},
    {PlotKind::shape, "3-D lobe##Plot lobe3d",
     "What leaves in every direction when light falls in along k1. Drag to turn it, the wheel zooms, a "
     "double "
     "click shows all."},
    {PlotKind::slice, "Slice##Plot slice",
     "The whole BRDF at a glance, over the angles of the half vector (along) and between light and half "
     "vector (up): highlight at the left, Fresnel above, grazing light at the right, retro-reflection below "
     "(Rusinkiewicz 1998; Burley 2012)."},
};

float padded(const char* text) { return ImGui::CalcTextSize(text).x + 2 * ImGui::GetStyle().FramePadding.x; }

float kinds_breadth() {
    float breadth = 0;
    for (const KindEntry& entry : kinds)
        breadth +=
            padded(std::string(visible_text(entry.label)).c_str()) + ImGui::GetStyle().ItemInnerSpacing.x;
    return breadth;
}

void kind_buttons(PlotsState& state) {
    for (const KindEntry& entry : kinds) {
        const bool chosen = state.settings.kind == entry.kind;
        ImGui::PushStyleColor(ImGuiCol_Button, chosen ? palette::accent_dim : Colour{0, 0, 0, 0});
        if (button(entry.label, entry.tooltip)) state.settings.kind = entry.kind;
        ImGui::PopStyleColor();
        ImGui::SameLine(0, ImGui::GetStyle().ItemInnerSpacing.x);
    }
}

// In place of the buttons where they have no room.
void kind_menu(PlotsState& state, float breadth) {
    const auto& chosen = kinds[static_cast<std::size_t>(state.settings.kind)];
    ImGui::SetNextItemWidth(breadth);
    const bool open = ImGui::BeginCombo("##Plot kind", std::string(visible_text(chosen.label)).c_str());
    note_item("Plot kind");
    tooltip_for_item(chosen.tooltip);
    if (open) {
        for (const KindEntry& entry : kinds) {
            if (ImGui::Selectable(entry.label, state.settings.kind == entry.kind))
                state.settings.kind = entry.kind;
            note_item(entry.label);
        }
        ImGui::EndCombo();
    }
    ImGui::SameLine();
}

// Returns whether the plot is to be saved.
bool header(PlotsState& state, bool has_plot) {
    const float gap = ImGui::GetStyle().ItemInnerSpacing.x, cross = ImGui::GetFrameHeight();
    bool& logarithmic = state.settings.logarithmic[static_cast<std::size_t>(state.settings.kind)];
    const char* scale = logarithmic ? "Log##Plot scale" : "Lin##Plot scale";
    const float tools = padded("Log") + padded("Save plot\u2026") + cross + 2 * gap;
    const float right = ImGui::GetWindowContentRegionMax().x;
    const float room = right - ImGui::GetCursorPosX() - tools - 2 * gap;
    if (kinds_breadth() <= room)
        kind_buttons(state);
    else
        kind_menu(state, std::max(std::min(room, ImGui::GetFontSize() * 10), 1.0f));
    ImGui::SetCursorPosX(right - tools);
    if (button(scale, "How values become heights or colours: linear, or logarithmic over four decades.", true,
               padded("Log")))
        logarithmic = !logarithmic;
    ImGui::SameLine(0, gap);
    const bool save =
        button("Save plot\u2026##Save plot",
               "Save this plot as a drawing (.svg) or as a table of its numbers (.csv).", has_plot);
    ImGui::SameLine(0, gap);
    if (button("\u00d7##Close plots", "Close the plots.", true, cross)) state.open = false;
    return save;
}

void angle_row(const char* label, double low, double high, double reset, const char* about, double& value) {
    slider({.label = label,
            .low = low,
            .high = high,
            .least = low,
            .most = high,
            .reset = reset,
            .format = "%.1f\u00b0",
            .logarithmic = false,
            .tooltip = about},
           value);
}

void term_row(Term& term) {
    std::vector<const char*> labels;
    int index = 0;
    for (const TermInfo& one : all_terms()) {
        if (one.term == term) index = static_cast<int>(labels.size());
        labels.push_back(one.label);
    }
    if (combo("Term##Plot term", index, labels, info(term).meaning))
        term = all_terms()[static_cast<std::size_t>(index)].term;
}

bool has_settings(PlotKind kind) {
    return kind == PlotKind::lobe || kind == PlotKind::shape || kind == PlotKind::slice;
}

void settings_column(PlotSettings& settings) {
    const PlotSettings usual;
    term_row(settings.term);
    if (settings.kind == PlotKind::slice) {
        angle_row("\u03c6 of h##Plot azimuth", -180, 180, usual.azimuth,
                  "Azimuth of the half vector: along which it leans from the normal.", settings.azimuth);
        angle_row(
            "\u03c6d##Plot turn", -180, 180, usual.turn,
            "Azimuth of the light about the half vector: 90 is across its lean, where light and eye stand "
            "above the horizon at every angle.",
            settings.turn);
    } else {
        angle_row("Incidence##Plot incidence", 0, incidence_most, usual.incidence,
                  "Angle of the light k1 from the normal. Dragging in the polar plot sets it too.",
                  settings.incidence);
        angle_row("Azimuth##Plot azimuth", -180, 180, usual.azimuth,
                  "Toward which azimuth a mirror would send the light: the plane of incidence lies along it.",
                  settings.azimuth);
    }
}

}  // namespace

PlotsAnswer plots_panel(PlotsState& state, const PlotsContents& contents) {
    PlotsAnswer answer;
    answer.save = header(state, contents.plot != nullptr);
    const ImVec2 room = ImGui::GetContentRegionAvail();
    if (has_settings(state.settings.kind)) {
        const float breadth = std::min(ImGui::GetFontSize() * 19, room.x * 0.4f);
        ImGui::BeginChild("plot settings", ImVec2(breadth, room.y));
        settings_column(state.settings);
        ImGui::EndChild();
        ImGui::SameLine(0, ImGui::GetFontSize() * 1.4f);
    }
    if (contents.plot != nullptr)
        answer.reading = plot_view(state, *contents.plot, contents.slice);
    else
        dim_text(contents.waiting);
    return answer;
}

float plots_switch_width() { return ImGui::CalcTextSize("Plots").x + ImGui::GetFontSize() * 1.3f; }

void plots_switch(PlotsState& state) {
    const float size = ImGui::GetFontSize(), breadth = plots_switch_width();
    ImGui::SameLine(ImGui::GetWindowWidth() - breadth - ImGui::GetStyle().WindowPadding.x);
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    if (ImGui::InvisibleButton("Plots", ImVec2(breadth, size))) state.open = !state.open;
    note_item("Plots");
    tooltip_for_item("Open or close the plots: albedo, masking, p, Fresnel, the lobe and the slice.");
    const Colour& colour = state.open               ? palette::accent_bright
                           : ImGui::IsItemHovered() ? palette::text
                                                    : palette::text_dim;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float heights[] = {0.4f, 0.85f, 0.6f};
    for (int i = 0; i < 3; ++i) {
        const float left = corner.x + static_cast<float>(i) * size * 0.32f;
        list.AddRectFilled({left, corner.y + size * (0.95f - heights[i])},
                           {left + size * 0.22f, corner.y + size * 0.95f}, ImGui::GetColorU32(colour));
    }
    list.AddText({corner.x + size * 1.3f, corner.y}, ImGui::GetColorU32(colour), "Plots");
}

}  // namespace nacre::ui
