#include "app/cli/picture_options.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
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

CLI::Validator finite_within(double low, double high) {
    return CLI::Validator(
        [=](std::string& text) {
            double value = 0;
            const bool within = CLI::detail::lexical_cast(text, value) && value >= low && value <= high;
            return within ? std::string() : fmt::format("{} is no number from {} to {}", text, low, high);
        },
        "");
}

}  // namespace

void add_size_option(CLI::App& command, glm::ivec2& size, int smallest) {
    const std::string allowed = fmt::format("must be WIDTHxHEIGHT, {} to {} pixels each", smallest, size_max);
    command
        .add_option_function<std::string>(
            "--size",
            [=, &size](const std::string& text) {
                if (!parse_size(text, smallest, size)) throw CLI::ValidationError("--size", allowed);
            },
            fmt::format("pixels (default {}x{})", size.x, size.y))
        ->type_name("WxH");
}

Scene SceneOptions::scene() const {
    Scene scene = scene_by_name(name).value_or(Scene{});
    if (light.size() == 2) {
        scene.light.theta = light[0];
        scene.light.phi = light[1];
    }
    scene.exposure = exposure;
    return scene;
}

void add_scene_options(CLI::App& command, SceneOptions& options) {
    command
        .add_option("--scene", options.name,
                    fmt::format("{} (default {})", fmt::join(scene_names(), ", "), options.name))
        ->check(CLI::IsMember(scene_names()));
    command
        .add_option("--light", options.light,
                    "where the light stands, degrees: theta from the viewer, phi from right toward up")
        ->delimiter(',')
        ->expected(2)
        ->type_name("THETA,PHI")
        ->check(finite_within(-360, 360));
    command.add_option("--exposure", options.exposure, "EV (default 0)")->check(finite_within(-20, 20));
}

}  // namespace nacre::cli
