# The readers that the documents name, run by Debian's Python, which has their modules.
find_program(NACRE_DEBIAN_PYTHON python3 HINTS /usr/bin NO_DEFAULT_PATH REQUIRED)
foreach(reader read_tables call_glsl call_hlsl formulas)
    add_test(NAME "docs: ${reader}.py"
        COMMAND ${NACRE_DEBIAN_PYTHON} -B ${CMAKE_CURRENT_SOURCE_DIR}/docs/${reader}.py
                $<TARGET_FILE:nacre-cli> ${CMAKE_SOURCE_DIR} ${CMAKE_BINARY_DIR}/docs-test)
    set_tests_properties("docs: ${reader}.py" PROPERTIES TIMEOUT 900)
endforeach()
foreach(check links arrows)
    add_test(NAME "docs: ${check}"
        COMMAND ${NACRE_DEBIAN_PYTHON} -B ${CMAKE_CURRENT_SOURCE_DIR}/docs/${check}.py ${CMAKE_SOURCE_DIR})
endforeach()
