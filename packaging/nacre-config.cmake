# find_package(nacre): the target nacre::core.
include(CMakeFindDependencyMacro)
find_dependency(fmt)
find_dependency(glm)
find_dependency(hwy)
find_dependency(TBB)
find_dependency(Threads)
find_dependency(ZLIB)
include(${CMAKE_CURRENT_LIST_DIR}/nacre-targets.cmake)
