// All of standard input at once.
#pragma once

#include <filesystem>
#include <string>

namespace nacre::cli {

// As errors call it.
inline constexpr const char* standard_input = "standard input";

// Up to limits::file_bytes_max; what is wrong is a UserError of `standard input`.
std::string read_standard_input();

// The same as a file, for what reads nothing else. It lies in memory and goes with the object.
class SpooledInput {
  public:
    SpooledInput();
    SpooledInput(const SpooledInput&) = delete;
    SpooledInput& operator=(const SpooledInput&) = delete;
    ~SpooledInput();

    std::filesystem::path path() const;

  private:
    int descriptor_ = -1;
};

}  // namespace nacre::cli
