#include "ui/balance_buttons.h"

#include "core/base/error.h"
#include "core/paint/balance.h"
#include "ui/canvas_path.h"
#include "ui/widgets.h"

namespace nacre::ui {
namespace {

constexpr double tilt_kept = 1e-5;  // degrees: what rounding leaves

bool is_tilted(const std::optional<dvec3>& mean) { return mean && polar_angle(*mean) > tilt_kept; }

}  // namespace

void balance_button(CanvasState& state, const std::optional<dvec3>& mean, Distribution& distribution) {
    if (!button(balance_text,
                "Change how many facets there are of each normal, as little as can be, so that their mean "
                "normal is n: p exp(\u03bb\u00b7h)/Z, the nearest to p in relative entropy. Paint fades on "
                "the heavier side and grows on the lighter; lobes change their weight and tilt a little. "
                "No part of the picture moves far: Straighten turns it as a whole instead.",
                is_tilted(mean)))
        return;
    try {
        distribution = balanced(distribution);
    } catch (const UserError& refused) {
        state.refusal = Refusal{*mean, refused.problem};
    }
}

void straighten_button(const std::optional<dvec3>& mean, Distribution& distribution) {
    if (button(
            straighten_text,
            "Turn all layers together by the smallest angle that brings the mean normal to n. While it "
            "is tilted, facets on one side show more area than the surface has, and Conserve energy limits "
            "what is seen of them.",
            is_tilted(mean)))
        straighten(distribution, *mean);
}

}  // namespace nacre::ui
