#include "core/bake/plan.h"

#include <fmt/core.h>

#include <algorithm>
#include <utility>

#include "core/bake/table_size.h"

namespace nacre {
namespace {

bool uses_picture(const Design& design) {
    return std::any_of(design.distribution.layers.begin(), design.distribution.layers.end(),
                       [](const Layer& l) { return l.enabled && l.weight > 0 && holds_picture(l); });
}

void list_omissions(const Design& design, BakePlan& plan) {
    auto leave_out = [&](Part part, const char* what, std::string why) {
        plan.omissions.push_back({part, what, std::move(why)});
    };
    switch (plan.symmetry.symmetry) {
        case Symmetry::isotropic:
            leave_out(Part::symmetric_nodes, "azimuth of every table", "p depends on theta alone");
            break;
        case Symmetry::quarter:
            leave_out(Part::symmetric_nodes, "three quarters of every table", "p has two mirror planes");
            break;
        case Symmetry::half:
            leave_out(Part::symmetric_nodes, "half of every table", "p has one mirror plane");
            break;
        case Symmetry::none:
            break;
    }
    if (!plan.albedo) leave_out(Part::albedo, "albedo tables R0 and R1", "no diffuse term or light reads R");
    if (plan.albedo && plan.fresnel_tables == 0)
        leave_out(Part::fresnel_table, "Fresnel albedo table", "F = 1");
    if (plan.fresnel_tables == 1)
        leave_out(Part::fresnel_colours, "Fresnel albedo for each colour", "Schlick's R is linear in f0");
    if (!uses_picture(design)) leave_out(Part::pictures, "pictures", "no layer is painted or modulated");
    if (fresnel_tables(design.fresnel) == FresnelTables::none)
        leave_out(Part::fresnel, "Fresnel factor", "F = 1");
    for (std::size_t i = 0; i < KindSet<MaskingModel>::count; ++i)
        if (const char* part = masking_part(i); part && i != design.shadowing.model.index())
            leave_out(Part::masking, part, fmt::format("masking is {}", kind_name(design.shadowing.model)));
    if (std::holds_alternative<NoDiffuse>(design.diffuse))
        leave_out(Part::diffuse, "diffuse term", "the design has none");
}

}  // namespace

BakePlan plan_bake(const Design& design, const PlanOptions& options) {
    BakePlan plan;
    plan.symmetry = find_symmetry(design.distribution);
    if (options.symmetry) plan.symmetry.symmetry = std::max(plan.symmetry.symmetry, *options.symmetry);
    plan.quality = options.quality;
    plan.albedo = options.albedo || reads_albedo(design.diffuse);
    if (plan.albedo) {
        switch (fresnel_tables(design.fresnel)) {
            case FresnelTables::none:
                break;
            case FresnelTables::linear:
                plan.fresnel_tables = 1;
                break;
            case FresnelTables::exact:
                plan.fresnel_tables = 3;
                break;
        }
    }
    plan.nodes = options.size ? *options.size : first_size(plan.symmetry.symmetry, options.quality);
    list_omissions(design, plan);
    return plan;
}

}  // namespace nacre
