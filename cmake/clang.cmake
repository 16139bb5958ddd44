# The compiler of the preset asan: the clang that this Debian has.
find_program(NACRE_CLANG NAMES clang++-14 clang++-19 REQUIRED)
set(CMAKE_CXX_COMPILER ${NACRE_CLANG})
