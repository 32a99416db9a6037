# Writes commit.h with the commit being built ("unknown" without git), touching the file only when it changes.
# Called at build time with SOURCE_DIR and OUTPUT.
cmake_minimum_required(VERSION 3.25)
execute_process(COMMAND git -C ${SOURCE_DIR} describe --always --dirty --abbrev=12
    OUTPUT_VARIABLE commit OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET RESULT_VARIABLE failure)
if(failure OR NOT EXISTS ${SOURCE_DIR}/.git OR commit STREQUAL "")
    set(commit unknown)
endif()
file(CONFIGURE OUTPUT ${OUTPUT} CONTENT "// Made by cmake/commit.cmake.
#pragma once
namespace nephrite { inline constexpr const char* commit = \"@commit@\"; }
" @ONLY)
