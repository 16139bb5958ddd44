#include "app/cli/picture_options.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "app/cli/output.h"
#include "app/cli/standard_input.h"
#include "core/base/error.h"
#include "core/formats/environment_file.h"
#include "core/light/procedural.h"

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

std::shared_ptr<const Environment> load_environment_named(const std::string& name) {
    if (name != stream_name) return load_environment(name);
    const MemoryFile input = spooled_input();
    try {
        return load_environment(input.path());
    } catch (const UserError& error) {
        throw UserError(standard_input, error.where, error.problem, error.found);
    }
}

}  // namespace

void add_size_option(Command& command, glm::ivec2& size, int smallest) {
    const std::string allowed = fmt::format("must be WIDTHxHEIGHT, {} to {} pixels each", smallest, size_max);
    command.option_read_by([=, &size](const std::string& text) { return parse_size(text, smallest, size); },
                           "--size", "WxH", allowed, fmt::format("pixels (default {}x{})", size.x, size.y));
}

std::vector<std::filesystem::path> SceneOptions::files() const {
    std::vector<std::filesystem::path> files;
    const std::vector<std::string> objects = object_names();
    if (std::find(objects.begin(), objects.end(), object) == objects.end()) files.emplace_back(object);
    const auto& known = procedural_environments();
    const auto is_this = [&](const ProceduralEnvironment* each) { return each->name == environment; };
    if (environment == stream_name)
        files.emplace_back("/dev/stdin");
    else if (!environment.empty() && std::none_of(known.begin(), known.end(), is_this))
        files.emplace_back(environment);
    return files;
}

Scene SceneOptions::scene() const {
    Scene scene = scene_by_name(name.empty() ? "single" : name).value_or(Scene{});
    if (light.size() == 2) {
        scene.light.theta = light[0];
        scene.light.phi = light[1];
    }
    scene.exposure = exposure;
    scene.object = make_object(object);
    if (!scene.object.note.empty()) warn(object, scene.object.note);
    if (!environment.empty()) {
        scene.environment = {load_environment_named(environment), rotation, brightness, backdrop,
                             !name.empty() || !light.empty()};
        for (const std::string& note : scene.environment.picture->notes) warn(environment, note);
    }
    scene.term = term_by_name(term).value_or(Term::total);
    return scene;
}

void add_scene_options(Command& command, SceneOptions& options) {
    command.option_read_by(
        [&options](const std::string& text) {
            options.object = text;
            return names_object(text);
        },
        "--object", "NAME|FILE.obj",
        fmt::format("must be {} or the path of an .obj file", fmt::join(object_names(), ", ")),
        fmt::format("{} or an OBJ file (default {})", fmt::join(object_names(), ", "), options.object));
    command
        .option("--scene", options.name, fmt::format("{} (default single)", fmt::join(scene_names(), ", ")))
        .one_of(scene_names());
    command
        .option("--light", options.light,
                "where the light stands, degrees: theta from the viewer, phi from right toward up")
        .pair("THETA,PHI")
        .within(-360, 360);
    command.option("--exposure", options.exposure, "EV (default 0)").within(-20, 20);
    std::vector<std::string> names;
    for (const ProceduralEnvironment* known : procedural_environments()) names.emplace_back(known->name);
    command.option(
        "--environment", options.environment,
        fmt::format("light from all around in place of the lights: {}, or a lat-long picture; - is "
                    "standard input",
                    fmt::join(names, ", ")));
    command.option("--rotation", options.rotation, "turns the environment to the right, degrees (default 0)")
        .within(-360, 360);
    command.option("--brightness", options.brightness, "factor of the environment (default 1)")
        .within(0, 1e4);
    command.flag("--backdrop", options.backdrop, "shows the environment behind the object");
    command.option("--samples", options.samples, "a pixel, of the environment's light (default 256)")
        .within(1, 65536);
    command
        .option("--term", options.term,
                fmt::format("what of the BRDF is shown: {} (default total)", fmt::join(term_names(), ", ")))
        .one_of(term_names());
}

}  // namespace nacre::cli
