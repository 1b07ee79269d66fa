# calotype_public_headers(TARGET HEADER...)
#
# Copies each HEADER of host/, and all that they include of it, to ${CMAKE_BINARY_DIR}/include/calotype,
# from where users and `cmake --install` take them. There, `#include "scene/scene.h"` reads
# `#include <calotype/scene/scene.h>`, so that nothing of ours is found by a short name.
function(calotype_public_headers target)
    set(pending ${ARGN})
    set(copied)
    while(pending)
        list(POP_FRONT pending header)
        if(header IN_LIST copied)
            continue()
        endif()
        list(APPEND copied ${header})
        set(source ${PROJECT_SOURCE_DIR}/host/${header})
        set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${source})
        file(READ ${source} text)
        string(REGEX MATCHALL "#include \"[a-z0-9_/]+\\.h\"" includes "${text}")
        foreach(include ${includes})
            string(REGEX REPLACE "#include \"(.*)\"" "\\1" include "${include}")
            list(APPEND pending ${include})
        endforeach()
        string(REGEX REPLACE "#include \"([a-z0-9_/]+\\.h)\"" "#include <calotype/\\1>" text
               "${text}")
        file(CONFIGURE OUTPUT ${CMAKE_BINARY_DIR}/include/calotype/${header} CONTENT "${text}"
             @ONLY)
    endwhile()
    # What is public no more, from an earlier run.
    file(GLOB_RECURSE existing RELATIVE ${CMAKE_BINARY_DIR}/include/calotype
         ${CMAKE_BINARY_DIR}/include/calotype/*.h)
    list(REMOVE_ITEM existing ${copied})
    foreach(header ${existing})
        file(REMOVE ${CMAKE_BINARY_DIR}/include/calotype/${header})
    endforeach()
    target_include_directories(${target} PUBLIC $<BUILD_INTERFACE:${CMAKE_BINARY_DIR}/include>
                                                $<INSTALL_INTERFACE:include>)
endfunction()
