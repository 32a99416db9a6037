# A room is a folder of framework/ (or of FOLDER) built as one static library that links only the rooms below it.

add_library(nephrite_flags INTERFACE)
target_compile_options(nephrite_flags INTERFACE -Wall -Wextra -Wpedantic -Wconversion -Wno-sign-conversion -Wshadow -Wnon-virtual-dtor)
# GCC 12 claims, when it optimises, that strings moved into an exception may be uninitialised and that "a" + string may
# overlap itself (GCC bugs 105562 and 105651). Neither is true.
target_compile_options(nephrite_flags INTERFACE $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized -Wno-restrict>)
# std::fma contraction would make the double-precision references differ between compilers.
target_compile_options(nephrite_flags INTERFACE -ffp-contract=off)
if(NEPHRITE_WARNINGS_AS_ERRORS)
    target_compile_options(nephrite_flags INTERFACE -Werror)
endif()
if(NEPHRITE_SANITIZERS)
    # The distribution's glslang has no run-time type information, which the vptr check needs.
    add_compile_options(-fsanitize=${NEPHRITE_SANITIZERS} -fno-sanitize=vptr -fno-omit-frame-pointer -fno-sanitize-recover=all)
    add_link_options(-fsanitize=${NEPHRITE_SANITIZERS})
endif()

function(nephrite_room name)
    cmake_parse_arguments(ARG "" "FOLDER" "ROOMS;PACKAGES" ${ARGN})
    if(NOT ARG_FOLDER)
        set(ARG_FOLDER framework)
    endif()
    file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/${ARG_FOLDER}/${name}/*.cpp)
    add_library(nephrite_${name} STATIC ${sources})
    set_target_properties(nephrite_${name} PROPERTIES LINKER_LANGUAGE CXX)
    target_include_directories(nephrite_${name} PUBLIC ${PROJECT_SOURCE_DIR}/${ARG_FOLDER})
    list(TRANSFORM ARG_ROOMS PREPEND nephrite_)
    target_link_libraries(nephrite_${name} PUBLIC ${ARG_ROOMS} ${ARG_PACKAGES} fmt::fmt PRIVATE nephrite_flags)
endfunction()

# Builds framework/NAME/page/ (page.html, page.css and the scripts, in this order) into the room as one text.
function(nephrite_page name)
    cmake_parse_arguments(ARG "" "" "SCRIPTS" ${ARGN})
    set(folder ${PROJECT_SOURCE_DIR}/framework/${name}/page)
    set(output ${CMAKE_CURRENT_BINARY_DIR}/${name}_page_template.cpp)
    list(TRANSFORM ARG_SCRIPTS PREPEND ${folder}/ OUTPUT_VARIABLE scripts)
    add_custom_command(OUTPUT ${output}
        COMMAND ${CMAKE_COMMAND} -DFOLDER=${folder} "-DSCRIPTS=${ARG_SCRIPTS}" -DOUTPUT=${output} -P ${PROJECT_SOURCE_DIR}/cmake/page.cmake
        DEPENDS ${folder}/page.html ${folder}/page.css ${scripts} ${PROJECT_SOURCE_DIR}/cmake/page.cmake VERBATIM)
    target_sources(nephrite_${name} PRIVATE ${output})
endfunction()
