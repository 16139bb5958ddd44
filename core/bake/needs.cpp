#include "core/bake/needs.h"

#include <fmt/core.h>

#include <algorithm>
#include <utility>

namespace nacre {
namespace {

bool uses_picture(const Design& design) {
    return std::any_of(design.distribution.layers.begin(), design.distribution.layers.end(),
                       [](const Layer& l) { return counts(l) && holds_picture(l); });
}

int count_fresnel_tables(const Fresnel& fresnel) {
    switch (fresnel_tables(fresnel)) {
        case FresnelTables::none:
            return 0;
        case FresnelTables::linear:
            return 1;
        case FresnelTables::exact:
            return 3;
    }
    return 0;
}

}  // namespace

Needs needs_of(const Design& design, const MoreNeeds& more) {
    Needs needs;
    needs.symmetry = find_symmetry(design.distribution);
    if (more.symmetry) needs.symmetry.symmetry = std::max(needs.symmetry.symmetry, *more.symmetry);
    needs.albedo = more.albedo || reads_albedo(design.diffuse) || has_bounces(design.multibounce) ||
                   is_coated(design.coat);
    needs.tint = tint_of(design.distribution);
    if (needs.albedo) needs.fresnel_tables = count_fresnel_tables(design.fresnel);
    return needs;
}

std::vector<Omission> omissions_of(const Design& design, const Needs& needs) {
    std::vector<Omission> omissions;
    auto leave_out = [&](Part part, const char* what, std::string why) {
        omissions.push_back({part, what, std::move(why)});
    };
    switch (needs.symmetry.symmetry) {
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
    if (!needs.albedo) leave_out(Part::albedo, "albedo tables R0 and R1", "no diffuse term or light reads R");
    if (needs.albedo && needs.fresnel_tables == 0)
        leave_out(Part::fresnel_table, "Fresnel albedo table", "F = 1");
    if (needs.fresnel_tables == 1 && needs.tint != Tint::varied)
        leave_out(Part::fresnel_colours, "Fresnel albedo for each colour", "Schlick's R is linear in f0");
    if (!uses_picture(design)) leave_out(Part::pictures, "pictures", "no layer is painted or modulated");
    if (fresnel_tables(design.fresnel) == FresnelTables::none)
        leave_out(Part::fresnel, "Fresnel factor", "F = 1");
    for (std::size_t i = 0; i < KindSet<MaskingModel>::count; ++i)
        if (const char* part = masking_part(i); part && i != design.shadowing.model.index())
            leave_out(Part::masking, part, fmt::format("masking is {}", kind_name(design.shadowing.model)));
    if (std::holds_alternative<NoDiffuse>(design.diffuse))
        leave_out(Part::diffuse, "diffuse term", "the design has none");
    return omissions;
}

}  // namespace nacre
