# The Debian package that `cpack` makes of the programs.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME nacre)
set(CPACK_PACKAGE_VERSION ${PROJECT_VERSION})
set(CPACK_PACKAGE_CONTACT ${NACRE_MAINTAINER})
set(CPACK_PACKAGE_DIRECTORY ${PROJECT_BINARY_DIR}/package)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_INSTALL_CMAKE_PROJECTS "${PROJECT_BINARY_DIR};nacre;Unspecified;/")  # without the component `library`
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
    OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_RELEASE ${NACRE_DEBIAN_REVISION})
set(CPACK_DEBIAN_PACKAGE_SECTION graphics)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
# GLFW opens libGL by its name, where dpkg-shlibdeps does not see it.
set(CPACK_DEBIAN_PACKAGE_DEPENDS "libgl1")
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "libgl1-mesa-dri, zenity | kdialog")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "designer of the highlights of surfaces")
set(CPACK_PACKAGE_DESCRIPTION
"Nacre designs how a surface glints: the distribution of its microscopic facets
is shaped by handles, painted with brushes or taken from pictures, and a BRDF
that is reciprocal and conserves energy (Ashikhmin, Premoze and Shirley, 2000)
follows from it, previewed as one works.

The command line program nacre-cli bakes, checks, renders and exports designs
without a display.")
include(CPack)
