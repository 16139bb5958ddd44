# nacre_embed_texts(TARGET FUNCTION FOLDER FILE...): adds a source to the target whose function
# `std::string_view nacre::FUNCTION(std::string_view name)` returns the text of each file by its name in the folder, or
# an empty one.
function(nacre_embed_texts target function folder)
    set(body "")
    foreach(file IN LISTS ARGN)
        set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${folder}/${file})
        file(READ ${folder}/${file} text)
        string(APPEND body "        {\"${file}\", R\"nacre_text(${text})nacre_text\"},\n")
    endforeach()
    set(source ${CMAKE_CURRENT_BINARY_DIR}/${function}.cpp)
    file(CONFIGURE OUTPUT ${source} @ONLY CONTENT
"#include <string_view>
#include <utility>
namespace nacre {
std::string_view ${function}(std::string_view name);
std::string_view ${function}(std::string_view name) {
    static constexpr std::pair<std::string_view, std::string_view> texts[] = {
@body@    };
    for (const auto& [key, text] : texts)
        if (key == name) return text;
    return {};
}
}  // namespace nacre
")
    target_sources(${target} PRIVATE ${source})
endfunction()
