// Undo and redo: a list of designs. A design that replaces another, as a preset does, is a document of its
// own: whether one is saved says nothing about the other.
#pragma once

#include <deque>
#include <map>

#include "core/design/design.h"

namespace nacre {

class History {
  public:
    static constexpr std::size_t steps_max = 200;                     // undo steps that are kept ...
    static constexpr std::size_t pixels_max = std::size_t{64} << 20;  // ... with no more pixels, 256 MiB

    explicit History(Design design);

    const Design& current() const { return states_[position_].design; }
    int document() const { return states_[position_].document; }  // that the current design belongs to

    // A design equal to the current one adds no step; any other discards the steps that could be redone.
    void commit(const Design& design);

    // The design as a new document, in one step of undo. It counts as saved.
    void begin(const Design& design);

    bool can_undo() const { return position_ > 0; }
    bool can_redo() const { return position_ + 1 < states_.size(); }
    void undo();  // no effect where there is nothing to undo
    void redo();

    // Of the current document.
    void mark_saved() { saved_.insert_or_assign(document(), current()); }
    void mark_unsaved() { saved_.erase(document()); }
    bool saved() const { return is_saved(states_[position_]); }  // the current design equals the one on disk

    struct State {
        Design design;
        int document = 0;
    };
    // The newest design of another document that undo or redo would bring back, where it is not saved; null
    // where there is none.
    const State* unsaved_elsewhere() const;

  private:
    bool is_saved(const State& state) const;
    void push(State state);
    std::size_t pixels() const;

    std::deque<State> states_;
    std::size_t position_ = 0;
    std::map<int, Design> saved_;  // of each document what is on disk
    int documents_ = 1;
};

}  // namespace nacre
