#include "core/measure/omission_cost.h"

#include "core/bake/bake.h"
#include "core/exchange/shader_size.h"
#include "core/measure/cold_time.h"

namespace nacre {
namespace {

// A design's bake and shader with something put back in.
struct Fuller {
    Design design;
    BakeOptions options = {.threads = 1};
    bool bakes_more = false;
    std::vector<std::string> also = {};  // definitions of the shader
};

void put_back(Part part, Fuller& fuller) {
    auto define = [&](std::initializer_list<const char*> names) {
        fuller.also.insert(fuller.also.end(), names.begin(), names.end());
    };
    switch (part) {
        case Part::symmetric_nodes:
            fuller.options.symmetry = Symmetry::none;
            fuller.bakes_more = true;
            break;
        case Part::albedo:
            fuller.options.albedo = true;
            fuller.bakes_more = true;
            break;
        case Part::fresnel_table:
            fuller.design.fresnel = SchlickFresnel{};
            fuller.bakes_more = true;
            break;
        case Part::fresnel_colours:
            fuller.design.fresnel = DielectricFresnel{};
            fuller.bakes_more = true;
            break;
        case Part::pictures:
            define({"HAS_PAINTED", "HAS_MODULATION"});
            break;
        case Part::conductor:
            define({"FRESNEL_CONDUCTOR"});
            break;
        case Part::fresnel:
            define({"FRESNEL_SCHLICK"});
            break;
        case Part::azimuth_correlation:
            define({"VISIBILITY_CORRELATED"});
            break;
        case Part::height_correlation:
            define({"VISIBILITY_SMITH"});
            break;
        case Part::diffuse:
            fuller.design.diffuse = CoupledDiffuse{};
            fuller.bakes_more = true;
            break;
    }
}

BakeCost measure(const Fuller& fuller, const std::stop_token& stop) {
    const auto timed = time_from_cold([&] { return bake(fuller.design, fuller.options, stop); });
    return {timed.seconds, timed.result->table_floats() * sizeof(float),
            shader_statements(variant_of(timed.result->shading), fuller.also)};
}

}  // namespace

OmissionCosts measure_omissions(const Design& design, const std::stop_token& stop) {
    OmissionCosts costs;
    const auto own = time_from_cold([&] { return bake(design, {.threads = 1}, stop); });
    const ShaderVariant variant = variant_of(own.result->shading);
    costs.bake = {own.seconds, own.result->table_floats() * sizeof(float), shader_statements(variant)};
    Fuller all{.design = design};
    for (const Omission& omission : own.result->plan.omissions) {
        Fuller one{.design = design};
        put_back(omission.part, one);
        put_back(omission.part, all);
        BakeCost with_it = costs.bake;
        if (one.bakes_more)
            with_it = measure(one, stop);
        else
            with_it.statements = shader_statements(variant, one.also);
        costs.omissions.push_back({omission, with_it});
    }
    costs.with_all = all.bakes_more || !all.also.empty() ? measure(all, stop) : costs.bake;
    return costs;
}

}  // namespace nacre
