// Properties of random designs, from a fixed seed, inside doctest.
#pragma once

#include <rapidcheck.h>

#include <functional>
#include <iostream>

#include "core/base/error.h"
#include "core/model/facet_distribution.h"
#include "tests/core/random_design.h"

namespace nacre::test {

// A random design whose facets face up; small pictures, so that a property runs often. For use in a property.
inline Design physical_design() {
    for (;;) {
        Design design = random_design({});
        try {
            FacetDistribution check(design.distribution);
            return design;
        } catch (const UserError&) {
        }
    }
}

inline bool holds(const char* what, const std::function<void()>& property, int runs) {
    rc::detail::TestParams params;
    params.maxSuccess = runs;
    params.seed = 20000723;
    rc::detail::TestMetadata metadata;
    metadata.id = what;
    const auto result = rc::detail::checkTestable(property, metadata, params);
    rc::detail::printResultMessage(result, std::cerr);
    return result.is<rc::detail::SuccessResult>();
}

}  // namespace nacre::test
