#include "app/designer/comparison.h"

#include <fmt/core.h>

#include <algorithm>

namespace nacre {
namespace {

// Ids of the choices: the present design, the comparison models in their order, then snapshots as they are
// taken.
constexpr int present_id = 0, first_model = 1, first_snapshot = 100;

std::optional<ComparisonModel> opponent_of(int id) {
    const std::vector<ComparisonModel> all = all_comparison_models();
    const int index = id - first_model;
    if (index < 0 || index >= static_cast<int>(all.size())) return {};
    return all[static_cast<std::size_t>(index)];
}

int id_of(const ComparisonModel& wanted) {
    int id = first_model;
    while (*opponent_of(id) != wanted) ++id;
    return id;
}

bool is_model(int id) {
    const auto comparison_model = opponent_of(id);
    return comparison_model && std::holds_alternative<ClosedFormModel>(*comparison_model);
}

std::string letter_of(int number) {
    std::string letters(1, static_cast<char>('A' + number % 26));
    return number < 26 ? letters : letter_of(number / 26 - 1) + letters;
}

std::string title_of(const Snapshot& snapshot) {
    return snapshot.name.empty() ? snapshot.letter : snapshot.letter + ": " + snapshot.name;
}

bool serves(const std::shared_ptr<const Tables>& tables, const Scene& scene) {
    return tables && (tables->needs.albedo || !scene.ambient);
}

}  // namespace

Comparison::Comparison(int bake_threads, const std::function<void()>& notify)
    : jobs_{SideJob(bake_threads, notify), SideJob(bake_threads, notify)} {
    state.left = present_id;
    state.right = id_of(ClosedFormModel::ggx);
}

void Comparison::take(const PresentDesign& present) {
    snapshots_.push_back({.id = first_snapshot + taken_,
                          .letter = letter_of(taken_),
                          .name = present.design.name,
                          .design = present.design,
                          .tables = present.tables});
    ++taken_;
    if (state.view != ui::CompareView::off) return;
    state.left = snapshots_.back().id;
    state.right = present_id;
}

void Comparison::remove(std::size_t snapshot) {
    const int id = snapshots_[snapshot].id;
    for (int* side : {&state.left, &state.right})
        if (*side == id) *side = present_id;
    snapshots_.erase(snapshots_.begin() + static_cast<std::ptrdiff_t>(snapshot));
}

const Snapshot* Comparison::snapshot_of(int id) const {
    const auto found = std::find_if(snapshots_.begin(), snapshots_.end(),
                                    [id](const Snapshot& snapshot) { return snapshot.id == id; });
    return found == snapshots_.end() ? nullptr : &*found;
}

std::string Comparison::label_of_side(int index) const {
    std::string label = "Now";
    if (const Snapshot* snapshot = snapshot_of(side(index)))
        label = title_of(*snapshot);
    else if (const auto comparison_model = opponent_of(side(index)))
        label = label_of(*comparison_model);
    return shown_[index] == side(index) ? label : label + " (baking\u2026)";
}

std::optional<int> Comparison::other_side() const {
    for (int i = 0; i < 2; ++i)
        if (snapshot_of(side(i))) return i;
    for (int i = 0; i < 2; ++i)
        if (state.view != ui::CompareView::off && side(i) != present_id) return i;
    return {};
}

bool Comparison::show_other(const Design& present) {
    if (!other_side()) return false;
    other_ = present;
    return true;
}

bool Comparison::shows_model() const {
    return state.view != ui::CompareView::off && (is_model(state.left) || is_model(state.right));
}

std::vector<ui::SideChoice> Comparison::choices(const Scene& scene) const {
    std::vector<ui::SideChoice> all = {{present_id, "Now", "The design as it is edited."}};
    for (const Snapshot& snapshot : snapshots_)
        all.push_back({snapshot.id, title_of(snapshot), "As it was when this snapshot was taken."});
    int id = first_model;
    for (const ComparisonModel& comparison_model : all_comparison_models()) {
        const bool model = is_model(id);
        std::string about = citation_of(comparison_model) + ".\n";
        about += model ? "The model with the median facet slope of p, and with the design's own Fresnel "
                         "factor and diffuse term."
                       : "The design's own p, with this masking in place of its own.";
        if (comparison_model == ComparisonModel(ClosedFormModel::oren_nayar))
            about = citation_of(comparison_model) +
                    ".\nA matt surface of rough facets, whose angles spread as those of p and which is as "
                    "bright as the design on the whole. It has no highlight.";
        const bool possible = !model || !is_factor(scene.term);
        if (!possible) about = "It is not made of factors: show All, Specular or Diffuse to compare with it.";
        all.push_back({id++, label_of(comparison_model), about, possible});
    }
    return all;
}

std::optional<Design> Comparison::draw_panel(const PresentDesign& present, const Scene& scene,
                                             const PreviewPane& pane) {
    std::vector<ui::SnapshotRow> rows;
    std::vector<Thumbnails::Wanted> wanted;
    for (const Snapshot& snapshot : snapshots_)
        wanted.push_back({snapshot.letter, [design = snapshot.design] { return design; }});
    thumbnails_.follow(wanted);
    for (Snapshot& snapshot : snapshots_)
        rows.push_back({snapshot.id, snapshot.letter, &snapshot.name, thumbnails_.texture(snapshot.letter)});
    std::string numbers = problem();
    if (numbers.empty() && state.view == ui::CompareView::difference && pane.difference()) {
        const DifferenceNumbers& apart = *pane.difference();
        numbers = fmt::format(
            "On the object, in linear radiance: root mean square {:.3g}, largest {:.3g}, relative to both "
            "pictures {:.3g} %.",
            apart.root_mean_square, apart.largest, 100 * apart.relative);
    }
    const auto request = ui::compare_panel(state, rows, choices(scene), numbers);
    if (!request) return {};
    if (request->action == ui::SnapshotAction::restore) return snapshots_[request->snapshot].design;
    answer(*request, present);
    return {};
}

void Comparison::answer(const ui::SnapshotRequest& request, const PresentDesign& present) {
    switch (request.action) {
        case ui::SnapshotAction::restore:
            break;
        case ui::SnapshotAction::take:
            take(present);
            break;
        case ui::SnapshotAction::remove:
            remove(request.snapshot);
            break;
        case ui::SnapshotAction::to_left:
            state.left = snapshots_[request.snapshot].id;
            break;
        case ui::SnapshotAction::to_right:
            state.right = snapshots_[request.snapshot].id;
            break;
    }
}

void Comparison::follow_side(int index, const PresentDesign& present, const Scene& scene, PreviewPane& pane) {
    const int id = side(index);
    const Snapshot* const snapshot = snapshot_of(id);
    if (id == present_id) {
        if (shown_[index] != id) pane.show_side(index, {});
        shown_[index] = id;
        return;
    }
    if (snapshot && serves(snapshot->tables, scene)) {
        if (shown_[index] != id || shown_tables_[index] != snapshot->tables)
            pane.show_side(index, ComparedSurface{snapshot->tables, nullptr});
        shown_[index] = id;
        shown_tables_[index] = snapshot->tables;
        return;
    }
    SideJob& job = jobs_[index];
    if (asked_[index] != id) job.forget();
    asked_[index] = id;
    job.want({.design = snapshot ? snapshot->design : present.design,
              .comparison_model = opponent_of(id),
              .albedo = scene.ambient,
              .settled = snapshot || present.settled});
    if (const auto surface = job.poll()) {
        pane.show_side(index, surface);
        shown_[index] = id;
        shown_tables_[index] = nullptr;
    }
}

void Comparison::follow(const PresentDesign& present, const Scene& scene, PreviewPane& pane) {
    CompareLook& look = pane.look;
    look.view = state.view;
    look.difference = {state.amplification, state.is_signed};
    const auto other = other_side();
    if (other_ && (!other || *other_ != present.design)) other_.reset();
    look.alone = other_ ? other : std::nullopt;
    if (!look.compares()) return;
    for (int i = 0; i < 2; ++i) follow_side(i, present, scene, pane);
    look.labels = {label_of_side(0), label_of_side(1)};
    if (state.view != ui::CompareView::difference || look.alone) return;
    look.labels[0] =
        fmt::format("{} \u2212 {}, \u00d7 {:.3g}", label_of_side(1), label_of_side(0), state.amplification);
    look.labels[1] = pane.difference()
                         ? fmt::format("rms {:.3g}   {:.3g} %", pane.difference()->root_mean_square,
                                       100 * pane.difference()->relative)
                         : "";
}

std::string Comparison::problem() const {
    if (state.view == ui::CompareView::off && !other_) return {};
    for (int i = 0; i < 2; ++i)
        if (asked_[i] == side(i) && !jobs_[i].problem().empty()) return jobs_[i].problem();
    return {};
}

void Comparison::wait() const {
    for (const SideJob& job : jobs_) job.wait();
    thumbnails_.wait();
}

}  // namespace nacre
