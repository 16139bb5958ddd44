#include "app/cli/picture_options.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <charconv>
#include <cmath>

namespace nacre::cli {
namespace {

// Twice this, for the samples of a pixel, is a texture that every OpenGL 3.3 takes.
constexpr int size_max = 4096;

bool parse_side(std::string_view text, int smallest, int& side) {
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), side);
    return error == std::errc() && end == text.data() + text.size() && side >= smallest && side <= size_max;
}

bool parse_size(std::string_view text, int smallest, glm::ivec2& size) {
    const std::size_t cross = text.find('x');
    return cross != std::string_view::npos && parse_side(text.substr(0, cross), smallest, size.x) &&
           parse_side(text.substr(cross + 1), smallest, size.y);
}

}  // namespace

void add_size_option(Command& command, glm::ivec2& size, int smallest) {
    const std::string allowed = fmt::format("must be WIDTHxHEIGHT, {} to {} pixels each", smallest, size_max);
    command.option_read_by([=, &size](const std::string& text) { return parse_size(text, smallest, size); },
                           "--size", "WxH", allowed, fmt::format("pixels (default {}x{})", size.x, size.y));
}

Scene SceneOptions::scene() const {
    Scene scene = scene_by_name(name).value_or(Scene{});
    if (light.size() == 2) {
        scene.light.theta = light[0];
        scene.light.phi = light[1];
    }
    scene.exposure = exposure;
    scene.term = term_by_name(term).value_or(Term::total);
    return scene;
}

void add_scene_options(Command& command, SceneOptions& options) {
    command
        .option("--scene", options.name,
                fmt::format("{} (default {})", fmt::join(scene_names(), ", "), options.name))
        .one_of(scene_names());
    command
        .option("--light", options.light,
                "where the light stands, degrees: theta from the viewer, phi from right toward up")
        .pair("THETA,PHI")
        .finite_within(-360, 360);
    command.option("--exposure", options.exposure, "EV (default 0)").finite_within(-20, 20);
    command
        .option("--term", options.term,
                fmt::format("what of the BRDF is shown: {} (default total)", fmt::join(term_names(), ", ")))
        .one_of(term_names());
}

}  // namespace nacre::cli
