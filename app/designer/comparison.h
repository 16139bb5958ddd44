// Snapshots of the design, and what is seen beside what.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/designer/preview_pane.h"
#include "app/designer/side_job.h"
#include "app/designer/thumbnails.h"
#include "ui/compare_panel.h"

namespace nacre {

// A design as it was when it was taken, with its final tables where they were at hand.
struct Snapshot {
    int id;
    std::string letter;  // A to Z, then AA
    std::string name;
    Design design;
    std::shared_ptr<const Tables> tables;
};

// The design as it is in this frame, and what was baked of it.
struct PresentDesign {
    const Design& design;
    std::shared_ptr<const Tables> tables;  // final ones of just this design, or null
    bool settled = true;
};

class Comparison {
  public:
    // `notify` is called on a worker's thread when there is something to follow.
    explicit Comparison(int bake_threads, const std::function<void()>& notify = {});

    ui::CompareState state;

    const std::vector<Snapshot>& snapshots() const { return snapshots_; }
    ImTextureID picture_of(const std::string& letter) const { return thumbnails_.texture(letter); }
    void take(const PresentDesign& present);
    void remove(std::size_t snapshot);

    // The panel. Returns the design of a snapshot that is to be restored.
    std::optional<Design> draw_panel(const PresentDesign& present, const Scene& scene,
                                     const PreviewPane& pane);

    // The other of A and B, in place of the design: the side that is a snapshot, the left one first; or what
    // else a shown comparison has beside the design. False where there is none. An edit ends it.
    bool show_other(const Design& present);
    void show_present() { other_.reset(); }
    bool shows_other() const { return other_.has_value(); }

    // Tells the pane what stands at its sides, and asks the workers for what is missing. Never waits.
    void follow(const PresentDesign& present, const Scene& scene, PreviewPane& pane);

    // Whether one of the sides is a model that has no factors.
    bool shows_model() const;

    // Why a side cannot be shown, in plain words; empty when both can.
    std::string problem() const;
    bool busy() const { return jobs_[0].busy() || jobs_[1].busy(); }
    bool in_motion() const { return thumbnails_.busy(); }  // a picture comes that nobody is woken for
    void wait() const;

  private:
    int side(int index) const { return index == 0 ? state.left : state.right; }
    const Snapshot* snapshot_of(int id) const;
    std::optional<int> other_side() const;
    void answer(const ui::SnapshotRequest& request, const PresentDesign& present);
    std::string label_of_side(int index) const;
    std::vector<ui::SideChoice> choices(const Scene& scene) const;
    void follow_side(int index, const PresentDesign& present, const Scene& scene, PreviewPane& pane);

    std::vector<Snapshot> snapshots_;
    Thumbnails thumbnails_;  // of them
    int taken_ = 0;
    std::optional<Design> other_;  // while the other is shown: the design that it was asked for beside
    SideJob jobs_[2];
    std::optional<int> asked_[2];                    // the choice that each worker was last asked for
    std::optional<int> shown_[2];                    // the choice that the pane shows at each side, ...
    std::shared_ptr<const Tables> shown_tables_[2];  // ... and its tables, where they came from a snapshot
};

}  // namespace nacre
