#include "app/desktop/pace.h"

#include <algorithm>

namespace nacre {
namespace {

constexpr double frame_seconds = 1.0 / 60;
constexpr double least_wait = 0.001;  // even where frames are late: only a wait takes input
constexpr double idle_seconds = 0.5;  // between looks at an unmoved window; also a text cursor's blink
constexpr double settling_seconds =
    0.8;                             // drawn after the last change: hovering, delayed tooltips, key repeat
constexpr int settling_frames = 12;  // the same where frames take long

}  // namespace

double Pace::wait(double now, bool in_motion) {
    if (in_motion) stay_active(now);
    active_ = now < active_until_ || frames_left_ > 0;
    return active_ ? std::max(frame_begin_ + frame_seconds - now, least_wait) : idle_seconds;
}

bool Pace::due(double now, bool noticed, bool typing) {
    if (noticed) stay_active(now);
    // Input that comes early waits for the frame's time: it is all drawn at once.
    if (noticed && now < frame_begin_ + frame_seconds) return false;
    frame_begin_ = now;
    if (frames_left_ > 0) --frames_left_;
    return active_ || noticed || typing;
}

void Pace::stay_active(double now) {
    active_until_ = now + settling_seconds;
    frames_left_ = settling_frames;
}

}  // namespace nacre
