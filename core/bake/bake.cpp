#include "core/bake/bake.h"

#include "core/bake/baker.h"

namespace nacre {

std::vector<BakeOptions> bake_steps(const Design& design) {
    std::vector<BakeOptions> steps{{.quality = Quality::draft}, {.fit_bounces = false}};
    if (is_fitted(design.multibounce)) steps.emplace_back();
    return steps;
}

std::shared_ptr<const Tables> bake(const Design& design, const BakeOptions& options, std::stop_token stop,
                                   const std::function<void(double)>& progress) {
    return Baker().bake(design, options, std::move(stop), progress);
}

}  // namespace nacre
