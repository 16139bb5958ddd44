#include <fmt/core.h>

#include <algorithm>

#include "app/cli/design_input.h"
#include "app/cli/output.h"
#include "app/cli/output_names.h"
#include "app/cli/output_option.h"
#include "app/cli/progress.h"
#include "app/cli/verbs.h"
#include "core/base/system/atomic_file.h"
#include "core/base/system/output_folder.h"
#include "core/base/system/output_guard.h"
#include "core/formats/plot_files.h"
#include "core/study/accuracy_chart.h"
#include "core/study/accuracy_text.h"

namespace nacre::cli {
namespace {

namespace fs = std::filesystem;

struct ReportOptions {
    std::vector<std::string> designs;
    std::string folder;
    double longest = AccuracyOptions{}.longest;  // seconds
};

std::vector<std::string> names_of(const ReportOptions& options) {
    std::vector<std::string> stems;
    for (const std::string& file : options.designs)
        stems.push_back(file == stream_name ? "standard-input" : fs::path(file).stem().string());
    return distinct_names(stems, {}, options.folder);
}

std::vector<DesignAccuracy> measure_all(const ReportOptions& options, const std::vector<Design>& designs,
                                        const Interrupt& interrupt) {
    const std::vector<std::string> names = names_of(options);
    const double count = static_cast<double>(designs.size());
    std::vector<DesignAccuracy> results;
    Progress progress("measuring");
    for (std::size_t i = 0; i < designs.size(); ++i) {
        results.push_back(about_file(options.designs[i], [&] {
            return measure_accuracy(
                designs[i], {.longest = options.longest}, interrupt.token(),
                [&](double done) { progress.report((static_cast<double>(i) + done) / count); });
        }));
        results.back().file = names[i];
    }
    return results;
}

struct ReportFile {
    fs::path file;
    std::string text;
};

std::vector<ReportFile> compose_report(const fs::path& folder, const std::vector<DesignAccuracy>& designs) {
    std::vector<ReportFile> files;
    for (const DesignAccuracy& design : designs)
        for (const ChartOf quantity : {ChartOf::area, ChartOf::albedo})
            files.push_back(
                {folder / chart_file(design.file, quantity), plot_svg(accuracy_chart(design, quantity))});
    files.push_back({folder / "report.csv", accuracy_csv(designs)});
    files.push_back({folder / "report.json", accuracy_json(designs)});
    files.push_back({folder / "report.md", accuracy_markdown(designs)});
    return files;
}

void write_report(const std::vector<ReportFile>& report) {
    std::vector<FileToWrite> files;
    for (const ReportFile& file : report) files.push_back({file.file, file.text});
    write_files_atomically(files);
}

std::vector<fs::path> report_files(const fs::path& folder, const std::vector<std::string>& names) {
    std::vector<fs::path> files;
    for (const std::string& name : names)
        for (const ChartOf quantity : {ChartOf::area, ChartOf::albedo})
            files.push_back(folder / chart_file(name, quantity));
    for (const char* name : {"report.csv", "report.json", "report.md"}) files.push_back(folder / name);
    return files;
}

int report(const ReportOptions& options, Interrupt& interrupt) {
    std::vector<Design> designs;
    std::vector<fs::path> inputs;
    for (const std::string& file : options.designs) {
        designs.push_back(read_design(file));
        about_file(file, [&] { return FacetDistribution(designs.back().distribution).mean_cosine(); });
        const std::vector<fs::path> files = files_of(designs.back(), file);
        inputs.insert(inputs.end(), files.begin(), files.end());
        interrupt.check();
    }
    check_outputs(report_files(options.folder, names_of(options)), inputs);
    const OutputFolder folder(options.folder);
    const std::vector<DesignAccuracy> results = measure_all(options, designs, interrupt);
    const std::vector<ReportFile> files = compose_report(options.folder, results);
    interrupt.write_files([&] { write_report(files); });
    write_output(fmt::format("{} charts, report.csv, report.json and report.md in {}\n", 2 * results.size(),
                             options.folder));
    return 0;
}

void declare(Command& command, Action& action) {
    const auto options = std::make_shared<ReportOptions>();
    command
        .option("DESIGN", options->designs,
                ".nacre files; each takes up to a minute; - is standard input, once")
        .required();
    add_folder_option(command, options->folder, "the folder for the report, made when it is not there");
    command
        .option("--longest", options->longest,
                "seconds: no method goes on to more nodes or samples after a table that took longer")
        .shows_default()
        .within(1e-6, 60.0);
    command.when_chosen([options, &action] {
        if (std::count(options->designs.begin(), options->designs.end(), stream_name) > 1)
            throw_wrong_usage("standard input brings one design");
        action = [options](Interrupt& interrupt) { return report(*options, interrupt); };
    });
}

}  // namespace

const Verb report_verb{"report", "error against run time of each method of computing g and R", declare};

}  // namespace nacre::cli
