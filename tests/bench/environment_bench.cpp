// How the environment view converges to core's integral: for every preset and procedural environment the
// error of the picture against samples. Prints Markdown; docs/environment.md holds its last output.
#include <fmt/core.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>

#include "app/headless/offscreen_context.h"
#include "core/bake/bake.h"
#include "core/design/design_file.h"
#include "core/light/procedural.h"
#include "tests/gl/environment_error.h"

using namespace nacre;
using namespace nacre::test;
namespace fs = std::filesystem;

namespace {

constexpr int side = 32, points_wanted = 64;
constexpr int sample_counts[] = {1, 4, 16, 64, 256, 1024};

}  // namespace

int main(int argc, char** argv) {
    if (argc != 2) {
        fmt::print(stderr, "usage: nacre-environment-bench FOLDER_OF_DESIGNS\n");
        return 2;
    }
    std::vector<fs::path> files;
    for (const auto& entry : fs::directory_iterator(argv[1]))
        if (entry.path().extension() == ".nacre") files.push_back(entry.path());
    std::sort(files.begin(), files.end());

    const auto context = make_offscreen_context({16, 16});
    Preview preview;
    const ViewedPoints points(preview, side, points_wanted);
    std::vector<std::shared_ptr<const Environment>> environments;
    for (const ProceduralEnvironment* known : procedural_environments())
        environments.push_back(make_environment(known->name, *procedural_environment(known->name)));

    fmt::print("| preset |");
    for (const auto& environment : environments) fmt::print(" {} |", environment->name);
    fmt::print("\n| --- |");
    for (std::size_t i = 0; i < environments.size(); ++i) fmt::print(" ---: |");
    std::vector<double> squares(std::size(sample_counts), 0), worst(std::size(sample_counts), 0);
    double seconds = 0;
    for (const fs::path& file : files) {
        const auto tables = bake(load_design(file));
        preview.set(tables);
        fmt::print("\n| {} |", file.stem().string());
        for (const auto& environment : environments) {
            const auto exact = integrals(points, tables, environment, 2);
            double error = 0;
            for (std::size_t i = 0; i < std::size(sample_counts); ++i) {
                const auto begin = std::chrono::steady_clock::now();
                error = relative_error(accumulated(preview, points, environment, sample_counts[i]), exact);
                const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - begin;
                if (sample_counts[i] == 1024) seconds += taken.count();
                squares[i] += error * error;
                worst[i] = std::max(worst[i], error);
            }
            fmt::print(" {:.2f} % |", 100 * error);
            std::fflush(stdout);
        }
    }
    const double pictures = static_cast<double>(files.size() * environments.size());
    fmt::print("\n\n| samples |");
    for (const int count : sample_counts) fmt::print(" {} |", count);
    fmt::print("\n| --- |");
    for (std::size_t i = 0; i < std::size(sample_counts); ++i) fmt::print(" ---: |");
    fmt::print("\n| root mean square |");
    for (const double sum : squares) fmt::print(" {:.2f} % |", 100 * std::sqrt(sum / pictures));
    fmt::print("\n| worst |");
    for (const double w : worst) fmt::print(" {:.2f} % |", 100 * w);
    fmt::print("\n\n{:.2f} us for one sample of one texel, background included\n",
               1e6 * seconds / (pictures * 1024 * side * side));
    return 0;
}
