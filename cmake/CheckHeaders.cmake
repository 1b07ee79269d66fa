# calotype_check_headers(LIBRARY...)
#
# Adds the target check_headers, which is not part of `all`. It compiles alone every C++ header of host/,
# of tests/ and of what shaders/ shares with them, with what the LIBRARYs are compiled with, and every
# file of the shader library. A file that depends on what another one happens to include fails there.
# Tables (*_table.h) are left out: they need the macros of the file that includes them.
function(calotype_check_headers)
    set(folder ${CMAKE_CURRENT_BINARY_DIR}/check_headers)

    file(GLOB_RECURSE headers CONFIGURE_DEPENDS RELATIVE ${PROJECT_SOURCE_DIR}
         ${PROJECT_SOURCE_DIR}/host/*.h ${PROJECT_SOURCE_DIR}/shaders/shared/*.h
         ${PROJECT_SOURCE_DIR}/shaders/kernels/*.h ${PROJECT_SOURCE_DIR}/tests/*.h)
    # Beside the tables: the fuzzers are compiled by Clang, and the last one includes a compiled kernel.
    list(FILTER headers EXCLUDE REGEX "_table\\.h$|/tests/fuzz/|/coordinates_at\\.h$")
    set(sources)
    foreach(header ${headers})
        string(REGEX REPLACE "^(host|shaders|tests)/" "" name ${header})
        set(source ${folder}/${name}.cpp)
        file(CONFIGURE OUTPUT ${source} CONTENT "#include \"${name}\"\n")
        list(APPEND sources ${source})
    endforeach()
    add_library(check_cpp_headers OBJECT EXCLUDE_FROM_ALL ${sources})
    target_include_directories(check_cpp_headers SYSTEM PRIVATE ${STB_INCLUDE_DIR}
                                                                ${TINYOBJ_INCLUDE_DIR})
    target_include_directories(check_cpp_headers PRIVATE ${PROJECT_SOURCE_DIR}/tests)
    target_link_libraries(check_cpp_headers PRIVATE ${ARGN})
    # What a header defines for its users is not used here.
    target_compile_options(check_cpp_headers PRIVATE -O0 -Wno-unused)

    file(GLOB_RECURSE shaders CONFIGURE_DEPENDS RELATIVE ${PROJECT_SOURCE_DIR}/shaders
         ${PROJECT_SOURCE_DIR}/shaders/*.glsl)
    set(modules)
    foreach(shader ${shaders})
        set(source ${folder}/${shader}.comp)
        set(module ${source}.spv)
        file(CONFIGURE OUTPUT ${source} CONTENT "#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_KHR_shader_subgroup_arithmetic : require
#extension GL_KHR_shader_subgroup_ballot : require
#include \"${shader}\"
void main() {}
")
        add_custom_command(
            OUTPUT ${module}
            COMMAND ${GLSLANG_VALIDATOR} --quiet -V --target-env vulkan1.2
                    -I${PROJECT_SOURCE_DIR}/shaders --depfile ${module}.d -o ${module} ${source}
            DEPENDS ${source}
            DEPFILE ${module}.d
            COMMENT "Compiling shaders/${shader} alone"
            VERBATIM)
        list(APPEND modules ${module})
    endforeach()
    add_custom_target(check_shaders DEPENDS ${modules})

    add_custom_target(check_headers)
    add_dependencies(check_headers check_cpp_headers check_shaders)
endfunction()
