// The shading of baked tables in float, as a renderer on the CPU would hold it.
#pragma once

#include "core/bake/tables.h"
#include "core/exchange/parameter_fields.h"

namespace nacre::bench {

// Reads the tables' data: they must outlive it.
inline Shading<float> float_shading(const Tables& tables) {
    const Shading<double>& from = tables.shading;
    Shading<float> to;
    to.kinds = from.kinds;
    to.layer_count = from.layer_count;
    to.data = from.data;
    const auto copy = [](const char*, auto& field, const auto& value) {
        field = std::remove_reference_t<decltype(field)>(value);
    };
    visit_surface_fields(copy, to.surface, from.surface);
    visit_table_fields(copy, to.surface.tables, from.surface.tables);
    for (int i = 0; i < from.layer_count; ++i) visit_layer_fields(copy, to.layers[i], from.layers[i]);
    return to;
}

}  // namespace nacre::bench
