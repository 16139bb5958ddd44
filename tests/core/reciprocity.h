// rho(k1, k2) = rho(k2, k1) to the last bit, whatever computes it.
#pragma once

#include <doctest/doctest.h>

#include <vector>

#include "core/bake/brdf.h"
#include "core/bake/brdf_pairs.h"
#include "core/model/float_shading.h"
#include "tests/core/random_directions.h"

namespace nacre::test {

// In double, in float, and side by side, which is what float gives one by one but for rounding.
inline void check_reciprocity(const std::shared_ptr<const Tables>& tables) {
    const Brdf brdf(tables);
    const Shading<float> shading = in_float(tables->shading);
    Random random(7);
    std::vector<glm::vec3> k1, k2;
    for (int i = 0; i < 500; ++i) {
        const dvec3 a = random_direction(random), b = i % 5 == 0 ? a : random_direction(random);
        CHECK(brdf.evaluate(a, b) == brdf.evaluate(b, a));
        k1.emplace_back(a);
        k2.emplace_back(b);
        CHECK(shading.brdf(k1.back(), k2.back()) == shading.brdf(k2.back(), k1.back()));
    }
    std::vector<glm::vec3> there(k1.size()), back(k1.size());
    evaluate_pairs(shading, k1, k2, there);
    evaluate_pairs(shading, k2, k1, back);
    for (std::size_t i = 0; i < k1.size(); ++i) {
        CHECK(there[i] == back[i]);
        for (int c = 0; c < 3; ++c)
            CHECK(there[i][c] == doctest::Approx(shading.brdf(k1[i], k2[i])[c]).epsilon(2e-5));
    }
}

}  // namespace nacre::test
