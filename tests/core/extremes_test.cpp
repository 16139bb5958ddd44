// The sweep of extreme designs, and the mistakes that it must report.
#include <doctest/doctest.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/bake/bake.h"
#include "core/study/extreme_check.h"
#include "tests/core/cheap.h"
#include "tests/core/copied_tables.h"
#include "tests/core/designs.h"
#include "tests/core/random_directions.h"

using namespace nacre;
using namespace nacre::test;

namespace {

constexpr ExtremeOptions cheap_options{.pairs = 60,
                                       .probes = {.area = 20, .albedo = 1},
                                       .rings = {.polar = 1, .azimuths = 1},
                                       .plain_method = false};

std::vector<ExtremeCase> cases_of(const std::string& group) {
    std::vector<ExtremeCase> cases = extreme_cases();
    std::erase_if(cases, [&](const ExtremeCase& extreme) { return extreme.group != group; });
    return cases;
}

// Instrumented code takes ten times as long: every tenth case on few directions.
void check_group(const std::string& group) {
    std::vector<ExtremeCase> cases = cases_of(group);
    REQUIRE(!cases.empty());
    if (cheap) {
        std::size_t kept = 0;
        for (std::size_t i = 0; i < cases.size(); i += 10) cases[kept++] = cases[i];
        cases.resize(kept);
    }
    const std::vector<ExtremeResult> results = judge_all(cases, cheap ? cheap_options : ExtremeOptions{});
    for (std::size_t i = 0; i < cases.size(); ++i) {
        const std::string said =
            fmt::format("{}: {} {}", cases[i].name, results[i].refusal, fmt::join(results[i].faults, "; "));
        CHECK_MESSAGE(results[i].holds(), said);
    }
}

ExtremeCase named_case(const std::string& name) {
    const std::vector<ExtremeCase> cases = extreme_cases();
    const auto found =
        std::find_if(cases.begin(), cases.end(), [&](const ExtremeCase& c) { return c.name == name; });
    REQUIRE(found != cases.end());
    return *found;
}

// The case's tables after `change`, which gets a copy of their numbers.
template <class Change>
std::shared_ptr<const Tables> spoilt(const ExtremeCase& extreme, const Change& change) {
    const auto tables = copy_of(*bake(extreme.design, {.albedo = true}));
    change(*tables);
    return tables;
}

std::string faults_of(const ExtremeCase& extreme, const std::shared_ptr<const Tables>& tables) {
    return fmt::format("{}", fmt::join(judge_tables(extreme, tables, cheap_options).faults, "; "));
}

// `held` gives a design's kind of the set.
template <class Variant, class Held>
void check_ends(const std::vector<ExtremeCase>& cases, const Held& held) {
    KindSet<Variant>::each([&]<class T>() {
        std::vector<T> values;
        for (const ExtremeCase& extreme : cases) {
            const Variant variant = held(extreme.design);
            if (const T* value = std::get_if<T>(&variant)) values.push_back(*value);
        }
        CHECK_MESSAGE(!values.empty(), T::name);
        visit_parameters<T>([&]<class Parameter>(const Parameter& parameter) {
            if constexpr (std::is_same_v<Parameter, NumberParameter<T>>)
                for (const double end : {parameter.bounds.low, parameter.bounds.high})
                    CHECK_MESSAGE(std::any_of(values.begin(), values.end(),
                                              [&](const T& value) { return value.*parameter.member == end; }),
                                  fmt::format("{} {} {}", T::name, parameter.text.key, end));
        });
        return 0;
    });
}

bool mentions(const std::string& text, const char* what) { return text.find(what) != std::string::npos; }

}  // namespace

TEST_SUITE_BEGIN("extremes");

TEST_CASE("every lobe at the ends of its parameters") { check_group("lobes"); }
// Their bakes take the longest.
TEST_CASE("extreme ratios of widths" * doctest::skip(cheap)) { check_group("ratios"); }
TEST_CASE("extreme tilts and grooves") { check_group("tilts"); }
TEST_CASE("extreme mixtures") { check_group("mixtures"); }
TEST_CASE("extreme pictures") { check_group("pictures"); }
TEST_CASE("rho does not know the unit of p") { check_group("scales"); }
TEST_CASE("mean cosines near 0 and far from 1") { check_group("mean cosine"); }
TEST_CASE("every visibility, with and without clamp") { check_group("visibility"); }
TEST_CASE("extreme reflectances under every diffuse term") { check_group("materials"); }
TEST_CASE("intensities from none to the most") { check_group("intensity"); }
TEST_CASE("tints that differ as much as they can") { check_group("tints"); }
TEST_CASE("light that goes back from p that lean") { check_group("retro"); }

TEST_CASE("multiple bounces where hardly any light stays, and where hardly any leaves" *
          doctest::skip(cheap)) {
    check_group("bounces");
}

TEST_CASE("matt facets where p is narrow, leans, or is all but a sphere") { check_group("matt facets"); }

TEST_CASE("coats of every index, roughness and colour") { check_group("coat"); }

TEST_CASE("no case stands outside the groups that are tested, and names are told apart") {
    std::size_t count = 0;
    for (const char* group :
         {"lobes", "ratios", "tilts", "mixtures", "pictures", "scales", "mean cosine", "visibility",
          "materials", "intensity", "tints", "retro", "bounces", "matt facets", "coat"})
        count += cases_of(group).size();
    std::vector<std::string> names;
    for (const ExtremeCase& extreme : extreme_cases()) names.push_back(extreme.group + extreme.name);
    CHECK(count == names.size());
    std::sort(names.begin(), names.end());
    CHECK(std::adjacent_find(names.begin(), names.end()) == names.end());
}

TEST_CASE("every kind is in the sweep, each of its numbers at both ends") {
    const std::vector<ExtremeCase> cases = extreme_cases();
    check_ends<Lobe>(cases, [](const Design& d) { return d.distribution.layers.front().lobe; });
    check_ends<MaskingModel>(cases, [](const Design& d) { return d.shadowing.model; });
    check_ends<Fresnel>(cases, [](const Design& d) { return d.fresnel; });
    check_ends<Diffuse>(cases, [](const Design& d) { return d.diffuse; });
}

TEST_CASE("a spoilt table is reported") {
    const ExtremeCase extreme = named_case("ggx 1");
    CHECK(faults_of(extreme, spoilt(extreme, [](Tables&) {})).empty());
    const std::string wrong_area = faults_of(extreme, spoilt(extreme, [](Tables& tables) {
                                                 const auto& shape = tables.shading.surface.tables;
                                                 for (int i = 0; i < shape.nodes_w * shape.nodes_psi; ++i)
                                                     tables.data[std::size_t(shape.area_offset + i)] *= 1.01F;
                                             }));
    CHECK(mentions(wrong_area, "g has an error of"));
    const std::string modest =
        faults_of(extreme, spoilt(extreme, [](Tables& tables) { tables.errors.area.worst = 0.01; }));
    CHECK(mentions(modest, "the bake claims 1.00e-02 for g, 1.5e-03 can be expected"));
    const std::string wrong_albedo = faults_of(extreme, spoilt(extreme, [](Tables& tables) {
                                                   const auto& shape = tables.shading.surface.tables;
                                                   for (int i = 0; i < shape.nodes_v * shape.nodes_rho; ++i)
                                                       tables.data[std::size_t(shape.albedo_offset + i)] +=
                                                           0.01F;
                                               }));
    CHECK(mentions(wrong_albedo, "R has an error of"));
    const std::string no_number =
        faults_of(extreme, spoilt(extreme, [](Tables& tables) { tables.data.back() = std::nanf(""); }));
    CHECK(mentions(no_number, "numbers of the tables are not finite"));
    const std::string negative = faults_of(
        extreme, spoilt(extreme, [](Tables& tables) { tables.shading.surface.fresnel_a = dvec3{-1}; }));
    CHECK(mentions(negative, "rho is not finite or negative"));
}

TEST_CASE("energy created where the clamp is left out is reported") {
    const ExtremeCase extreme = named_case("uncorrelated");
    const auto tables = spoilt(extreme, [](Tables& wrong) { wrong.shading.kinds.clamp = false; });
    ExtremeOptions options = cheap_options;
    options.rings = {.polar = 4, .azimuths = 5};
    const auto faults = fmt::format("{}", fmt::join(judge_tables(extreme, tables, options).faults, "; "));
    CHECK(mentions(faults, "R with F = 1 is"));
}

TEST_CASE("a refusal that is missing, unexpected or of another kind is reported") {
    ExtremeCase sound = named_case("ggx 1");
    sound.refusal = "no facets";
    CHECK(mentions(judge(sound, cheap_options).faults.at(0), "must be refused"));
    ExtremeCase black = named_case("black");
    CHECK(judge(black, cheap_options).holds());
    black.refusal = "another reason";
    CHECK(mentions(judge(black, cheap_options).faults.at(0), "must be refused because another reason"));
    black.refusal.clear();
    CHECK(judge(black, cheap_options).faults.at(0) == "refused");
}

TEST_CASE("a rho that changes with the unit of p is reported") {
    ExtremeCase extreme = named_case("weights times 1e-30");
    REQUIRE(extreme.same_rho);
    extreme.same_rho->distribution.layers[0].weight *= 1.001;
    CHECK(mentions(judge(extreme, cheap_options).faults.at(0), "another unit"));
}

TEST_CASE("a stopped sweep ends") {
    std::stop_source stop;
    stop.request_stop();
    CHECK_THROWS_AS(judge(named_case("ggx 1"), cheap_options, stop.get_token()), BakeCancelled);
}

TEST_SUITE_END();
