#include <fmt/core.h>

#include "core/bake/bake.h"
#include "core/study/method.h"
#include "core/verify/table_error.h"

namespace nacre {
namespace {

StoredTable stored(const std::shared_ptr<const Tables>& tables) {
    return {
        .area =
            [tables](dvec3 k) { return tables->shading.projected_area(k, tables->shading.table_spot(k)); },
        .albedo = [tables](dvec3 k) { return read_albedo(tables->shading, k, tables->needs.fresnel_tables); },
        .bytes = tables->table_floats() * sizeof(float)};
}

MethodSetting setting(const Design& design, std::string label, BakeOptions options) {
    options.threads = 1;
    return {std::move(label), [&design, options](Wanted wanted, const std::stop_token& stop) {
                BakeOptions wished = options;
                wished.albedo = wanted == Wanted::area_and_albedo;
                return stored(bake(design, wished, stop));
            }};
}

// As many azimuths as cover the kept range about as densely as theta is covered.
TableSize size_of(int polar, Symmetry symmetry) {
    const int cells = polar - 1;
    int azimuths = 1;
    if (symmetry == Symmetry::quarter) azimuths = cells / 2 + 1;
    if (symmetry == Symmetry::half) azimuths = cells + 1;
    if (symmetry == Symmetry::none) azimuths = 2 * cells;
    return {polar, azimuths, polar, azimuths};
}

}  // namespace

Method stretched_method(const Design& design) {
    Method method{
        .kind = MethodKind::stretched,
        .name = "stretched tables",
        .about =
            "directions stretched by p's own width, bilinear (shaders/shared/tables.glsl); exact g in the "
            "nodes, R by the bake's own rule"};
    const Symmetry symmetry = find_symmetry(design.distribution).symmetry;
    for (int cells = 4; cells <= 256; cells *= 2) {
        const TableSize size = size_of(cells + 1, symmetry);
        method.settings.push_back(
            setting(design, fmt::format("{} x {} nodes", size.w, size.psi), {.size = size}));
    }
    return method;
}

Method bake_method(const Design& design) {
    return {
        .kind = MethodKind::bake,
        .name = "Nacre's bake",
        .about =
            "the stretched tables as `bake` chooses their size: the draft that is shown while a slider is "
            "dragged, and the final tables",
        .settings = {setting(design, "draft", {.quality = Quality::draft}), setting(design, "final", {})}};
}

}  // namespace nacre
