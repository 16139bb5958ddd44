# Every target of ours: warnings are errors, and IEEE arithmetic stays as written (reciprocity to the
# last bit and tables that do not depend on the machine need it).
add_library(nacre_options INTERFACE)
target_compile_options(nacre_options INTERFACE
    -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wno-sign-conversion -Werror -ffp-contract=off)
# g++ 12 warns of overlaps in std::string's own operator+ (GCC bug 105651).
target_compile_options(nacre_options INTERFACE $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict>)
if(NACRE_PRECOMPILED)
    # It warns of more in there where <string> is precompiled (GCC bug 105329).
    target_compile_options(nacre_options INTERFACE
        $<$<CXX_COMPILER_ID:GNU>:-Wno-array-bounds$<SEMICOLON>-Wno-stringop-overflow>)
endif()
if(NACRE_SANITIZE)
    # Instrumented, std::regex and std::function look uninitialised to g++ 12 (GCC bug 105562).
    target_compile_options(nacre_options INTERFACE $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized>)
    target_compile_options(nacre_options INTERFACE -fsanitize=${NACRE_SANITIZE} -fno-omit-frame-pointer)
    target_link_options(nacre_options INTERFACE -fsanitize=${NACRE_SANITIZE})
endif()
