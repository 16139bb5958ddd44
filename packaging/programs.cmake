# The programs and what a desktop wants to know of them. They find presets and private libraries relative to
# themselves: the prefix may be anywhere.
set(NACRE_DEBIAN_REVISION 1)
# Of SOURCE_DATE_EPOCH where it is set: the same sources make the same package.
string(TIMESTAMP NACRE_RELEASE_DATE "%Y-%m-%d" UTC)
string(TIMESTAMP NACRE_RELEASE_TIME "%a, %d %b %Y %H:%M:%S +0000" UTC)

set(doc ${CMAKE_INSTALL_DATADIR}/doc/nacre)
set(icons ${CMAKE_INSTALL_DATADIR}/icons/hicolor)

install(TARGETS nacre nacre-cli RUNTIME DESTINATION bin)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/presets DESTINATION ${CMAKE_INSTALL_DATADIR}/nacre FILES_MATCHING PATTERN *.nacre)
install(FILES nacre.desktop DESTINATION ${CMAKE_INSTALL_DATADIR}/applications)
install(FILES nacre-mime.xml DESTINATION ${CMAKE_INSTALL_DATADIR}/mime/packages RENAME nacre.xml)
install(FILES nacre.svg DESTINATION ${icons}/scalable/apps)
install(FILES nacre.svg DESTINATION ${icons}/scalable/mimetypes RENAME application-x-nacre.svg)
install(FILES copyright ${PROJECT_SOURCE_DIR}/docs/file-format.md ${PROJECT_SOURCE_DIR}/docs/painting.md
    ${PROJECT_SOURCE_DIR}/docs/event-scripts.md DESTINATION ${doc})

set(metainfo io.github.nacre.nacre.metainfo.xml)
configure_file(${metainfo}.in ${metainfo} @ONLY)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/${metainfo} DESTINATION ${CMAKE_INSTALL_DATADIR}/metainfo)

# nacre_install_compressed(FILE DESTINATION NAME): as NAME.gz, or as it is where there is no gzip.
find_program(NACRE_GZIP gzip)
set(compressed_files "")
function(nacre_install_compressed file destination name)
    if(NOT NACRE_GZIP)
        install(FILES ${file} DESTINATION ${destination} RENAME ${name})
        return()
    endif()
    set(output ${CMAKE_CURRENT_BINARY_DIR}/${name}.gz)
    add_custom_command(OUTPUT ${output} DEPENDS ${file} VERBATIM
        COMMAND ${NACRE_GZIP} --best --no-name --stdout ${file} > ${output})
    install(FILES ${output} DESTINATION ${destination})
    set(compressed_files ${compressed_files} ${output} PARENT_SCOPE)
endfunction()
foreach(page nacre.1 nacre-cli.1)
    configure_file(${page} ${page} @ONLY)
    nacre_install_compressed(${CMAKE_CURRENT_BINARY_DIR}/${page} ${CMAKE_INSTALL_MANDIR}/man1 ${page})
endforeach()
configure_file(changelog.Debian.in changelog.Debian @ONLY)
nacre_install_compressed(${CMAKE_CURRENT_BINARY_DIR}/changelog.Debian ${doc} changelog.Debian)
nacre_install_compressed(${PROJECT_SOURCE_DIR}/CHANGELOG.md ${doc} changelog)

# Themes want pictures of the usual sizes beside the drawing; librsvg2-bin makes them where it is installed.
find_program(NACRE_RSVG_CONVERT rsvg-convert)
if(NACRE_RSVG_CONVERT)
    foreach(side 16 22 24 32 48 64 128 256)
        set(output ${CMAKE_CURRENT_BINARY_DIR}/icon-${side}.png)
        add_custom_command(OUTPUT ${output} DEPENDS nacre.svg VERBATIM COMMAND ${NACRE_RSVG_CONVERT}
            --width ${side} --height ${side} --output ${output} ${CMAKE_CURRENT_SOURCE_DIR}/nacre.svg)
        install(FILES ${output} DESTINATION ${icons}/${side}x${side}/apps RENAME nacre.png)
        list(APPEND compressed_files ${output})
    endforeach()
endif()
add_custom_target(nacre_package_files ALL DEPENDS ${compressed_files})
