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

// What its button shows, and after ## its name.
std::string label_of(PlotKind kind) { return std::string(info(kind).label) + "##Plot " + name_of(kind); }

float padded(const char* text) { return ImGui::CalcTextSize(text).x + 2 * ImGui::GetStyle().FramePadding.x; }

float kinds_width() {
    float width = 0;
    for (const PlotKind kind : plot_kinds)
        width += padded(info(kind).label) + ImGui::GetStyle().ItemInnerSpacing.x;
    return width;
}

void kind_buttons(PlotsState& state) {
    for (const PlotKind kind : plot_kinds) {
        const bool chosen = state.settings.kind == kind;
        ImGui::PushStyleColor(ImGuiCol_Button, chosen ? palette::accent_dim : Colour{0, 0, 0, 0});
        if (button(label_of(kind).c_str(), info(kind).about)) state.settings.kind = kind;
        ImGui::PopStyleColor();
        ImGui::SameLine(0, ImGui::GetStyle().ItemInnerSpacing.x);
    }
}

// In place of the buttons where they have no room.
void kind_menu(PlotsState& state, float width) {
    const PlotInfo& chosen = info(state.settings.kind);
    ImGui::SetNextItemWidth(width);
    const bool open = ImGui::BeginCombo("##Plot kind", chosen.label);
    note_item("Plot kind");
    tooltip_for_item(chosen.about);
    if (open) {
        for (const PlotKind kind : plot_kinds) {
            const std::string label = label_of(kind);
            if (ImGui::Selectable(label.c_str(), state.settings.kind == kind)) state.settings.kind = kind;
            note_item(label);
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
    if (kinds_width() <= room)
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

void angle_row(const PlotAngle& angle, PlotSettings& settings) {
    const std::string label = std::string(angle.label) + "##Plot " + angle.name;
    slider({.label = label.c_str(),
            .low = angle.low,
            .high = angle.high,
            .least = angle.low,
            .most = angle.high,
            .reset = PlotSettings{}.*angle.member,
            .format = "%.1f\u00b0",
            .logarithmic = false,
            .tooltip = angle.about},
           settings.*angle.member);
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

bool has_settings(const PlotInfo& kind) { return kind.has_term || !kind.angles.empty(); }

void settings_column(PlotSettings& settings) {
    const PlotInfo& kind = info(settings.kind);
    if (kind.has_term) term_row(settings.term);
    for (const PlotAngle& angle : kind.angles) angle_row(angle, settings);
}

}  // namespace

PlotsAnswer plots_panel(PlotsState& state, const PlotsContents& contents) {
    PlotsAnswer answer;
    answer.save = header(state, contents.plot != nullptr);
    const ImVec2 room = ImGui::GetContentRegionAvail();
    if (has_settings(info(state.settings.kind))) {
        const float width = std::min(ImGui::GetFontSize() * 19, room.x * 0.4f);
        ImGui::BeginChild("plot settings", ImVec2(width, room.y));
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
    const float size = ImGui::GetFontSize(), width = plots_switch_width();
    ImGui::SameLine(ImGui::GetWindowWidth() - width - ImGui::GetStyle().WindowPadding.x);
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    if (ImGui::InvisibleButton("Plots", ImVec2(width, size))) state.open = !state.open;
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
