# A room is a folder of sources that may include its own headers and those of the rooms it needs, and no others.
# Each publishes one folder of the build, where ROOM is a link to the sources: #include "core/ROOM/file.h" is found by
# those alone who need the room.

# nacre_publish(FOLDER PATH): the folder PATH of the source tree as it is included from FOLDER.
function(nacre_publish folder path)
    cmake_path(GET path PARENT_PATH parent)
    file(MAKE_DIRECTORY ${folder}/${parent})
    file(CREATE_LINK ${PROJECT_SOURCE_DIR}/${path} ${folder}/${path} SYMBOLIC)
endfunction()

# nacre_room(ROOM [NEEDS ROOM...] [LIBRARIES TARGET...]): the sources of core/ROOM as objects. Who needs the room sees
# what it needs; LIBRARIES are for its own sources.
function(nacre_room name)
    cmake_parse_arguments(PARSE_ARGV 1 room "" "" "NEEDS;LIBRARIES")
    file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${name}/*.cpp)
    add_library(nacre_${name} OBJECT ${sources})
    nacre_publish(${NACRE_ROOMS}/${name} core/${name})
    target_include_directories(nacre_${name} PUBLIC ${NACRE_ROOMS}/${name})
    target_compile_features(nacre_${name} PUBLIC cxx_std_20)
    list(TRANSFORM room_NEEDS PREPEND nacre_)
    target_link_libraries(nacre_${name} PUBLIC ${room_NEEDS} PRIVATE nacre_options ${room_LIBRARIES})
    nacre_use_precompiled(nacre_${name} nacre_library_headers)
endfunction()
