// The display transform's curve in C++: shaders/develop.frag has the same.
#pragma once

namespace nacre {

// What is shown, in [0, 1], of radiance times exposure (Hable 2010).
double filmic(double radiance);

// Its inverse for `shown` in [0, 1).
double unfilmic(double shown);

}  // namespace nacre
