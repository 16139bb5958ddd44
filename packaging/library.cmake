# nacre::core for other programs: find_package(nacre), or pkg-config nacre. It lies in a component of its own, which
# the Debian package of the programs leaves out.
include(CMakePackageConfigHelpers)
set(package_folder ${CMAKE_INSTALL_LIBDIR}/cmake/nacre)
set(header_sets "")
get_target_property(sets nacre_core INTERFACE_HEADER_SETS)
foreach(set IN LISTS sets)
    list(APPEND header_sets FILE_SET ${set} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/nacre)
endforeach()
install(TARGETS nacre_core EXPORT nacre-targets COMPONENT library ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR}
    ${header_sets})
install(EXPORT nacre-targets NAMESPACE nacre:: DESTINATION ${package_folder} COMPONENT library)
configure_file(nacre-config.cmake nacre-config.cmake COPYONLY)
# Before 1.0 a new minor version may change the headers.
write_basic_package_version_file(nacre-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES nacre-config.cmake ${CMAKE_CURRENT_BINARY_DIR}/nacre-config-version.cmake
    DESTINATION ${package_folder} COMPONENT library)

file(RELATIVE_PATH prefix_of_pc /prefix/${CMAKE_INSTALL_LIBDIR}/pkgconfig /prefix)
configure_file(nacre.pc.in nacre.pc @ONLY)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/nacre.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig COMPONENT library)

# The programs and the library both need it.
install(TARGETS nacre_pictures LIBRARY DESTINATION ${NACRE_PRIVATE_LIBRARY_FOLDER})
install(TARGETS nacre_pictures LIBRARY DESTINATION ${NACRE_PRIVATE_LIBRARY_FOLDER} COMPONENT library)
