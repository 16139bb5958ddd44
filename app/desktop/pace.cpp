#include "app/desktop/pace.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <imgui.h>

#include <algorithm>

namespace nacre {
namespace {

constexpr double frame_seconds = 1.0 / 60;
constexpr double least_wait = 0.001;  // even where frames are late: only a wait tells whether input came
constexpr double idle_seconds = 0.5;  // between looks at an unmoved window; also a text cursor's blink
constexpr double settling_seconds =
    0.8;                             // drawn after the last change: hovering, delayed tooltips, key repeat
constexpr int settling_frames = 12;  // the same where frames take long

}  // namespace

bool Pace::wait(bool in_motion) {
    const double now = glfwGetTime();
    if (in_motion || ImGui::IsAnyMouseDown()) stay_active(now);
    const bool active = now < active_until_ || frames_left_ > 0;
    const double timeout = active ? std::max(frame_begin_ + frame_seconds - now, least_wait) : idle_seconds;
    glfwWaitEventsTimeout(timeout);
    const double after = glfwGetTime();
    const bool woken = after - now < timeout * 0.95;
    if (woken) stay_active(after);
    // Input that comes early waits for the frame's time: it is all drawn at once.
    if (woken && after < frame_begin_ + frame_seconds) return false;
    frame_begin_ = after;
    if (frames_left_ > 0) --frames_left_;
    return active || woken || ImGui::GetIO().WantTextInput;
}

void Pace::stay_active(double now) {
    active_until_ = now + settling_seconds;
    frames_left_ = settling_frames;
}

}  // namespace nacre
