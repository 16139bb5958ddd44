// Does a design obey the physics that its model promises?
#pragma once

#include <functional>
#include <stop_token>
#include <string>
#include <vector>

#include "core/design/design.h"

namespace nacre {

enum class Verdict { pass, fail, note };  // a note reports something that breaks nothing

struct PhysicsCheck {
    std::string name;
    Verdict verdict = Verdict::pass;
    double figure = 0;
    double bound = 0;  // the most that the figure may be
    std::string text;  // what the figure is
};

struct PhysicsReport {
    std::vector<PhysicsCheck> checks;
    bool passed() const;
};

// Throws what bake() throws; BakeCancelled soon after `stop` is requested.
PhysicsReport check_physics(const Design& design, std::stop_token stop = {},
                            const std::function<void(double)>& progress = {});

}  // namespace nacre
