#include "core/bake/plan.h"

#include <algorithm>

#include "core/bake/table_size.h"
#include "core/model/surface.h"

namespace nacre {
namespace {

template <class Kind>
bool uses(const Design& design) {
    return std::any_of(
        design.distribution.layers.begin(), design.distribution.layers.end(), [](const Layer& layer) {
            return layer.enabled && layer.weight > 0 && std::holds_alternative<Kind>(layer.lobe);
        });
}

bool uses_modulation(const Design& design) {
    return std::any_of(design.distribution.layers.begin(), design.distribution.layers.end(),
                       [](const Layer& l) { return l.enabled && l.weight > 0 && l.modulation.has_value(); });
}

void list_omissions(const Design& design, BakePlan& plan) {
    auto leave_out = [&](Part part, const char* what, const char* why) {
        plan.omissions.push_back({part, what, why});
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
    if (!uses<PaintedLobe>(design) && !uses_modulation(design))
        leave_out(Part::pictures, "pictures", "no layer is painted or modulated");
    const FresnelKind fresnel = kind_of(design.fresnel);
    if (fresnel != FresnelKind::conductor)
        leave_out(Part::conductor, "conductor arithmetic", "the Fresnel model does not need it");
    if (fresnel == FresnelKind::none) leave_out(Part::fresnel, "Fresnel factor", "F = 1");
    const VisibilityKind visibility = kind_of(design.shadowing.model);
    if (visibility != VisibilityKind::correlated)
        leave_out(Part::azimuth_correlation, "azimuth correlation t(phi)", "shadowing is not correlated");
    if (visibility != VisibilityKind::smith_correlated)
        leave_out(Part::height_correlation, "height correlation", "shadowing is not smith_correlated");
    if (kind_of(design.diffuse) == DiffuseKind::none)
        leave_out(Part::diffuse, "diffuse term", "the design has none");
}

}  // namespace

BakePlan plan_bake(const Design& design, const PlanOptions& options) {
    BakePlan plan;
    plan.symmetry = find_symmetry(design.distribution);
    if (options.symmetry) plan.symmetry.symmetry = std::max(plan.symmetry.symmetry, *options.symmetry);
    plan.quality = options.quality;
    const DiffuseKind diffuse = kind_of(design.diffuse);
    plan.albedo = options.albedo || diffuse == DiffuseKind::coupled || diffuse == DiffuseKind::metal;
    if (plan.albedo) {
        switch (kind_of(design.fresnel)) {
            case FresnelKind::none:
                break;
            case FresnelKind::schlick:
                plan.fresnel_tables = 1;
                break;
            case FresnelKind::dielectric:
            case FresnelKind::conductor:
                plan.fresnel_tables = 3;
                break;
        }
    }
    plan.nodes = options.size ? *options.size : first_size(plan.symmetry.symmetry, options.quality);
    list_omissions(design, plan);
    return plan;
}

}  // namespace nacre
