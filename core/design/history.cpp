#include "core/design/history.h"

#include <set>
#include <utility>

#include "core/design/design_pictures.h"

namespace nacre {

History::History(Design design) { states_.push_back(std::move(design)); }

void History::commit(const Design& design) {
    if (design == current()) return;
    states_.resize(position_ + 1);
    states_.push_back(design);
    while (states_.size() > steps_max + 1 || (states_.size() > 2 && pixels() > pixels_max))
        states_.pop_front();
    position_ = states_.size() - 1;
}

// Of all pictures that the states hold; states share those that did not change between them.
std::size_t History::pixels() const {
    std::set<std::shared_ptr<const Raster>> rasters;
    for (const Design& state : states_)
        for_each_picture(state,
                         [&](const Picture& picture, const std::string&) { rasters.insert(picture.raster); });
    std::size_t sum = 0;
    for (const auto& raster : rasters)
        if (raster) sum += raster->values.size();
    return sum;
}

void History::undo() {
    if (can_undo()) --position_;
}

void History::redo() {
    if (can_redo()) ++position_;
}

}  // namespace nacre
