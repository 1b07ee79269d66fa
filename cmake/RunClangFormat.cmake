# cmake -DPROGRAM=clang-format -DFILES=list.txt -DOPTIONS=a;b -P RunClangFormat.cmake: runs clang-format
# over the files that list.txt names, one a line, if it is the version that the project is formatted by.
set(wanted 16)
if(NOT PROGRAM)
    message(FATAL_ERROR "clang-format ${wanted} is missing: install Debian 12's clang-format-${wanted}, "
                        "or run pip install clang-format==16.0.6")
endif()
execute_process(COMMAND ${PROGRAM} --version OUTPUT_VARIABLE version COMMAND_ERROR_IS_FATAL ANY)
if(NOT version MATCHES "version ${wanted}\\.")
    message(FATAL_ERROR "the project is formatted by clang-format ${wanted}, and ${PROGRAM} is: "
                        "${version}")
endif()
execute_process(COMMAND ${PROGRAM} ${OPTIONS} --files=${FILES} COMMAND_ERROR_IS_FATAL ANY)
