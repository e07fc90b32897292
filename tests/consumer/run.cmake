# SPDX-License-Identifier: Apache-2.0
#
# Install Hawser to a fresh prefix, build the consumers against it, run them, and repeat what they
# recorded with the program.
set(work "${HAWSER_BINARY_DIR}/consumer")
file(REMOVE_RECURSE "${work}")

function(run)
    execute_process(COMMAND ${ARGV} COMMAND_ECHO STDOUT COMMAND_ERROR_IS_FATAL ANY)
endfunction()

run(${CMAKE_COMMAND} --install "${HAWSER_BINARY_DIR}" --component library
    --prefix "${work}/prefix")
run(${CMAKE_COMMAND} -S "${CONSUMER_SOURCE_DIR}" -B "${work}/build"
    -DCMAKE_BUILD_TYPE=Release "-DCMAKE_CXX_COMPILER=${CXX_COMPILER}"
    "-DCMAKE_PREFIX_PATH=${work}/prefix")
run(${CMAKE_COMMAND} --build "${work}/build")
run("${work}/build/consumer")
# The programs of docs/library.md, as a project of their own.
run(${CMAKE_COMMAND} -S "${EXAMPLES_SOURCE_DIR}" -B "${work}/examples"
    -DCMAKE_BUILD_TYPE=Release "-DCMAKE_CXX_COMPILER=${CXX_COMPILER}"
    "-DCMAKE_PREFIX_PATH=${work}/prefix")
run(${CMAKE_COMMAND} --build "${work}/examples")
foreach(name IN ITEMS first_body crane)
    run("${work}/examples/${name}")
endforeach()
run("${work}/build/session" "${SCENES_DIR}/anchor_lines.json" "${work}/run.hwr")
foreach(threads IN ITEMS 1 2)
    run("${HAWSER_BINARY_DIR}/bin/hawser" replay "${work}/run.hwr" --threads ${threads})
endforeach()
