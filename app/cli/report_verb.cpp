#include <fmt/core.h>

#include <algorithm>
#include <system_error>

#include "app/cli/design_input.h"
#include "app/cli/output.h"
#include "app/cli/progress.h"
#include "app/cli/verbs.h"
#include "core/design/design_file.h"
#include "core/exchange/accuracy_chart.h"
#include "core/exchange/accuracy_text.h"
#include "core/exchange/atomic_file.h"

namespace nacre::cli {
namespace {

namespace fs = std::filesystem;

struct ReportOptions {
    std::vector<std::string> designs;
    std::string folder;
    double longest = AccuracyOptions{}.longest;  // seconds
};

// The folder for the files, made when it is not there, and removed again unless something was written.
class OutputFolder {
  public:
    explicit OutputFolder(const fs::path& folder) : folder_(folder) {
        std::error_code error;
        made_ = !fs::exists(folder, error);
        fs::create_directories(folder, error);
        if (error || !fs::is_directory(folder))
            throw UserError(folder.string(), "write", "the folder cannot be made",
                            error ? error.message() : "it is no folder");
    }
    OutputFolder(const OutputFolder&) = delete;
    OutputFolder& operator=(const OutputFolder&) = delete;
    ~OutputFolder() {
        std::error_code ignored;  // a folder that holds something stays
        if (made_) fs::remove(folder_, ignored);
    }

  private:
    fs::path folder_;
    bool made_ = false;
};

// Stems of the designs' files; the same one in two folders gets a number.
std::vector<std::string> stems_of(const std::vector<std::string>& files) {
    std::vector<std::string> stems;
    for (const std::string& file : files) {
        const std::string stem = fs::path(file).stem().string();
        std::string name = stem;
        for (int i = 2; std::find(stems.begin(), stems.end(), name) != stems.end(); ++i)
            name = fmt::format("{}-{}", stem, i);
        stems.push_back(name);
    }
    return stems;
}

std::vector<DesignAccuracy> measure_all(const ReportOptions& options, const std::vector<Design>& designs,
                                        const Interrupt& interrupt) {
    const std::vector<std::string> stems = stems_of(options.designs);
    const double count = static_cast<double>(designs.size());
    std::vector<DesignAccuracy> results;
    Progress progress("measuring");
    for (std::size_t i = 0; i < designs.size(); ++i) {
        results.push_back(about_file(options.designs[i], [&] {
            return measure_accuracy(
                designs[i], {.longest = options.longest}, interrupt.token(),
                [&](double done) { progress.report((static_cast<double>(i) + done) / count); });
        }));
        results.back().file = stems[i];
    }
    return results;
}

void write_report(const fs::path& folder, const std::vector<DesignAccuracy>& designs) {
    for (const DesignAccuracy& design : designs)
        for (const ChartOf quantity : {ChartOf::area, ChartOf::albedo})
            write_file_atomically(folder / chart_file(design, quantity),
                                  svg_chart(accuracy_chart(design, quantity)));
    write_file_atomically(folder / "report.csv", accuracy_csv(designs));
    write_file_atomically(folder / "report.json", accuracy_json(designs));
    write_file_atomically(folder / "report.md", accuracy_markdown(designs));
}

int report(const ReportOptions& options, Interrupt& interrupt) {
    std::vector<Design> designs;
    for (const std::string& file : options.designs) {
        designs.push_back(load_design(file));
        about_file(file, [&] { return FacetDistribution(designs.back().distribution).mean_cosine(); });
        interrupt.check();
    }
    const OutputFolder folder(options.folder);
    const std::vector<DesignAccuracy> results = measure_all(options, designs, interrupt);
    interrupt.write_files([&] { write_report(options.folder, results); });
    write_output(fmt::format("{} charts, report.csv, report.json and report.md in {}\n", 2 * results.size(),
                             options.folder));
    return 0;
}

}  // namespace

void declare_report(Command& command, Action& action) {
    const auto options = std::make_shared<ReportOptions>();
    command.option("DESIGN", options->designs, ".nacre files; each takes up to a minute").required();
    command.option("-o,--output", options->folder, "the folder for the report, made when it is not there")
        .required();
    command
        .option(
            "--longest", options->longest,
            "seconds: no way of computing goes on to more nodes or samples after a table that took longer")
        .shows_default()
        .within(1e-6, 60.0);
    command.when_chosen([options, &action] {
        action = [options](Interrupt& interrupt) { return report(*options, interrupt); };
    });
}

}  // namespace nacre::cli
