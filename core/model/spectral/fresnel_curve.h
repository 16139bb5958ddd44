// The table that a Fresnel model without a short formula is evaluated from.
#pragma once

#include <deque>
#include <memory>
#include <mutex>

#include "core/model/fresnel/shader_fresnel.h"

namespace nacre {

inline constexpr int curve_intervals_min = 128, curve_intervals_max = 1024;

// `reflectance` at even places in the root of the cosine, clipped to 0 to 1: 128 intervals, and twice as
// many, up to 1024, until straight lines between the nodes are within 5e-4 half way.
FresnelCurve tabulated(const Reflectance& reflectance);

// The newest curves of one model, which a bake asks for again at each stroke of the brush.
template <class Model>
class CurveMemory {
  public:
    std::shared_ptr<const FresnelCurve> curve_of(const Model& model, double above) {
        {
            const std::scoped_lock lock(mutex_);
            for (const Kept& kept : kept_)
                if (kept.model == model && kept.above == above) return kept.curve;
        }
        auto curve = std::make_shared<const FresnelCurve>(tabulated(model.reflectance(above)));
        const std::scoped_lock lock(mutex_);
        kept_.push_front({model, above, curve});
        if (kept_.size() > 8) kept_.pop_back();
        return curve;
    }

  private:
    struct Kept {
        Model model;
        double above;  // index of what it lies in
        std::shared_ptr<const FresnelCurve> curve;
    };

    std::mutex mutex_;
    std::deque<Kept> kept_;
};

}  // namespace nacre
