// Measurements with a limit of processor time.
#pragma once

#include <ctime>
#include <functional>

namespace nacre {

// Of the processor, all threads of the process together.
class Effort {
  public:
    explicit Effort(double seconds) : end_(static_cast<double>(std::clock()) + seconds * CLOCKS_PER_SEC) {}
    bool left() const { return static_cast<double>(std::clock()) < end_; }

  private:
    double end_;
};

// visit(i) for i = 0, 1, ... in parallel: all `count`, or `least` and as many more as `seconds` of processor
// time allow. Gives how many. progress(part done) comes from the calling thread.
int visit_within(double seconds, int count, int least, const std::function<void(int)>& visit,
                 const std::function<void(double)>& progress = {});

}  // namespace nacre
