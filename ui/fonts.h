// The interface's typeface (Inter, SIL Open Font License 1.1) as embedded OpenType files.
#pragma once

#include <span>

namespace nacre::ui {

std::span<const unsigned char> font_regular();
std::span<const unsigned char> font_semibold();

}  // namespace nacre::ui
