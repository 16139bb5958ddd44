#include "core/model/float_shading.h"

#include "core/model/parameter_fields.h"

namespace nacre {

Shading<float> in_float(const Shading<double>& from) {
    Shading<float> to;
    copy_surface(to, from);
    return to;
}

}  // namespace nacre
