// Undo and redo: a list of designs. A design that replaces another, as a preset does, is a document of its
// own: whether one is saved says nothing about the other.
#pragma once

#include <cstdint>
#include <deque>
#include <map>
#include <string>
#include <vector>

#include "core/design/design.h"

namespace nacre {

class History {
  public:
    static constexpr std::size_t steps_max = 200;                     // undo steps that are kept ...
    static constexpr std::size_t pixels_max = std::size_t{64} << 20;  // ... with no more pixels, 256 MiB

    // `what` says in a few words what was done to make a design: "Paint", "Softness".
    History(Design design, std::string what);

    const Design& current() const { return states_[position_].design; }
    int document() const { return states_[position_].document; }  // that the current design belongs to

    // A design equal to the current one adds no step; any other discards the steps that could be redone.
    void commit(const Design& design, const std::string& what);

    // The design as a new document, in one step of undo. It counts as saved.
    void begin(const Design& design, const std::string& what);

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
        std::string what = {};
        std::uint64_t number = 0;  // of no other state of this history, ever
    };
    // From the oldest that is kept to the newest that could be redone.
    const std::deque<State>& states() const { return states_; }
    std::size_t position() const { return position_; }  // of the current one

    // Undoes or redoes until the state of this number is the current one; no effect where it is gone.
    void go_to(std::uint64_t number);

    // Of each other document the newest design that undo or redo would bring back, where it is not saved; the
    // newest first.
    std::vector<const State*> unsaved_elsewhere() const;

  private:
    bool is_saved(const State& state) const;
    void push(State state);
    std::size_t pixels() const;

    std::deque<State> states_;
    std::size_t position_ = 0;
    std::uint64_t numbers_ = 0;    // given
    std::map<int, Design> saved_;  // of each document what is on disk
    int documents_ = 1;
};

}  // namespace nacre
