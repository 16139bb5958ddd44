// What every export format says of itself.
#include "core/formats/export_format.h"

#include <doctest/doctest.h>

#include <type_traits>

using namespace nacre;

// A format that says no next step does not compile.
static_assert(!std::is_default_constructible_v<ExportFormat>);

TEST_CASE("export: each format tells what to do next, step by step") {
    for (const ExportFormat* format : export_formats()) {
        CAPTURE(format->name);
        const auto steps = next_steps(*format, "satin", "/drawn/a {b}\n.out");
        CHECK(!steps.empty());
        bool names_file = false;
        for (const std::string& step : steps) {
            CAPTURE(step);
            CHECK(step.size() > 10);
            CHECK(step.ends_with('.'));
            CHECK(step.find("/drawn/") == std::string::npos);
            names_file |= step.find("a {b}\\n.out") != std::string::npos;
        }
        CHECK(names_file);
    }
}

TEST_CASE("export: the next steps call the names that the file defines") {
    std::string all;
    for (const std::string& step : next_steps(glsl_format, "wood2", "w.glsl")) all += step + "\n";
    CHECK(all.find("wood2_brdf(") != std::string::npos);
    CHECK(all.find("nacre_") == std::string::npos);
}

TEST_CASE("export: a folder that is named with a slash at its end has a name still") {
    CHECK(next_steps(NextSteps("Read {file}."), "", "/drawn/tables/") ==
          std::vector<std::string>{"Read tables."});
}
