// When to draw the next frame: sixty times a second while something moves, not at all while nothing
// does. The caller waits, and gives the time on a clock of its own, in seconds.
#pragma once

namespace nacre {

class Pace {
  public:
    // How long to wait for input before the next look. `in_motion`: what is shown changes by itself.
    double wait(double now, bool in_motion);

    // After the wait: whether there is a frame to draw. `noticed`: something came that may show in it. It is
    // not forgotten where its frame comes later.
    bool due(double now, bool noticed, bool typing);

  private:
    void stay_active(double now);

    double frame_begin_ = 0;
    double active_until_ = 1;
    int frames_left_ = 0;
    bool active_ = false;  // as the wait began
};

}  // namespace nacre
