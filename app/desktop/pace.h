// When to draw the next frame: sixty times a second while something moves, not at all while nothing
// does.
#pragma once

namespace nacre {

class Pace {
  public:
    // Waits for input or for the next frame's time. Returns whether there is anything to draw.
    bool wait(bool in_motion);

  private:
    void stay_active(double now);

    double frame_begin_ = 0;  // seconds on GLFW's clock
    double active_until_ = 1;
    int frames_left_ = 0;
};

}  // namespace nacre
