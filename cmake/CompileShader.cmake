# calotype_embed_kernels(TARGET SOURCE...)
#
# Compiles each GLSL compute shader to SPIR-V 1.5 for Vulkan 1.2, inlines and shortens it with
# spirv-opt (so Mesa's disk cache knows it again, which spares most of the time until the first
# sample), checks it with spirv-val, and makes it available to TARGET and what links it as
# `#include "kernels/NAME.spv.h"`, which defines `const uint32_t kNameSpirv[]` (path_trace.comp ->
# kPathTraceSpirv). What a shader includes is tracked by glslang's dependency file.
find_program(GLSLANG_VALIDATOR glslangValidator REQUIRED)
find_program(SPIRV_OPT spirv-opt REQUIRED)
find_program(SPIRV_VAL spirv-val REQUIRED)

function(calotype_embed_kernels target)
    set(output_dir ${CMAKE_CURRENT_BINARY_DIR}/${target}_spirv/kernels)
    file(MAKE_DIRECTORY ${output_dir})
    foreach(source ${ARGN})
        get_filename_component(source ${source} ABSOLUTE)
        get_filename_component(name ${source} NAME_WE)
        string(REPLACE "_" ";" words ${name})
        set(variable k)
        foreach(word ${words})
            string(SUBSTRING ${word} 0 1 first)
            string(SUBSTRING ${word} 1 -1 rest)
            string(TOUPPER ${first} first)
            string(APPEND variable ${first}${rest})
        endforeach()
        string(APPEND variable Spirv)
        set(module ${output_dir}/${name}.spv)
        set(header ${output_dir}/${name}.spv.h)
        add_custom_command(
            OUTPUT ${module} ${header} # the module first: the dependency file names it
            COMMAND ${GLSLANG_VALIDATOR} --quiet -V --target-env vulkan1.2 -g0
                    -I${PROJECT_SOURCE_DIR}/shaders -I${CMAKE_CURRENT_SOURCE_DIR}
                    --depfile ${module}.d -o ${module} ${source}
            COMMAND ${SPIRV_OPT} --target-env=vulkan1.2 -Os ${module} -o ${module}
            COMMAND ${SPIRV_VAL} --target-env vulkan1.2 ${module}
            COMMAND ${CMAKE_COMMAND} -DMODULE=${module} -DVARIABLE=${variable} -DHEADER=${header}
                    -P ${PROJECT_SOURCE_DIR}/cmake/EmbedSpirv.cmake
            DEPENDS ${source} ${PROJECT_SOURCE_DIR}/cmake/EmbedSpirv.cmake
            DEPFILE ${module}.d
            COMMENT "Compiling ${name}.comp"
            VERBATIM)
        target_sources(${target} PRIVATE ${header})
    endforeach()
    target_include_directories(${target} PUBLIC
        $<BUILD_INTERFACE:${CMAKE_CURRENT_BINARY_DIR}/${target}_spirv>)
endfunction()
