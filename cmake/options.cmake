# Everything that may be chosen with -D. Part of another project, nacre is the library alone.
option(NACRE_APP "build the designer, the command line and their tests" ${PROJECT_IS_TOP_LEVEL})
option(NACRE_INSTALL "install what is built" ${PROJECT_IS_TOP_LEVEL})
option(NACRE_TESTS "build the tests" ${PROJECT_IS_TOP_LEVEL})
option(NACRE_BENCH "build the benchmarks beside the tests" ${PROJECT_IS_TOP_LEVEL})
option(NACRE_FUZZ "build the fuzz targets beside the tests (clang)" OFF)
set(NACRE_SANITIZE "" CACHE STRING "sanitizers for every target: address,undefined or thread")
set(NACRE_FONT_FOLDER /usr/share/fonts/opentype/inter CACHE PATH "folder of Inter-Regular.otf and Inter-SemiBold.otf")
set(NACRE_MAINTAINER "Nacre contributors <nacre@example.org>" CACHE STRING "maintainer of the Debian package")
