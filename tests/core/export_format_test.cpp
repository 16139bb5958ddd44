// What every export format says of itself.
#include "core/formats/export_format.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <stop_token>
#include <type_traits>
#include <vector>

#include "core/design/design_file.h"

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

TEST_CASE("export: the progress rises and reaches its end when all is done") {
    std::stop_source stop;
    std::vector<double> values;
    const auto note = [&](double done) {
        values.push_back(done);
        if (done >= 1) stop.request_stop();  // there is nothing left to stop
    };
    const Design design = load_design(NACRE_SOURCE_DIR "/presets/satin.nacre");
    CHECK_NOTHROW(exr_format.prepare(design, {}, stop.get_token(), note));
    CHECK(std::is_sorted(values.begin(), values.end()));
    CHECK(values.back() <= 1);
    CHECK(values.size() > 4);
}
