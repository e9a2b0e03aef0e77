# The libraries we stand on, as Debian 12 names them. Each is linked by the one target that is its door.

find_package(PkgConfig REQUIRED)
find_package(embree 3 REQUIRED)
find_package(glm REQUIRED)
find_package(glfw3 REQUIRED)
find_package(TBB REQUIRED)
find_package(fmt REQUIRED)
find_package(Eigen3 REQUIRED)
find_package(Boost REQUIRED)
find_package(CLI11 REQUIRED)
find_package(tomlplusplus REQUIRED)
find_package(nlohmann_json REQUIRED)
find_package(tl-expected REQUIRED)
find_package(tinyobjloader REQUIRED)
find_package(OpenMesh REQUIRED)
find_package(SQLite3 REQUIRED)
find_package(OpenSSL REQUIRED COMPONENTS Crypto)
pkg_check_modules(epoxy REQUIRED IMPORTED_TARGET epoxy)
pkg_check_modules(imgui REQUIRED IMPORTED_TARGET imgui)

find_package(OpenImageIO REQUIRED)
# Debian's OpenImageIO names an OpenCV include folder that its own packages do not install, and CMake
# refuses a target with a folder that is not there.
get_target_property(oiio_includes OpenImageIO::OpenImageIO INTERFACE_INCLUDE_DIRECTORIES)
list(FILTER oiio_includes EXCLUDE REGEX opencv)
set_target_properties(OpenImageIO::OpenImageIO PROPERTIES INTERFACE_INCLUDE_DIRECTORIES "${oiio_includes}")
