#include "app/cli/extreme_sweep.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "app/cli/output.h"
#include "app/cli/progress.h"
#include "core/study/extreme_check.h"

namespace nacre::cli {
namespace {

using Json = nlohmann::ordered_json;

struct Sweep {
    std::vector<ExtremeCase> cases;
    std::vector<ExtremeResult> results;

    std::size_t failed() const {
        return static_cast<std::size_t>(std::count_if(results.begin(), results.end(),
                                                      [](const auto& result) { return !result.holds(); }));
    }

    // Calls visit(case, result, whether a group begins).
    template <class Visit>
    void for_each(const Visit& visit) const {
        for (std::size_t i = 0; i < cases.size(); ++i)
            visit(cases[i], results[i], i == 0 || cases[i].group != cases[i - 1].group);
    }
};

std::string claimed(const ClaimedError& error) {
    return fmt::format("{:.1e} (at most {:.1e})", error.error, error.bound);
}

std::string figures(const ExtremeResult& result) {
    return fmt::format("g {}, R {}, largest R {:.4f}; plain grid: g {:.1e}, R {:.1e}, {} of {} rho unsound",
                       claimed(result.area), claimed(result.albedo), result.largest_albedo, result.plain.area,
                       result.plain.albedo, result.plain.unsound, result.pairs);
}

std::string text_of(const Sweep& sweep) {
    std::string text;
    sweep.for_each([&](const ExtremeCase& extreme, const ExtremeResult& result, bool begins) {
        if (begins) text += extreme.group + "\n";
        text += fmt::format("  {}  {:<46} {}\n", result.holds() ? "pass" : "FAIL", extreme.name,
                            result.refusal.empty() ? figures(result) : "refused: " + result.refusal);
        for (const std::string& fault : result.faults) text += fmt::format("        {}\n", fault);
    });
    return text + (sweep.failed() == 0
                       ? fmt::format("all {} cases hold\n", sweep.cases.size())
                       : fmt::format("{} of {} cases fail\n", sweep.failed(), sweep.cases.size()));
}

Json json_of(const ClaimedError& error) { return {{"error", error.error}, {"bound", error.bound}}; }

std::string json_of(const Sweep& sweep) {
    Json cases = Json::array();
    sweep.for_each([&](const ExtremeCase& extreme, const ExtremeResult& result, bool) {
        Json json = {{"group", extreme.group},
                     {"name", extreme.name},
                     {"verdict", result.holds() ? "pass" : "fail"},
                     {"faults", result.faults},
                     {"seconds", result.seconds}};
        if (result.refusal.empty()) {
            json["pairs"] = result.pairs;
            json["g"] = json_of(result.area);
            json["R"] = json_of(result.albedo);
            json["largest_R"] = result.largest_albedo;
            json["plain_grid"] = {
                {"g", result.plain.area}, {"R", result.plain.albedo}, {"unsound", result.plain.unsound}};
        } else {
            json["refusal"] = result.refusal;
        }
        cases.push_back(std::move(json));
    });
    const Json whole = {{"passed", sweep.failed() == 0}, {"cases", std::move(cases)}};
    return whole.dump(2) + "\n";
}

std::string verdict_of(const ExtremeResult& result) {
    if (!result.holds()) return fmt::format("**fails**: {}", fmt::join(result.faults, "; "));
    return result.refusal.empty() ? "sound" : "refused: " + result.refusal;
}

std::string row_of(const ExtremeCase& extreme, const ExtremeResult& result) {
    const std::string begin = fmt::format("| {} | {} |", extreme.name, verdict_of(result));
    if (!result.refusal.empty()) return begin + " | | | | | |\n";
    return begin + fmt::format(" {} | {} | {:.4f} | {:.1e} | {:.1e} | {} |\n", claimed(result.area),
                               claimed(result.albedo), result.largest_albedo, result.plain.area,
                               result.plain.albedo, result.plain.unsound);
}

std::string summary_of(const Sweep& sweep) {
    constexpr double far_area = 0.1, far_albedo = 0.1;
    auto count = [&](const auto& which) {
        return std::count_if(sweep.results.begin(), sweep.results.end(), which);
    };
    const auto refused = count([](const ExtremeResult& r) { return !r.refusal.empty(); });
    return fmt::format(
        "{} designs: {} refused, {} baked; {} fail. Of the baked ones the plain grid has an error above "
        "{:g} % of g in {} and above {:g} of R in {}, and a rho that is NaN, infinite or negative in {}.\n",
        sweep.cases.size(), refused, sweep.cases.size() - static_cast<std::size_t>(refused), sweep.failed(),
        100 * far_area, count([](const ExtremeResult& r) { return !(r.plain.area <= far_area); }), far_albedo,
        count([](const ExtremeResult& r) { return !(r.plain.albedo <= far_albedo); }),
        count([](const ExtremeResult& r) { return r.plain.unsound > 0; }));
}

std::string markdown_of(const Sweep& sweep) {
    std::string text = summary_of(sweep);
    sweep.for_each([&](const ExtremeCase& extreme, const ExtremeResult& result, bool begins) {
        if (begins)
            text += fmt::format(
                "\n### {}\n\n| design | verdict | error of g | error of R | largest R | plain grid: g | R | "
                "rho unsound |\n| --- | --- | --- | --- | --- | --- | --- | --- |\n",
                extreme.group);
        text += row_of(extreme, result);
    });
    return text;
}

}  // namespace

std::string known_group(const std::string& group) {
    std::vector<std::string> groups;
    for (const ExtremeCase& extreme : extreme_cases())
        if (groups.empty() || groups.back() != extreme.group) groups.push_back(extreme.group);
    if (std::find(groups.begin(), groups.end(), group) != groups.end()) return {};
    return fmt::format("must be one of: {}", fmt::join(groups, ", "));
}

std::string known_case(const std::string& text) {
    for (const ExtremeCase& extreme : extreme_cases())
        if (extreme.name.find(text) != std::string::npos) return {};
    return "must be part of a case's name";
}

int sweep_extremes(const SweepChoice& choice, SweepFormat format, const Interrupt& interrupt) {
    Sweep sweep{extreme_cases(), {}};
    std::erase_if(sweep.cases, [&](const ExtremeCase& extreme) {
        return (!choice.group.empty() && extreme.group != choice.group) ||
               extreme.name.find(choice.text) == std::string::npos;
    });
    {
        Progress progress("sweeping");
        sweep.results =
            judge_all(sweep.cases, {}, interrupt.token(), [&](double done) { progress.report(done); });
    }
    write_output(format == SweepFormat::json       ? json_of(sweep)
                 : format == SweepFormat::markdown ? markdown_of(sweep)
                                                   : text_of(sweep));
    return sweep.failed() == 0 ? 0 : 1;
}

}  // namespace nacre::cli
