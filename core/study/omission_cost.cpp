#include "core/study/omission_cost.h"

#include "core/bake/bake.h"
#include "core/study/cold_time.h"

namespace nacre {
namespace {

// A design with things put back that it does without.
struct Fuller {
    Design design;
    BakeOptions options{.threads = 1};
};

// Whether the bake makes more for it; what only the shader leaves out costs no time and no bytes here.
bool put_back(Part part, Fuller& fuller) {
    switch (part) {
        case Part::symmetric_nodes:
            fuller.options.symmetry = Symmetry::none;
            return true;
        case Part::albedo:
            fuller.options.albedo = true;
            return true;
        case Part::fresnel_table:
            fuller.design.fresnel = SchlickFresnel{};
            return true;
        case Part::fresnel_colours:
            fuller.design.fresnel = DielectricFresnel{};
            return true;
        case Part::diffuse:
            fuller.design.diffuse = CoupledDiffuse{};
            return true;
        case Part::pictures:
        case Part::fresnel:
        case Part::masking:
            return false;
    }
    return false;
}

BakeCost measure(const Fuller& fuller, const std::stop_token& stop) {
    const auto timed = time_from_cold([&] { return bake(fuller.design, fuller.options, stop); });
    return {timed.seconds, timed.result->table_floats() * sizeof(float)};
}

}  // namespace

OmissionCosts measure_omissions(const Design& design, const std::stop_token& stop) {
    OmissionCosts costs;
    const auto own = time_from_cold([&] { return bake(design, {.threads = 1}, stop); });
    costs.bake = {own.seconds, own.result->table_floats() * sizeof(float)};
    Fuller all{.design = design};
    for (const Omission& omission : own.result->omissions) {
        Fuller one{.design = design};
        if (!put_back(omission.part, one)) continue;
        put_back(omission.part, all);
        costs.omissions.push_back({omission, measure(one, stop)});
    }
    costs.with_all = costs.omissions.empty() ? costs.bake : measure(all, stop);
    return costs;
}

}  // namespace nacre
