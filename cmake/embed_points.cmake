# nacre_embed_points(TARGET FILE FUNCTION): adds a source to the target whose function
# `std::span<const std::array<double, 3>> nacre::FUNCTION()` returns the vertices (`v x y z`) of an OBJ file.
function(nacre_embed_points target file function)
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${file})
    file(READ ${file} text)
    string(REGEX REPLACE "#[^\n]*\n" "" text "${text}")
    string(REGEX REPLACE "v ([^ ]+) ([^ ]+) ([^\n]+)\n" "    {\\1, \\2, \\3},\n" points "${text}")
    set(source ${CMAKE_CURRENT_BINARY_DIR}/${function}.cpp)
    file(CONFIGURE OUTPUT ${source} @ONLY CONTENT
"#include <array>
#include <span>
namespace nacre {
std::span<const std::array<double, 3>> ${function}();
std::span<const std::array<double, 3>> ${function}() {
    static constexpr std::array<double, 3> points[] = {
@points@    };
    return points;
}
}  // namespace nacre
")
    target_sources(${target} PRIVATE ${source})
endfunction()
