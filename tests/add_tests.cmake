# add_google_tests(FOLDER PROGRAM PROJECT BY), read by ctest: one CTest for each suite (BY suites), or
# for each test with all its parameters (BY cases), of a GoogleTest program. The cases of one CTest
# share a process, and so the start of the device and of the validation layers, which takes as long
# as most of them.
#
# Suites and cases named Slow... take long and have the label slow, which ./bootstrap test leaves
# out; those named Timed... run alone.

# add_google_test(NAME CASES LABEL IS_ALONE LAYERS PROGRAM PROJECT)
function(add_google_test name cases label is_alone layers program project)
    list(JOIN cases ":" filter)
    set(timeout 1800) # under sanitizers, the longest takes minutes
    if("${label}" STREQUAL "slow")
        set(timeout 36000)
    endif()
    add_test(${name} ${program} --gtest_filter=${filter})
    set_tests_properties(${name} PROPERTIES LABELS ${label} TIMEOUT ${timeout}
        WORKING_DIRECTORY ${project} RUN_SERIAL ${is_alone}
        ENVIRONMENT CALOTYPE_VALIDATION=${layers}
        FAIL_REGULAR_EXPRESSION "] 0 tests from 0 test suites ran")
endfunction()

function(add_google_tests folder program project by)
    execute_process(COMMAND ${program} --gtest_list_tests WORKING_DIRECTORY ${project}
                    OUTPUT_VARIABLE list RESULT_VARIABLE status)
    if(NOT status EQUAL 0)
        add_test(${folder}.NOT_BUILT ${program} --gtest_list_tests)
        return()
    endif()
    string(REGEX REPLACE " +#[^\n]*" "" list "${list}") # values of parameters
    string(REPLACE "\n" ";" lines "${list}")
    set(groups)
    foreach(line IN LISTS lines)
        if(line MATCHES "^([^ ]+)\\.$")
            set(suite ${CMAKE_MATCH_1})
        elseif(line MATCHES "^  ([^/]+)(/.*)?$")
            set(test ${CMAKE_MATCH_1})
            set(instance "${CMAKE_MATCH_2}")
            set(group ${suite})
            if("${by}" STREQUAL "cases")
                set(group ${suite}.${test})
            endif()
            foreach(kind Slow Timed)
                if(test MATCHES ${kind} AND NOT group MATCHES ${kind})
                    string(APPEND group ".${kind}")
                endif()
            endforeach()
            list(APPEND groups ${group})
            list(APPEND cases_of_${group} "${suite}.${test}${instance}")
        endif()
    endforeach()
    list(REMOVE_DUPLICATES groups)
    # The validation layers take as long as a small render. What cli and extremes do on the device,
    # gpu and image do with the layers: so these two run without them, but for ValidationLayersTest,
    # and once more with them under the label slow.
    set(layers 1)
    if("${folder}" MATCHES "^(cli|extremes)$")
        set(layers 0)
    endif()
    foreach(group IN LISTS groups)
        set(is_alone FALSE)
        if(group MATCHES Timed)
            set(is_alone TRUE)
        endif()
        if(group MATCHES Slow)
            add_google_test(${folder}.${group} "${cases_of_${group}}" slow ${is_alone} 1 ${program}
                            ${project})
            continue()
        endif()
        add_google_test(${folder}.${group} "${cases_of_${group}}" ${folder} ${is_alone} ${layers}
                        ${program} ${project})
        if(NOT layers)
            add_google_test(validated.${folder}.${group} "${cases_of_${group}}" slow TRUE 1
                            ${program} ${project})
        endif()
    endforeach()
endfunction()
