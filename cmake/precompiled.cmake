# Precompiled headers: those of libraries, which take most of the time of a small source. Sources include what they need
# all the same: clang-tidy and scripts/other-debian read them without this.

# nacre_precompiled(NAME TARGETS TARGET... HEADERS HEADER...): HEADERS compiled once, as a target that needs TARGETS would.
function(nacre_precompiled name)
    cmake_parse_arguments(PARSE_ARGV 1 made "" "" "TARGETS;HEADERS;OPTIONS")
    if(NOT NACRE_PRECOMPILED)
        return()
    endif()
    set(source ${CMAKE_CURRENT_BINARY_DIR}/${name}.cpp)
    file(CONFIGURE OUTPUT ${source} CONTENT "")
    add_library(${name} OBJECT ${source})
    target_link_libraries(${name} PRIVATE nacre_options ${made_TARGETS})
    # For ccache: what it hashes must not depend on the clock.
    target_compile_options(${name} PRIVATE ${made_OPTIONS}
        $<$<CXX_COMPILER_ID:GNU>:-fpch-preprocess> "$<$<CXX_COMPILER_ID:Clang>:SHELL:-Xclang -fno-pch-timestamp>")
    list(TRANSFORM made_HEADERS REPLACE "^([^\"].*)$" "<\\1>")
    target_precompile_headers(${name} PRIVATE ${made_HEADERS})
endfunction()

# nacre_use_precompiled(TARGET NAME): the sources of TARGET, compiled with the same options, begin with what NAME has precompiled.
function(nacre_use_precompiled target name)
    if(TARGET ${name})
        target_precompile_headers(${target} REUSE_FROM ${name})
    endif()
endfunction()
