#include <doctest/doctest.h>

#include <nlohmann/json.hpp>

#include "tests/cli/child_process.h"
#include "tests/cli/design_on_disk.h"

using namespace nacre::test;

namespace {

std::vector<std::string> sweep(const char* group, const char* format = nullptr) {
    std::vector<std::string> words = {"check", "--extremes", "--group", group};
    if (format) words.push_back(format);
    return words;
}

}  // namespace

TEST_CASE("check --extremes tells of every case what it was measured to be, or why it is refused") {
    const auto report = nlohmann::json::parse(answer(sweep("mean cosine", "--json")));
    CHECK(report.at("passed") == true);
    int sound = 0, refused = 0;
    for (const auto& judged : report.at("cases")) {
        CHECK(judged.at("group") == "mean cosine");
        CHECK(judged.at("verdict") == "pass");
        CHECK(judged.at("faults").empty());
        if (judged.contains("refusal")) {
            ++refused;
            CHECK(judged.at("refusal").get<std::string>().starts_with("distribution"));
        } else {
            ++sound;
            CHECK(judged.at("g").at("error") <= judged.at("g").at("bound"));
            CHECK(judged.at("R").at("error") <= judged.at("R").at("bound"));
            CHECK(judged.at("largest_R") <= 1 + 1e-6);
        }
    }
    CHECK(sound >= 5);
    CHECK(refused >= 4);
    CHECK(answer(sweep("mean cosine")).find("cases hold") != std::string::npos);
}

TEST_CASE("check --extremes --markdown writes one table for a group, a row for each case") {
    const auto report = nlohmann::json::parse(answer(sweep("mean cosine", "--json")));
    const std::string text = answer(sweep("mean cosine", "--markdown"));
    CHECK(text.starts_with(std::to_string(report.at("cases").size()) + " designs"));
    CHECK(text.find("\n### mean cosine\n") != std::string::npos);
    for (const auto& judged : report.at("cases"))
        CHECK(text.find("\n| " + judged.at("name").get<std::string>() + " |") != std::string::npos);
}

TEST_CASE("check takes either a design or --extremes, and a group that there is") {
    const DesignOnDisk design(design_of(nacre::GgxLobe{}));
    CHECK(run_cli({"check"}).code == 2);
    CHECK(run_cli({"check", design.path(), "--extremes"}).code == 2);
    CHECK(run_cli({"check", design.path(), "--markdown"}).code == 2);
    CHECK(run_cli({"check", design.path(), "--group", "lobes"}).code == 2);
    const Finished unknown = run_cli({"check", "--extremes", "--group", "colours"});
    CHECK(unknown.code == 2);
    CHECK(unknown.err.find("mean cosine") != std::string::npos);
    CHECK(run_cli({"check", "--extremes", "--case", "no such case"}).code == 2);
    CHECK(run_cli({"check", "--extremes", "--case", "ggx 1", "--group", "lobes"}).code == 2);
}

TEST_CASE("check --extremes --case judges the cases whose name holds the text") {
    const auto report = nlohmann::json::parse(answer({"check", "--extremes", "--case", "facing", "--json"}));
    REQUIRE(report.at("cases").size() == 1);
    CHECK(report.at("cases").at(0).at("name") == "facing down");
}
