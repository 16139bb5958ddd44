#include <doctest/doctest.h>
#include <signal.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "tests/cli/child_process.h"
#include "tests/cli/design_on_disk.h"
#include "tests/cli/stopping.h"

using namespace nacre;
using namespace nacre::test;

namespace {

void check_refused(const Finished& finished, const std::vector<std::string>& parts) {
    CHECK(finished.code == 1);
    CHECK(finished.out == "");
    CHECK_MESSAGE(is_one_line_with(finished.err, parts), finished.err);
}

}  // namespace

TEST_CASE("report writes tables and two charts for each design") {
    const TemporaryFolder folder;
    Design steel = design_of(GgxLobe{0.4, 0.4}), velvet = design_of(InverseGaussianLobe{0.5});
    steel.name = "Steel & co";
    const DesignOnDisk first(steel), second(velvet);  // both are called design.nacre
    const std::string out = folder / "deep/report";
    CHECK(answer({"report", first.path(), second.path(), "-o", out, "--longest", "0.0005"})
              .starts_with("4 charts"));
    for (const char* name :
         {"report.csv", "report.md", "design-g.svg", "design-R.svg", "design-2-g.svg", "design-2-R.svg"})
        CHECK_MESSAGE(std::filesystem::file_size(std::filesystem::path(out) / name) > 500, name);
    CHECK(std::distance(std::filesystem::directory_iterator(out), {}) == 7);
    const auto json = nlohmann::json::parse(read_all(std::filesystem::path(out) / "report.json"));
    CHECK(json.at("designs").at(0).at("name") == "Steel & co");
    CHECK(json.at("designs").at(1).at("file") == "design-2");
    CHECK(json.at("designs").at(0).at("ways").size() == 6);
    CHECK(json.at("designs").at(0).at("omissions").at("left_out").size() == 3);
    CHECK(read_all(std::filesystem::path(out) / "design-g.svg").find("Steel &amp; co") != std::string::npos);
    const std::string csv = read_all(std::filesystem::path(out) / "report.csv");
    CHECK(
        csv.starts_with("design,file,symmetry,way,setting,quantity,seconds,bytes,worst,rms,directions\r\n"));
}

TEST_CASE("a report that cannot be made leaves nothing behind") {
    const TemporaryFolder folder;
    const DesignOnDisk good(design_of(GgxLobe{0.4, 0.4}));
    Design buried = design_of(GaussianLobe{0.1, 0.1});
    buried.distribution.layers[0].tilt = 170;
    const DesignOnDisk bad(buried);
    const std::string out = folder / "report";
    check_refused(run_cli({"report", good.path(), folder / "absent.nacre", "-o", out}),
                  {"absent.nacre: open: "});
    check_refused(run_cli({"report", good.path(), bad.path(), "-o", out}), {bad.path(), "distribution"});
    write_all(folder / "file", "kept");
    check_refused(run_cli({"report", good.path(), "-o", folder / "file"}), {"file: write: "});
    check_refused(run_cli({"report", good.path(), "-o", "/proc/nacre-out"}), {"/proc/nacre-out: write: "});
    CHECK(folder.size() == 1);
    CHECK(read_all(folder / "file") == "kept");
    for (const std::vector<std::string>& arguments : {std::vector<std::string>{"report"},
                                                      {"report", good.path()},
                                                      {"report", "-o", out},
                                                      {"report", good.path(), "-o", out, "--longest", "0"}})
        CHECK(run_cli(arguments).code == 2);
}

TEST_CASE("Ctrl+C ends a report within a second and leaves no folder") {
    const TemporaryFolder folder;
    const DesignOnDisk design(slanted_velvet(true));
    for (const double after : {1.0, 3.0}) {
        check_stops_within_a_second({"report", design.path(), "-o", folder / "report"},
                                    {.signal = SIGINT, .signal_after = after});
        CHECK(folder.size() == 0);
    }
}
