# Every system call of a save, an export and an autosave made to fail. The calls of the test program go through
# fault.cpp; the same as a library is preloaded into nacre-cli.
add_library(nacre-fault SHARED faults/fault.cpp)
target_include_directories(nacre-fault PRIVATE ${PROJECT_SOURCE_DIR})
target_link_libraries(nacre-fault PRIVATE nacre_options ${CMAKE_DL_LIBS})
nacre_test_program(nacre-test-faults faults nacre_headless ${CMAKE_DL_LIBS})
target_compile_definitions(nacre-test-faults PRIVATE
    NACRE_CLI="$<TARGET_FILE:nacre-cli>" NACRE_FAULT_LIBRARY="$<TARGET_FILE:nacre-fault>")
target_sources(nacre-test-faults PRIVATE cli/child_process.cpp)
add_dependencies(nacre-test-faults nacre-cli nacre-fault)
