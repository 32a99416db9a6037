# Every package comes from the distribution; nothing is vendored or downloaded.

find_package(PkgConfig REQUIRED)
find_package(Threads REQUIRED)
find_package(fmt REQUIRED)
find_package(OpenEXR REQUIRED)
find_package(PNG REQUIRED)
find_package(Vulkan REQUIRED)
find_package(assimp REQUIRED)

pkg_check_modules(jsoncpp REQUIRED IMPORTED_TARGET jsoncpp)
add_library(JsonCpp::JsonCpp ALIAS PkgConfig::jsoncpp)
pkg_check_modules(gvc REQUIRED IMPORTED_TARGET libgvc libcgraph)
add_library(Graphviz::gvc ALIAS PkgConfig::gvc)
pkg_check_modules(spirv-cross REQUIRED IMPORTED_TARGET spirv-cross-c-shared)
add_library(SpirvCross::c ALIAS PkgConfig::spirv-cross)
find_package(glm REQUIRED)

# Debian's package installs its target without a namespace.
find_package(embree 3 REQUIRED)
add_library(Embree::embree ALIAS embree)

# glslang's package configuration names SPIRV-Tools targets without finding them itself.
find_package(SPIRV-Tools REQUIRED)
find_package(SPIRV-Tools-opt REQUIRED)
find_package(SPIRV-Tools-link REQUIRED)
find_package(glslang REQUIRED)

# Windows. ImGui's package has no CMake configuration.
find_package(glfw3 REQUIRED)
pkg_check_modules(imgui REQUIRED IMPORTED_TARGET imgui)
add_library(ImGui::imgui ALIAS PkgConfig::imgui)
