#pragma once

namespace nacre {

// Where V bends besides at the horizon of k2, so that integration must cut there.
enum class MaskingBends {
    none,
    horizon,  // in a thin layer beside the horizon
    azimuth   // there, and where k1 and k2 stand in one plane with n
};

}  // namespace nacre
