#include "core/design/history.h"

#include <utility>

namespace nacre {

History::History(Design design) { states_.push_back(std::move(design)); }

void History::commit(const Design& design) {
    if (design == current()) return;
    states_.resize(position_ + 1);
    states_.push_back(design);
    if (states_.size() > steps_max + 1) states_.pop_front();
    position_ = states_.size() - 1;
}

void History::undo() {
    if (can_undo()) --position_;
}

void History::redo() {
    if (can_redo()) ++position_;
}

}  // namespace nacre
