#pragma once

#include <doctest/doctest.h>

#include <string>

#include "core/base/error.h"

namespace nacre::test {

// The line of the UserError that `call` throws, or an empty text when it throws none. The line must
// be one line that names the error's file and place.
template <class Call>
std::string user_error_of(const Call& call) {
    try {
        call();
    } catch (const UserError& error) {
        const std::string line = error.what();
        CHECK(line.find_first_of("\n\r\t") == std::string::npos);
        CHECK(line.size() < 2000);
        CHECK_FALSE(error.file.empty());
        CHECK_FALSE(error.where.empty());
        CHECK_FALSE(error.problem.empty());
        CHECK(line.starts_with(one_line(error.file) + ": "));
        return line;
    }
    return {};
}

}  // namespace nacre::test
