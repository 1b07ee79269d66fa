# Adds the targets check_format, which fails where clang-format would change a source, and format, which
# changes it. Versions of clang-format differ in what they do, so it has to be version 16: Debian 12's
# package clang-format-16, or anywhere `pip install clang-format==16.0.6`.
find_program(CLANG_FORMAT NAMES clang-format-16 clang-format)
file(GLOB_RECURSE FORMATTED_SOURCES CONFIGURE_DEPENDS
     host/*.h host/*.cpp shaders/*.h shaders/*.glsl shaders/*.comp examples/*.cpp
     tests/*.h tests/*.cpp tests/*.glsl tests/*.comp)
list(FILTER FORMATTED_SOURCES EXCLUDE REGEX "/tests/fuzz/corpus/")
set(FORMATTED_LIST ${CMAKE_CURRENT_BINARY_DIR}/formatted_sources.txt)
list(JOIN FORMATTED_SOURCES "\n" FORMATTED_LINES)
file(CONFIGURE OUTPUT ${FORMATTED_LIST} CONTENT "${FORMATTED_LINES}\n")

# calotype_format_target(NAME OPTION...)
function(calotype_format_target name)
    add_custom_target(${name}
        COMMAND ${CMAKE_COMMAND} -DPROGRAM=${CLANG_FORMAT} -DFILES=${FORMATTED_LIST}
                "-DOPTIONS=${ARGN}" -P ${PROJECT_SOURCE_DIR}/cmake/RunClangFormat.cmake
        WORKING_DIRECTORY ${PROJECT_SOURCE_DIR}
        VERBATIM)
endfunction()
calotype_format_target(check_format --dry-run -Werror)
calotype_format_target(format -i)
