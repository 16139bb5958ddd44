// Makes one system call of this process fail: its calls of libc go through tests/faults/fault.cpp, which is
// part of the program or preloaded.
#pragma once

#include <atomic>
#include <string>
#include <vector>

namespace nacre::test {

struct Fault {
    std::string call;    // "write"
    int number = 1;      // the first, second, ... of that name that concerns something in the folder
    int error = 0;       // what errno becomes; 0: of a write, half of it is done
    std::string folder;  // absolute
};

// From now on. Whatever thread calls.
void begin_fault(const Fault& fault);

// No more. Returns whether the call came.
bool end_fault();

// Those that can fail.
std::vector<std::string> fault_calls();

}  // namespace nacre::test
