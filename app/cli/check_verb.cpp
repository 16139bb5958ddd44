#include <fmt/core.h>

#include <nlohmann/json.hpp>

#include "app/cli/design_input.h"
#include "app/cli/extreme_sweep.h"
#include "app/cli/output.h"
#include "app/cli/progress.h"
#include "app/cli/verbs.h"
#include "core/verify/physics_check.h"

namespace nacre::cli {
namespace {

struct CheckOptions {
    std::string design;
    bool json = false;
    bool extremes = false;
    bool markdown = false;
    SweepChoice choice;

    SweepFormat sweep_format() const {
        if (json) return SweepFormat::json;
        return markdown ? SweepFormat::markdown : SweepFormat::text;
    }
};

const char* name_of(Verdict verdict) {
    switch (verdict) {
        case Verdict::pass:
            return "pass";
        case Verdict::fail:
            return "FAIL";
        case Verdict::note:
            return "note";
    }
    return "";
}

std::string text_report(const Design& design, const PhysicsReport& report) {
    std::string text = fmt::format("{}\n", one_line(design.name.empty() ? "unnamed design" : design.name));
    for (const PhysicsCheck& check : report.checks)
        text += fmt::format("  {}  {:<20} {:>9.2e}  (at most {:.1e})  {}\n", name_of(check.verdict),
                            check.name, check.figure, check.bound, check.text);
    text += report.passed() ? "all checks pass\n" : "a check fails\n";
    return text;
}

std::string json_report(const Design& design, const PhysicsReport& report) {
    nlohmann::ordered_json checks = nlohmann::ordered_json::array();
    for (const PhysicsCheck& check : report.checks)
        checks.push_back({{"name", check.name},
                          {"verdict", check.verdict == Verdict::fail ? "fail" : name_of(check.verdict)},
                          {"figure", check.figure},
                          {"bound", check.bound},
                          {"text", check.text}});
    const nlohmann::ordered_json json = {
        {"name", design.name}, {"passed", report.passed()}, {"checks", std::move(checks)}};
    return json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

int check(const CheckOptions& options, const Interrupt& interrupt) {
    const Design design = read_design(options.design);
    PhysicsReport report;
    {
        Progress progress("checking");
        report = about_file(options.design, [&] {
            return check_physics(design, interrupt.token(), [&](double done) { progress.report(done); });
        });
    }
    write_output(options.json ? json_report(design, report) : text_report(design, report));
    return report.passed() ? 0 : 1;
}

void declare(Command& command, Action& action) {
    const auto options = std::make_shared<CheckOptions>();
    const auto design = command.option("DESIGN", options->design, "a .nacre file; - is standard input");
    command.flag("--json", options->json, "the figures as JSON");
    const auto extremes =
        command.flag("--extremes", options->extremes, "a sweep of extreme designs in place of DESIGN");
    extremes.excludes(design);
    const auto group = command.option("--group", options->choice.group, "only this group of the sweep")
                           .needs(extremes)
                           .check(known_group);
    command.option("--case", options->choice.text, "only cases of the sweep whose name holds this text")
        .needs(extremes)
        .excludes(group)
        .check(known_case);
    command.flag("--markdown", options->markdown, "the sweep as the tables of docs/stability.md")
        .needs(extremes);
    command.when_chosen([options, &action] {
        if (options->design.empty() && !options->extremes) throw_missing("DESIGN or --extremes");
        action = [options](Interrupt& interrupt) {
            if (!options->extremes) return check(*options, interrupt);
            return sweep_extremes(options->choice, options->sweep_format(), interrupt);
        };
    });
}

}  // namespace

const Verb check_verb{
    "check", "the physics of a design and the errors that its bake claims; exit code 1 when a check fails",
    declare};

}  // namespace nacre::cli
