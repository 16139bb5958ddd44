// What every call of the operating system needs.
#pragma once

#include <unistd.h>

#include <cerrno>
#include <string>
#include <system_error>

namespace nacre {

// Calls until no signal comes between. A negative result is an error, told by errno.
template <class Call>
auto uninterrupted(const Call& call) {
    for (;;) {
        const auto result = call();
        if (result >= 0 || errno != EINTR) return result;
    }
}

inline std::string system_reason(int error) { return std::generic_category().message(error); }

// Closed at the end. After an interruption too Linux has closed it.
struct Descriptor {
    explicit Descriptor(int opened) : number(opened) {}
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;
    ~Descriptor() {
        if (number >= 0) ::close(number);
    }
    const int number;
};

}  // namespace nacre
