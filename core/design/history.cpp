#include "core/design/history.h"

#include <algorithm>
#include <set>
#include <utility>

#include "core/design/design_pictures.h"

namespace nacre {

History::History(Design design, std::string what) { push({std::move(design), 0, std::move(what)}); }

void History::commit(const Design& design, const std::string& what) {
    if (design != current()) push({design, document(), what});
}

void History::begin(const Design& design, const std::string& what) {
    push({design, documents_++, what});
    mark_saved();
}

void History::push(State state) {
    if (!states_.empty()) states_.resize(position_ + 1);
    state.number = numbers_++;
    states_.push_back(std::move(state));
    while (states_.size() > steps_max + 1 || (states_.size() > 2 && pixels() > pixels_max))
        states_.pop_front();
    position_ = states_.size() - 1;
    std::erase_if(saved_, [this](const auto& saved) {
        return std::ranges::find(states_, saved.first, &State::document) == states_.end();
    });
}

// Of all pictures that the states hold; states share those that did not change between them.
std::size_t History::pixels() const {
    std::set<std::shared_ptr<const Raster>> rasters;
    for (const State& state : states_)
        for_each_picture(state.design,
                         [&](const Picture& picture, const std::string&) { rasters.insert(picture.raster); });
    std::size_t sum = 0;
    for (const auto& raster : rasters)
        if (raster) sum += raster->values.size();
    return sum;
}

bool History::is_saved(const State& state) const {
    const auto saved = saved_.find(state.document);
    return saved != saved_.end() && saved->second == state.design;
}

std::vector<const History::State*> History::unsaved_elsewhere() const {
    std::vector<const State*> unsaved;
    std::set<int> seen{document()};
    for (auto state = states_.rbegin(); state != states_.rend(); ++state)
        if (seen.insert(state->document).second && !is_saved(*state)) unsaved.push_back(&*state);
    return unsaved;
}

void History::undo() {
    if (can_undo()) --position_;
}

void History::redo() {
    if (can_redo()) ++position_;
}

void History::go_to(std::uint64_t number) {
    const auto found = std::ranges::find(states_, number, &State::number);
    if (found != states_.end()) position_ = static_cast<std::size_t>(found - states_.begin());
}

}  // namespace nacre
