// What the search field finds, and what happens when it is chosen.
#pragma once

namespace nacre {

struct Designer;

// Draws the field while it is open, and does what is chosen.
void draw_finder(Designer& designer);

}  // namespace nacre
