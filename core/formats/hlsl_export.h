// A design as HLSL functions, tables and all.
#pragma once

#include <string>

#include "core/bake/tables.h"
#include "core/design/design.h"

namespace nacre {

// HLSL that defines `float3 PREFIX_brdf(float3 k1, float3 k2)`, `float4 PREFIX_sample(float3 k2, float3 u)`,
// `float PREFIX_pdf(float3 k1, float3 k2)` and, where R is baked, `float3 PREFIX_albedo(float3 k)`. Every
// name begins with PREFIX_. It needs no texture: tables and pictures are a constant array, read by
// PREFIX_fetch alone.
std::string hlsl_export(const Design& design, const Tables& tables, const std::string& prefix = "nacre");

}  // namespace nacre
