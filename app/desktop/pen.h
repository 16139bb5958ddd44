// The pressure of a pen, by XInput2: GLFW tells of pointers alone.
#pragma once

#include <memory>
#include <optional>

namespace nacre {

class Pen {
  public:
    // Without an X server, as under Wayland alone, there is no pen.
    Pen();
    ~Pen();
    Pen(const Pen&) = delete;
    Pen& operator=(const Pen&) = delete;

    // Of the pen that has moved last, 0 to 1; nothing where that was a mouse.
    std::optional<double> pressure();

  private:
    class Connection;
    std::unique_ptr<Connection> connection_;
};

}  // namespace nacre
