// A lobe that is a set of facets with patches round them: one that holds a picture.
#pragma once

#include <functional>

#include "core/model/lobe.h"
#include "core/model/pyramid_kernel.h"

namespace nacre {

class FacetLobe : public LobeModel {
  public:
    std::vector<LobeParameterization> spans() const override { return {}; }

    // All facets in the lobe's frame, sixteen at a time.
    virtual void visit_leaves(const std::function<void(const LeafBlock&)>& visit) const = 0;
};

}  // namespace nacre
