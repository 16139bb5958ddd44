// What a picture is taken for, on pictures of the kinds that are dropped.
#include "core/paint/picture_guess.h"

#include <doctest/doctest.h>

#include <cmath>
#include <functional>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <numbers>
#include <random>

#include "core/paint/normal_map.h"

using namespace nacre;

namespace {

// `colour` of x and y from 0 to 1, y downward; 8 bits a channel where it is encoded.
ColourPicture picture_of(glm::ivec2 size, bool encoded, const std::function<glm::vec3(glm::vec2)>& colour) {
    ColourPicture picture{size.x, size.y, {}, 3, encoded};
    for (int row = 0; row < size.y; ++row)
        for (int column = 0; column < size.x; ++column) {
            glm::vec3 c = colour((glm::vec2(column, row) + 0.5f) / glm::vec2(size));
            if (encoded) c = glm::round(glm::clamp(c, 0.0f, 1.0f) * 255.0f) / 255.0f;
            picture.colours.push_back(c);
        }
    return picture;
}

ImportUse guess(const ColourPicture& picture) {
    const PictureGuess found = likely_use(picture_statistics(picture, look_at_normal_map(picture).reading));
    CHECK(found.why.size() > 5);
    return found.use;
}

// Bumps of some 30 degrees.
glm::vec3 bumps(glm::vec2 at) {
    const float turns = 2 * std::numbers::pi_v<float> * 6;
    return glm::normalize(glm::vec3(0.6f * std::cos(turns * at.x), 0.6f * std::cos(turns * at.y), 1.0f));
}

glm::vec3 encoded_normal(glm::vec3 n) { return 0.5f * n + 0.5f; }

}  // namespace

TEST_CASE("picture guess: maps of normals, encoded, flat, signed or of two channels") {
    CHECK(guess(picture_of({64, 64}, true, [](glm::vec2 at) { return encoded_normal(bumps(at)); })) ==
          ImportUse::normals);
    CHECK(guess(picture_of({64, 64}, true, [](glm::vec2) { return glm::vec3(0.5f, 0.5f, 1); })) ==
          ImportUse::normals);
    CHECK(guess(picture_of({128, 64}, false, bumps)) == ImportUse::normals);
    ColourPicture two = picture_of({64, 64}, false, bumps);
    for (glm::vec3& c : two.colours) c.z = 0;
    two.channels = 2;
    CHECK(guess(two) == ImportUse::normals);
    // As a lossy format leaves it, a few degrees off.
    std::mt19937 random(3);
    std::normal_distribution<float> off(0, 0.015f);
    CHECK(guess(picture_of({64, 64}, true, [&](glm::vec2 at) {
              return encoded_normal(bumps(at)) + glm::vec3(off(random), off(random), off(random));
          })) == ImportUse::normals);
}

TEST_CASE("picture guess: blue alone makes no map of normals, nor do normals of all directions") {
    const auto sky = [](glm::vec2 at) {
        return glm::mix(glm::vec3(0.2f, 0.42f, 0.85f), glm::vec3(0.72f, 0.82f, 0.95f), at.y);
    };
    CHECK(guess(picture_of({300, 200}, true, sky)) != ImportUse::normals);
    // In the object's space, of a ball.
    const auto ball = [](glm::vec2 at) {
        const float theta = std::numbers::pi_v<float> * at.y, phi = 2 * std::numbers::pi_v<float> * at.x;
        return encoded_normal(
            {std::sin(theta) * std::cos(phi), std::cos(theta), std::sin(theta) * std::sin(phi)});
    };
    CHECK(guess(picture_of({64, 64}, true, ball)) != ImportUse::normals);
}

TEST_CASE("picture guess: an environment is twice as wide as high") {
    const auto sky = [](glm::vec2 at) {
        const float sun = std::exp(-400 * glm::dot(at - 0.3f, at - 0.3f));
        return glm::mix(glm::vec3(0.2f, 0.5f, 1.1f), glm::vec3(0.3f, 0.25f, 0.2f), at.y) + 900 * sun;
    };
    CHECK(guess(picture_of({256, 128}, false, sky)) == ImportUse::environment);
    CHECK(guess(picture_of({128, 128}, false, sky)) != ImportUse::environment);
    CHECK(guess(picture_of({1024, 512}, true, sky)) == ImportUse::environment);
    CHECK(guess(picture_of({256, 128}, true, sky)) != ImportUse::environment);
}

TEST_CASE(
    "picture guess: a logo on nothing and a mask are stamps, grey is heights, a disk on black a modulation") {
    const auto inside = [](glm::vec2 at, float radius) { return glm::length(at - 0.5f) < radius; };
    ColourPicture logo = picture_of({64, 64}, true, [&](glm::vec2 at) {
        return inside(at, 0.3f) ? glm::vec3(0.8f, 0.1f, 0.1f) : glm::vec3(0);
    });
    for (const glm::vec3& c : logo.colours) logo.alpha.push_back(c.x > 0 ? 1.0f : 0.0f);
    CHECK(guess(logo) == ImportUse::stamp);
    CHECK(guess(picture_of({64, 64}, true, [&](glm::vec2 at) {
              return glm::vec3(inside(at, 0.3f) ? 1.0f : 0.0f);
          })) == ImportUse::stamp);
    const auto weave = [](glm::vec2 at) {
        const float turns = 2 * std::numbers::pi_v<float> * 8;
        return glm::vec3(0.5f + 0.25f * std::sin(turns * at.x) + 0.2f * std::sin(turns * at.y));
    };
    CHECK(guess(picture_of({128, 128}, true, weave)) == ImportUse::heights);
    CHECK(guess(picture_of({128, 64}, true, weave)) == ImportUse::heights);
    CHECK(guess(picture_of({128, 128}, true, [&](glm::vec2 at) {
              return inside(at, 0.5f) ? glm::vec3(0.3f + 0.5f * at.x) : glm::vec3(0);
          })) == ImportUse::modulation);
    // A photograph: its light.
    CHECK(guess(picture_of({300, 200}, true, [](glm::vec2 at) {
              return glm::vec3(at.x, 0.3f + 0.5f * at.y, 0.4f * at.x * at.y);
          })) == ImportUse::stamp);
}

TEST_CASE("picture guess: what is transparent does not count") {
    ColourPicture map = picture_of({64, 64}, true, [](glm::vec2 at) { return encoded_normal(bumps(at)); });
    map.alpha.assign(map.colours.size(), 1);
    for (std::size_t i = 0; i < map.colours.size() / 3; ++i)
        map.colours[i] = glm::vec3(0.3f), map.alpha[i] = 0;
    CHECK(guess(map) == ImportUse::normals);
    const PictureStatistics found = picture_statistics(map, {});
    CHECK(found.clear == doctest::Approx(1.0 / 3).epsilon(0.01));
    CHECK(found.normals > 0.99);
    CHECK(found.blue > 0.8);
    CHECK(found.tilt < 0.05);
}
