# nacre-cli used as a shell would use it.
find_package(nlohmann_json REQUIRED)
find_package(OpenImageIO REQUIRED)
nacre_test_program(nacre-test-cli cli nacre_core nlohmann_json::nlohmann_json OpenImageIO::OpenImageIO)
target_compile_definitions(nacre-test-cli PRIVATE NACRE_CLI="$<TARGET_FILE:nacre-cli>")
nacre_use_precompiled(nacre-test-cli nacre_test_headers)
add_dependencies(nacre-test-cli nacre-cli)
