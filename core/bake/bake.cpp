#include "core/bake/bake.h"

#include "core/bake/baker.h"

namespace nacre {

std::shared_ptr<const Tables> bake(const Design& design, const BakeOptions& options, std::stop_token stop,
                                   const std::function<void(double)>& progress) {
    return Baker().bake(design, options, std::move(stop), progress);
}

}  // namespace nacre
