# nacre_embed(TARGET FILE...): makes objects whose function
# `std::string_view nacre::shader_text(std::string_view name)` returns the text of each file.
function(nacre_embed target)
    set(body "")
    foreach(file IN LISTS ARGN)
        set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${file})
        file(READ ${file} text)
        file(RELATIVE_PATH name ${CMAKE_CURRENT_SOURCE_DIR} ${CMAKE_CURRENT_SOURCE_DIR}/${file})
        string(APPEND body "    {\"${name}\", R\"nacre_text(${text})nacre_text\"},\n")
    endforeach()
    set(source ${CMAKE_CURRENT_BINARY_DIR}/${target}.cpp)
    file(CONFIGURE OUTPUT ${source} @ONLY CONTENT
"#include \"shaders/shader_text.h\"
#include <utility>
namespace nacre {
namespace {
constexpr std::pair<std::string_view, std::string_view> texts[] = {
@body@};
}
std::string_view shader_text(std::string_view name) {
    for (const auto& [key, text] : texts)
        if (key == name) return text;
    return {};
}
}  // namespace nacre
")
    add_library(${target} OBJECT ${source})
    nacre_publish(${NACRE_ROOMS}/shaders shaders)
    target_include_directories(${target} PUBLIC ${NACRE_ROOMS}/shaders)
    target_link_libraries(${target} PRIVATE nacre_options)
endfunction()
