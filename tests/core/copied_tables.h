// Tables that a test may spoil.
#pragma once

#include "core/bake/tables.h"

namespace nacre::test {

inline std::shared_ptr<Tables> copy_of(const Tables& good) {
    auto tables = std::make_shared<Tables>();
    tables->needs = good.needs;
    tables->omissions = good.omissions;
    tables->quality = good.quality;
    tables->size = good.size;
    tables->distribution = good.distribution;
    tables->data = good.data;
    tables->shading = good.shading;
    tables->shading.data = tables->data.data();
    tables->mean = good.mean;
    tables->mean_albedo = good.mean_albedo;
    tables->tolerance = good.tolerance;
    tables->errors = good.errors;
    return tables;
}

}  // namespace nacre::test
