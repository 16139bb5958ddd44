#pragma once

namespace nacre {

// Where V has kinks besides the horizon of k2, at which integration must be split.
enum class MaskingBends {
    none,
    horizon,  // in a thin layer beside the horizon
    azimuth   // there, and where k1 and k2 are in one plane with n
};

}  // namespace nacre
