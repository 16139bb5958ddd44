// Extreme values from a kind's list of parameters.
#include "core/study/kind_extremes.h"

#include <doctest/doctest.h>

#include "core/model/lobes.h"

using namespace nacre;

namespace {

struct Shares {
    double first = 0.5, second = 0.5;
    bool operator==(const Shares&) const = default;

    static constexpr const char* name = "shares";
    static constexpr const char* label = "Shares";
    static constexpr const char* explanation = "";
    static constexpr auto parameters() {
        return std::tuple{NumberParameter<Shares>{&Shares::first, {"first", "", ""}, {0, 1}, {{0, 1}}},
                          NumberParameter<Shares>{&Shares::second, {"second", "", ""}, {0, 1}, {{0, 1}}}};
    }
    static std::vector<std::pair<const char*, Shares>> singular() {
        return {{"a third", {1. / 3, 1. / 3}}, {"nothing, again", {0, 0}}};
    }
    std::optional<KindFault> fault() const {
        if (first + second <= 1) return {};
        return KindFault{"", "at most 1", ""};
    }
};

struct Nothing {
    bool operator==(const Nothing&) const = default;
    static constexpr const char* name = "nothing";
    static constexpr const char* label = "Nothing";
    static constexpr const char* explanation = "";
    static constexpr auto parameters() { return std::tuple{}; }
};

template <class Variant>
std::vector<std::string> names_of() {
    std::vector<std::string> names;
    for (const NamedValue<Variant>& extreme : extreme_kinds<Variant>()) names.push_back(extreme.name);
    return names;
}

}  // namespace

TEST_CASE(
    "a kind's extremes are the ends of its bounds, together, each and opposed, none twice, none against a "
    "rule") {
    CHECK(names_of<std::variant<Shares, Nothing>>() ==
          std::vector<std::string>{"shares 0", "shares first 0", "shares second 0",
                                   "shares first 0, second 1", "shares first 1, second 0", "shares, a third",
                                   "nothing"});
}

TEST_CASE("widths go from end to end by powers of 100, and to infinity where they may") {
    const std::vector<std::string> expected = {"gaussian 1e-05",  "gaussian 0.0001", "gaussian 0.01",
                                               "gaussian 1",      "gaussian 100",    "gaussian 10000",
                                               "gaussian 100000", "gaussian inf"};
    const std::vector<std::string> names = names_of<std::variant<GaussianLobe>>();
    REQUIRE(names.size() > expected.size());
    CHECK(std::vector(names.begin(), names.begin() + 8) == expected);
    for (const auto& extreme : extreme_kinds<std::variant<InverseGaussianLobe>>())
        CHECK(extreme.name == fmt::format("inverse_gaussian {:g}", std::get<0>(extreme.value).sigma));
}

TEST_CASE("a kind that holds a picture or a curve has extremes that are valid") {
    for (const auto& extreme : extreme_kinds<std::variant<PaintedLobe, CurveLobe>>())
        CHECK_MESSAGE(!kind_fault(extreme.value), extreme.name);
    CHECK(extreme_kinds<std::variant<PaintedLobe>>().size() == 2);
}
