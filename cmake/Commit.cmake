# Gives host/engine/version.cpp the commit that is built; an empty text outside a git checkout. CMake
# runs again after each commit.
function(calotype_commit source)
    execute_process(COMMAND git rev-parse --short=7 HEAD WORKING_DIRECTORY ${PROJECT_SOURCE_DIR}
                    OUTPUT_VARIABLE commit OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
    execute_process(COMMAND git rev-parse --git-path logs/HEAD WORKING_DIRECTORY ${PROJECT_SOURCE_DIR}
                    OUTPUT_VARIABLE log OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
    if(log)
        cmake_path(ABSOLUTE_PATH log BASE_DIRECTORY ${PROJECT_SOURCE_DIR})
        if(EXISTS ${log})
            set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${log})
        endif()
    endif()
    # Alone, so that a commit compiles only this file again.
    set_source_files_properties(${source} PROPERTIES
        COMPILE_DEFINITIONS "CALOTYPE_COMMIT=\"${commit}\"" SKIP_UNITY_BUILD_INCLUSION ON)
endfunction()
