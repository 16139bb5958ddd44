// The artist's habits from the designer, and back into it.
#pragma once

#include "app/designer/habits.h"

namespace nacre {

struct Designer;

Habits habits_of(const Designer& designer);
void take_up(Designer& designer, const Habits& habits);

}  // namespace nacre
