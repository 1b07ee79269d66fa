# calotype_unity(TARGET)
#
# With CALOTYPE_UNITY, the sources of each folder of host/ are compiled as one file, which takes less than
# half of the time from nothing. So the names in anonymous namespaces must differ within a folder.
function(calotype_unity target)
    if(NOT CALOTYPE_UNITY)
        return()
    endif()
    set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
    get_target_property(sources ${target} SOURCES)
    foreach(source ${sources})
        if(NOT source MATCHES "/stb_image" AND source MATCHES "/host/(.+)/[^/]+\\.cpp$")
            string(REPLACE "/" "_" group ${CMAKE_MATCH_1})
            set_source_files_properties(${source} PROPERTIES UNITY_GROUP ${group})
        endif()
    endforeach()
endfunction()
