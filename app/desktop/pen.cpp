#include "app/desktop/pen.h"

#include <X11/Xlib.h>
#include <X11/extensions/XInput2.h>

#include <map>

#include "app/designer/pressure_axis.h"

namespace nacre {

// A connection of our own, so that GLFW's events stay GLFW's.
class Pen::Connection {
  public:
    static std::unique_ptr<Connection> open() {
        Display* const display = XOpenDisplay(nullptr);
        if (display == nullptr) return nullptr;
        std::unique_ptr<Connection> connection(new Connection(display));
        int event = 0, error = 0, major = 2, minor = 0;
        if (XQueryExtension(display, "XInputExtension", &connection->extension_, &event, &error) == 0 ||
            XIQueryVersion(display, &major, &minor) != Success)
            return nullptr;
        connection->select_events();
        connection->find_axes();
        return connection;
    }
    ~Connection() { XCloseDisplay(display_); }
    Connection(const Connection&) = delete;
    Connection& operator=(const Connection&) = delete;

    std::optional<double> pressure() {
        while (XPending(display_) > 0) {
            XEvent event;
            XNextEvent(display_, &event);
            XGenericEventCookie& cookie = event.xcookie;
            if (cookie.type != GenericEvent || cookie.extension != extension_ ||
                XGetEventData(display_, &cookie) == 0)
                continue;
            take(cookie);
            XFreeEventData(display_, &cookie);
        }
        return pressure_;
    }

  private:
    explicit Connection(Display* display)
        : display_(display), pressure_label_(XInternAtom(display, "Abs Pressure", False)) {}

    void select_events() {
        unsigned char bits[XIMaskLen(XI_LASTEVENT)] = {};
        for (const int event : {XI_RawMotion, XI_RawButtonPress, XI_HierarchyChanged}) XISetMask(bits, event);
        XIEventMask mask{.deviceid = XIAllDevices, .mask_len = sizeof bits, .mask = bits};
        XISelectEvents(display_, DefaultRootWindow(display_), &mask, 1);
        XFlush(display_);
    }

    void find_axes() {
        axes_.clear();
        int count = 0;
        XIDeviceInfo* const devices = XIQueryDevice(display_, XIAllDevices, &count);
        for (int i = 0; i < count; ++i)
            for (int j = 0; j < devices[i].num_classes; ++j) {
                const XIAnyClassInfo& any = *devices[i].classes[j];
                if (any.type != XIValuatorClass) continue;
                const auto& axis = reinterpret_cast<const XIValuatorClassInfo&>(any);
                if (axis.label == pressure_label_)
                    axes_[devices[i].deviceid] = {axis.number, axis.min, axis.max};
            }
        if (devices != nullptr) XIFreeDeviceInfo(devices);
    }

    void take(const XGenericEventCookie& cookie) {
        if (cookie.evtype == XI_HierarchyChanged) return find_axes();
        const auto& event = *static_cast<const XIRawEvent*>(cookie.data);
        // Older servers leave the source at 0.
        const auto axis = axes_.find(event.sourceid != 0 ? event.sourceid : event.deviceid);
        if (axis == axes_.end()) {
            pressure_.reset();
            return;
        }
        const XIValuatorState& state = event.valuators;
        const auto now = pressure_of(axis->second, {state.mask, std::size_t(state.mask_len)}, state.values);
        if (now) pressure_ = now;  // axes that have not changed are not told
    }

    Display* display_;
    Atom pressure_label_;
    int extension_ = 0;
    std::map<int, PressureAxis> axes_;  // of each device that has one
    std::optional<double> pressure_;
};

Pen::Pen() : connection_(Connection::open()) {}
Pen::~Pen() = default;

std::optional<double> Pen::pressure() {
    return connection_ ? connection_->pressure() : std::optional<double>();
}

}  // namespace nacre
