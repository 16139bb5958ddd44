# A program that works until it is killed, and the test that kills it.
add_executable(nacre-crash-child crash/child/main.cpp crash/child/shortage.cpp)
target_link_libraries(nacre-crash-child PRIVATE nacre_options nacre_headless)
nacre_test_program(nacre-test-crash crash nacre_headless)
target_compile_definitions(nacre-test-crash PRIVATE NACRE_CRASH_CHILD="$<TARGET_FILE:nacre-crash-child>")
add_dependencies(nacre-test-crash nacre-crash-child nacre-cli)
