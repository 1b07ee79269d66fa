# cmake -DFOLDER=build -P cmake/FetchDenoiser.cmake
#
# Puts Open Image Denoise 2.5.1 (Apache-2.0) into FOLDER/oidn/lib, where the program in FOLDER finds
# it: the four libraries that denoising on a CPU needs, from the wheel of the Python package pyoidn
# on PyPI. A wheel with another hash is refused. Does nothing if they are there.
set(url https://files.pythonhosted.org/packages/80/f7/40c72360d5ee831ad1048427202b4c7bca41b28c7caffea0df4d2dc8158e/pyoidn-2.5.1.0-py3-none-manylinux2014_x86_64.whl)
set(hash 32ad13368f8de1ef63001942ad05b02a00cd732d1206d97f352d3a3f606d823e)
set(libraries libOpenImageDenoise.so.2 libOpenImageDenoise_core.so.2.5.1
              libOpenImageDenoise_device_cpu.so.2.5.1 libtbb.so.12)

set(lib ${FOLDER}/oidn/lib)
set(areThere TRUE)
foreach(library ${libraries})
    if(NOT EXISTS ${lib}/${library})
        set(areThere FALSE)
    endif()
endforeach()
if(areThere)
    return()
endif()

set(wheel ${FOLDER}/oidn/wheel)
cmake_host_system_information(RESULT machine QUERY OS_PLATFORM)
if(NOT machine STREQUAL "x86_64")
    message(FATAL_ERROR "Open Image Denoise can be downloaded for x86-64 only")
endif()
file(MAKE_DIRECTORY ${wheel})
message("Downloading Open Image Denoise (88 MB)")
file(DOWNLOAD ${url} ${wheel}/pyoidn.zip STATUS status TLS_VERIFY ON INACTIVITY_TIMEOUT 30
     TIMEOUT 600)
list(GET status 0 code)
list(GET status 1 problem)
file(SHA256 ${wheel}/pyoidn.zip found)
if(code EQUAL 0 AND NOT found STREQUAL hash)
    set(code 1)
    set(problem "its hash is ${found}")
endif()
if(NOT code EQUAL 0)
    file(REMOVE_RECURSE ${wheel})
    message(FATAL_ERROR "Open Image Denoise could not be downloaded: ${problem}")
endif()
file(ARCHIVE_EXTRACT INPUT ${wheel}/pyoidn.zip DESTINATION ${wheel}
     PATTERNS "pyoidn/oidn/lib/lib*" "pyoidn-*/licenses/*")
foreach(library ${libraries})
    file(COPY ${wheel}/pyoidn/oidn/lib/${library} DESTINATION ${lib})
endforeach()
file(GLOB licences ${wheel}/pyoidn-*/licenses/*)
file(COPY ${licences} DESTINATION ${FOLDER}/oidn)
file(REMOVE_RECURSE ${wheel})
