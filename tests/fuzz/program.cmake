# Fuzz targets (libFuzzer): one program a reader, one a picture format. clang, with core instrumented as the
# preset asan has it.
find_package(nlohmann_json REQUIRED)
find_package(fmt REQUIRED)
find_package(ZLIB REQUIRED)
find_package(PkgConfig REQUIRED)
pkg_check_modules(WebP REQUIRED IMPORTED_TARGET libwebp libwebpdemux)
find_path(NACRE_IMGUI_INCLUDE imgui.h PATH_SUFFIXES imgui REQUIRED)
find_library(NACRE_IMGUI_LIBRARY imgui REQUIRED)
find_library(NACRE_STB_LIBRARY stb REQUIRED)

# nacre_fuzz_target(NAME SOURCE...): nacre-fuzz-NAME from its file and the readers that core does not hold.
function(nacre_fuzz_target name)
    add_executable(nacre-fuzz-${name} ${ARGN})
    target_link_libraries(nacre-fuzz-${name} PRIVATE nacre_options nacre_core)
    target_link_options(nacre-fuzz-${name} PRIVATE -fsanitize=fuzzer)
    add_dependencies(nacre-fuzz nacre-fuzz-${name})
endfunction()

add_custom_target(nacre-fuzz)
# The app is not built here; its readers are.
nacre_publish(${NACRE_ROOMS}/app app)
nacre_publish(${NACRE_ROOMS}/ui ui)
include_directories(${NACRE_ROOMS}/app ${NACRE_ROOMS}/ui)
set(app ${PROJECT_SOURCE_DIR}/app)
nacre_fuzz_target(design fuzz/fuzz_design.cpp)
nacre_fuzz_target(obj fuzz/fuzz_obj.cpp)
nacre_fuzz_target(events fuzz/fuzz_events.cpp ${app}/headless/event_script.cpp ${PROJECT_SOURCE_DIR}/ui/key_press.cpp ${PROJECT_SOURCE_DIR}/ui/keys.cpp)
target_include_directories(nacre-fuzz-events SYSTEM PRIVATE ${NACRE_IMGUI_INCLUDE})
target_link_libraries(nacre-fuzz-events PRIVATE ${NACRE_IMGUI_LIBRARY} ${NACRE_STB_LIBRARY})
file(GLOB line_sources ${app}/cli/direction_lines.cpp ${app}/cli/line_source.cpp
    ${app}/cli/output.cpp ${app}/cli/progress.cpp ${app}/cli/message.cpp)
nacre_fuzz_target(lines fuzz/fuzz_lines.cpp ${line_sources})
target_link_libraries(nacre-fuzz-lines PRIVATE TBB::tbb)
set(kept ${app}/designer/private_json_file.cpp)
nacre_fuzz_target(settings fuzz/fuzz_settings.cpp ${app}/designer/settings.cpp ${kept})
nacre_fuzz_target(recent fuzz/fuzz_recent.cpp ${app}/designer/recent_files.cpp ${kept})
nacre_fuzz_target(unsaved fuzz/fuzz_unsaved.cpp ${app}/designer/autosave.cpp ${app}/designer/document.cpp ${kept})
foreach(target settings recent unsaved)
    target_link_libraries(nacre-fuzz-${target} PRIVATE nlohmann_json::nlohmann_json)
endforeach()

# The sources of core/pictures, so that they are instrumented and linked as one program.
file(GLOB picture_sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/core/pictures/*.cpp)
add_library(nacre_fuzz_pictures OBJECT ${picture_sources})
target_include_directories(nacre_fuzz_pictures PUBLIC ${NACRE_ROOMS}/base ${NACRE_ROOMS}/image ${NACRE_ROOMS}/pictures)
target_compile_definitions(nacre_fuzz_pictures PRIVATE NACRE_VERSION="${PROJECT_VERSION}")
target_link_libraries(nacre_fuzz_pictures PUBLIC nacre_options nacre_common nacre_utf8cpp OpenImageIO::OpenImageIO PkgConfig::WebP
    ZLIB::ZLIB)
foreach(format png jpeg openexr tiff hdr pnm webp targa bmp psd dds jpeg2000 heif)
    nacre_fuzz_target(${format} fuzz/fuzz_picture.cpp)
    target_compile_definitions(nacre-fuzz-${format} PRIVATE NACRE_FUZZ_FORMAT="${format}")
    target_link_libraries(nacre-fuzz-${format} PRIVATE nacre_fuzz_pictures)
endforeach()
