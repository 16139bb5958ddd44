// Undo and redo: the designs that were, in order.
#pragma once

#include <deque>
#include <optional>

#include "core/design/design.h"

namespace nacre {

class History {
  public:
    static constexpr std::size_t steps_max = 200;                     // undo steps that are kept ...
    static constexpr std::size_t pixels_max = std::size_t{64} << 20;  // ... with no more pixels, 256 MiB

    explicit History(Design design);

    const Design& current() const { return states_[position_]; }

    // A design equal to the current one adds no step; any other drops what could be redone.
    void commit(const Design& design);

    bool can_undo() const { return position_ > 0; }
    bool can_redo() const { return position_ + 1 < states_.size(); }
    void undo();  // without effect where there is nothing to undo
    void redo();

    void mark_saved() { saved_ = current(); }
    void mark_unsaved() { saved_.reset(); }
    bool saved() const { return saved_ == current(); }  // the current design equals the one on disk

  private:
    std::size_t pixels() const;

    std::deque<Design> states_;
    std::size_t position_ = 0;
    std::optional<Design> saved_;
};

}  // namespace nacre
