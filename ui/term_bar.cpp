#include "ui/term_bar.h"

#include <imgui.h>

#include <string>
#include <vector>

#include "ui/item_map.h"
#include "ui/theme.h"
#include "ui/widgets.h"

namespace nacre::ui {
namespace {

void choice(const TermInfo& candidate, Term& term, bool possible) {
    const bool chosen = candidate.term == term;
    if (chosen) ImGui::PushStyleColor(ImGuiCol_Button, palette::accent_dim);
    ImGui::BeginDisabled(!possible);
    if (ImGui::Button(candidate.label)) term = candidate.term;
    ImGui::EndDisabled();
    if (chosen) ImGui::PopStyleColor();
    note_item(std::string("Show ") + candidate.name);
    tooltip_for_item(possible ? candidate.meaning
                              : "The model at one of the sides is not made of these factors: it shows as a "
                                "whole, its specular part or its diffuse part.");
}

// Where the row is too narrow for buttons.
void list(Term& term, bool factors, const std::vector<const TermInfo*>& terms) {
    ImGui::SetNextItemWidth(-ImGui::GetStyle().ItemSpacing.x);
    const bool open = ImGui::BeginCombo("##term", info(term).label);
    note_item("Shown term");
    tooltip_for_item(info(term).meaning);
    if (!open) return;
    for (const TermInfo* candidate : terms) {
        ImGui::BeginDisabled(!factors && is_factor(candidate->term));
        if (ImGui::Selectable(candidate->label, candidate->term == term)) term = candidate->term;
        ImGui::EndDisabled();
        note_item(std::string("Show ") + candidate->name);
        tooltip_for_item(candidate->meaning);
    }
    ImGui::EndCombo();
}

}  // namespace

void term_bar(Term& term, const ShadingKinds& kinds, bool factors, bool expert) {
    const auto shown = [&](Term candidate) {
        return candidate == term || (has_term(kinds, candidate) && (expert || !is_factor(candidate)));
    };
    std::vector<const TermInfo*> terms;
    for (const TermInfo& candidate : all_terms())
        if (shown(candidate.term)) terms.push_back(&candidate);
    const float gap = ImGui::GetStyle().ItemInnerSpacing.x;
    float needed = 2 * gap;
    for (const TermInfo* candidate : terms) needed += button_width(candidate->label) + gap;
    ImGui::SetCursorPos({ImGui::GetCursorPosX() + gap, ImGui::GetCursorPosY() + gap});
    if (needed > ImGui::GetContentRegionAvail().x) return list(term, factors, terms);
    for (const TermInfo* candidate : terms) {
        if (candidate != terms.front()) ImGui::SameLine(0, gap);
        choice(*candidate, term, factors || !is_factor(candidate->term));
    }
}

}  // namespace nacre::ui
