// nacre-claims-bench: do the errors of g and R that a bake claims hold on directions that took no part?
//   nacre-claims-bench [--directions OF_G OF_R] [--mixtures FIRST LAST] [--sweep] [DESIGN.nacre ...]
// A line a design: sizes, seconds of processor time, then of g and of R the claim, the worst error found and
// where it is. At the end how often more was found than is allowed, and the median of claim/found.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <ctime>
#include <numbers>
#include <string>
#include <vector>

#include "core/bake/bake.h"
#include "core/base/error.h"
#include "core/design/design_file.h"
#include "core/study/extremes.h"
#include "core/verify/table_error.h"
#include "tests/core/held_out.h"

using namespace nacre;
using namespace nacre::test;

namespace {

// What becomes of one quantity's claims.
struct Tally {
    const char* name;
    int broken = 0;
    std::vector<double> slack = {};  // claim/found of each design

    void add(const TableError& claim, double tolerance, const HeldOutError& found) {
        if (!(found.worst <= allowed_error(claim, tolerance))) ++broken;
        if (found.worst > 0) slack.push_back(claim.worst / found.worst);
    }
    void print() {
        if (slack.empty()) return;
        const auto middle = slack.begin() + static_cast<long>(slack.size() / 2);
        std::nth_element(slack.begin(), middle, slack.end());
        fmt::print("{}: {} of {} designs err by more than is allowed; claim/found {:.2f} in the median\n",
                   name, broken, slack.size(), *middle);
    }
};

class ClaimsBench {
  public:
    ClaimsBench(int of_area, int of_albedo)
        : area_directions_(held_out_directions(of_area, 77)),
          albedo_directions_(held_out_directions(of_albedo, 78)) {}

    void judge(const std::string& name, const Design& design) {
        std::shared_ptr<const Tables> tables;
        const std::clock_t before = std::clock();
        try {
            tables = bake(design, {.albedo = true});
        } catch (const UserError&) {
            return;
        }
        const double seconds = static_cast<double>(std::clock() - before) / CLOCKS_PER_SEC;
        const TableSize& nodes = tables->size;
        const HeldOutError g = held_out_area(*tables, area_directions_),
                           R = held_out_albedo(design, *tables, albedo_directions_);
        area_.add(tables->errors.area, tables->tolerance, g);
        albedo_.add(tables->errors.albedo, tables->tolerance, R);
        seconds_ += seconds;
        fmt::print("{:<44} g {:>3} x {:>3} R {:>3} x {:>3} {:>6} B {:7.3f} s", name, nodes.w, nodes.psi,
                   nodes.v, nodes.rho, tables->table_floats() * sizeof(float), seconds);
        print(*tables, "g", tables->errors.area, g, tables->shading.table_spot(g.at), nodes.w, false);
        print(*tables, "R", tables->errors.albedo, R, tables->shading.table_spot(R.at), nodes.v, true);
        fmt::print("\n");
        std::fflush(stdout);
    }

    void print_tallies() {
        area_.print();
        albedo_.print();
        fmt::print("bakes: {:.2f} s of processor time\n", seconds_);
    }

  private:
    // Where: theta, phi and the place in the table, in nodes.
    void print(const Tables& tables, const char* what, const TableError& claim, const HeldOutError& found,
               const Shading<double>::TableSpot& spot, int columns, bool albedo) const {
        const dvec3 k = found.at;
        const auto place =
            albedo ? tables.shading.albedo_spot(k, spot) : Shading<double>::AlbedoSpot{spot.psi, spot.w};
        const bool broken = !(found.worst <= allowed_error(claim, tables.tolerance));
        fmt::print(" | {} {:.2e} found {:.2e}{} at {:7.3f} {:7.2f} cell {:.2f} {:.2f}", what, claim.worst,
                   found.worst, broken ? " BROKEN" : "",
                   std::atan2(std::hypot(k.x, k.y), k.z) * 180 / std::numbers::pi,
                   std::atan2(k.y, k.x) * 180 / std::numbers::pi, place.v * (columns - 1),
                   static_cast<double>(place.rho.first) + place.rho.fraction);
    }

    std::vector<dvec3> area_directions_, albedo_directions_;
    Tally area_{"g"}, albedo_{"R"};
    double seconds_ = 0;
};

}  // namespace

int main(int count, char** values) {
    const std::vector<std::string> words(values + 1, values + count);
    int of_area = 20000, of_albedo = 2000;
    auto number = [&](std::size_t i) { return i < words.size() ? std::atoi(words[i].c_str()) : 0; };
    for (std::size_t i = 0; i < words.size(); ++i)
        if (words[i] == "--directions") of_area = number(i + 1), of_albedo = number(i + 2);
    ClaimsBench bench(std::max(of_area, 4), std::max(of_albedo, 4));
    for (std::size_t i = 0; i < words.size(); ++i) {
        if (words[i] == "--directions") {
            i += 2;
        } else if (words[i] == "--mixtures") {
            for (int seed = number(i + 1); seed <= number(i + 2); ++seed)
                bench.judge(fmt::format("mixture {}", seed), random_mixture(static_cast<unsigned>(seed)));
            i += 2;
        } else if (words[i] == "--sweep") {
            for (const ExtremeCase& extreme : extreme_cases())
                if (extreme.refusal.empty()) bench.judge(extreme.name, extreme.design);
        } else {
            bench.judge(words[i].substr(words[i].rfind('/') + 1), load_design(words[i]));
        }
    }
    bench.print_tallies();
    return 0;
}
