# Installs the build in BUILD into a scratch folder, and builds and runs a project that finds it there.
# usage: cmake -DBUILD=... -DSOURCE=... -DCXX=... -P run.cmake
function(run)
    execute_process(COMMAND ${ARGN} COMMAND_ERROR_IS_FATAL ANY)
endfunction()

set(scratch ${BUILD}/tests/install)
file(REMOVE_RECURSE ${scratch})
run(${CMAKE_COMMAND} --install ${BUILD} --prefix ${scratch}/prefix)
foreach(file bin/calotype share/calotype/scene.schema.json include/calotype/engine/renderer.h)
    if(NOT EXISTS ${scratch}/prefix/${file})
        message(FATAL_ERROR "${file} was not installed")
    endif()
endforeach()
run(${CMAKE_COMMAND} -S ${SOURCE}/tests/install -B ${scratch}/user -G Ninja
    -DCMAKE_PREFIX_PATH=${scratch}/prefix -DCMAKE_CXX_COMPILER=${CXX}
    -DEXAMPLE=${SOURCE}/examples/render_scene.cpp)
run(${CMAKE_COMMAND} --build ${scratch}/user)
run(${scratch}/user/render_scene ${SOURCE}/scenes/triangle.json)
run(${scratch}/prefix/bin/calotype --version)
