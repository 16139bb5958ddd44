// What every fuzz target asks of a reader.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <string_view>

#include "core/base/error.h"

namespace nacre::fuzz {

inline std::string text_of(const std::uint8_t* data, std::size_t size) {
    return {reinterpret_cast<const char*>(data), size};
}

// Ends the run with the input that was tried.
inline void require(bool holds, const char* what) {
    if (holds) return;
    std::fprintf(stderr, "not so: %s\n", what);
    std::abort();
}

// A refusal is one printable line, whatever the input holds.
inline void require_one_line(const UserError& error) {
    const std::string_view line = error.what();
    require(!line.empty(), "an error says something");
    require(line == one_line(line), "an error is one printable line");
}

// Reads; what is wrong with the input may only be a UserError. Returns whether it was read.
template <class Read>
bool reads(const Read& read) {
    try {
        read();
        return true;
    } catch (const UserError& error) {
        require_one_line(error);
        return false;
    }
}

}  // namespace nacre::fuzz
