#include "core/model/float_shading.h"

#include <type_traits>

#include "core/model/parameter_fields.h"

namespace nacre {

Shading<float> in_float(const Shading<double>& from) {
    Shading<float> to;
    to.kinds = from.kinds;
    to.layer_count = from.layer_count;
    to.data = from.data;
    const auto narrow = [](const char*, auto& field, const auto& value) {
        field = std::remove_reference_t<decltype(field)>(value);
    };
    visit_surface_fields(narrow, to.surface, from.surface);
    visit_table_fields(narrow, to.surface.tables, from.surface.tables);
    for (int i = 0; i < from.layer_count; ++i) visit_layer_fields(narrow, to.layers[i], from.layers[i]);
    return to;
}

}  // namespace nacre
