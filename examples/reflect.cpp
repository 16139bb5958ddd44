// reflect DESIGN K1X K1Y K1Z K2X K2Y K2Z: the BRDF of a pair of directions, then how much of the light from
// k1 is reflected, found by sampling, beside what the baked tables say.
#include <cstdio>
#include <cstdlib>

#include "core/nacre.h"

int main(int count, char** words) try {
    if (count != 8) {
        std::fprintf(stderr, "usage: reflect DESIGN K1X K1Y K1Z K2X K2Y K2Z\n");
        return 2;
    }
    const auto number = [&](int i) { return std::strtod(words[i], nullptr); };
    const nacre::dvec3 k1 = glm::normalize(nacre::dvec3(number(2), number(3), number(4)));
    const nacre::dvec3 k2 = glm::normalize(nacre::dvec3(number(5), number(6), number(7)));

    const nacre::Brdf brdf(nacre::bake(nacre::load_design(words[1]), {.albedo = true}));
    const nacre::dvec3 rho = brdf.evaluate(k1, k2);
    std::printf("%.9g %.9g %.9g\n", rho.x, rho.y, rho.z);

    nacre::Random random(1);
    constexpr int samples = 100000;
    nacre::dvec3 reflected(0);
    for (int i = 0; i < samples; ++i)
        if (const auto sample = brdf.sample(k1, random)) reflected += sample->weight / double(samples);
    const nacre::dvec3 albedo = brdf.total_albedo(k1);
    std::printf("%.4f %.4f %.4f\n%.4f %.4f %.4f\n", reflected.x, reflected.y, reflected.z, albedo.x, albedo.y,
                albedo.z);
} catch (const std::exception& error) {
    std::fprintf(stderr, "reflect: %s\n", error.what());
    return 1;
}
