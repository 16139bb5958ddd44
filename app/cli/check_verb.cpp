#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "app/cli/design_input.h"
#include "app/cli/output.h"
#include "app/cli/progress.h"
#include "app/cli/verbs.h"
#include "core/design/design_file.h"
#include "core/measure/physics_check.h"

namespace nacre::cli {
namespace {

struct CheckOptions {
    std::string design;
    bool json = false;
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
    const Design design = load_design(options.design);
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

}  // namespace

void declare_check(CLI::App& command, Action& action) {
    const auto options = std::make_shared<CheckOptions>();
    command.add_option("DESIGN", options->design, "a .nacre file")->required();
    command.add_flag("--json", options->json, "the figures as JSON");
    command.callback([options, &action] {
        action = [options](Interrupt& interrupt) { return check(*options, interrupt); };
    });
}

}  // namespace nacre::cli
