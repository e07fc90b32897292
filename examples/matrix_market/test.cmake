# SPDX-License-Identifier: Apache-2.0
#
# Install Hawser to a fresh prefix, build the example against it, solve two small systems.
set(work "${HAWSER_BINARY_DIR}/example_matrix_market")
file(REMOVE_RECURSE "${work}")

function(run)
    execute_process(COMMAND ${ARGV} COMMAND_ECHO STDOUT COMMAND_ERROR_IS_FATAL ANY)
endfunction()

run(${CMAKE_COMMAND} --install "${HAWSER_BINARY_DIR}" --component library
    --prefix "${work}/prefix")
run(${CMAKE_COMMAND} -S "${EXAMPLE_SOURCE_DIR}" -B "${work}/build"
    -DCMAKE_BUILD_TYPE=Release "-DCMAKE_CXX_COMPILER=${CXX_COMPILER}"
    "-DCMAKE_PREFIX_PATH=${work}/prefix")
run(${CMAKE_COMMAND} --build "${work}/build")

# check(ARGUMENTS... SOLUTION numbers...): what the program writes is this, to the last digit:
# small integers in, exact results out.
function(check)
    cmake_parse_arguments(PARSE_ARGV 0 arg "" "" "ARGUMENTS;SOLUTION")
    run("${work}/build/matrix_market" ${arg_ARGUMENTS} --solution "${work}/x")
    file(STRINGS "${work}/x" x)
    if(NOT x STREQUAL arg_SOLUTION)
        message(FATAL_ERROR "expected ${arg_SOLUTION}, got ${x}")
    endif()
endfunction()

# Two bodies of mass 1 and 2, a constraint on their sum: velocities 1 and -1, multiplier 2.
set(matrix "${EXAMPLE_SOURCE_DIR}/two_masses.mtx")
file(WRITE "${work}/blocks" "1 1\n1\n")
file(WRITE "${work}/rhs" "3\n0\n-2\n")
check(ARGUMENTS "${matrix}" --rhs "${work}/rhs" SOLUTION 1 -1 2)
check(ARGUMENTS "${matrix}" --rhs "${work}/rhs" --blocks "${work}/blocks" --threads 2
      SOLUTION 1 -1 2)

# A block of both signs is an error, and so is a missing file.
file(WRITE "${work}/wrong" "3\n")
foreach(arguments IN ITEMS "${matrix};--blocks;${work}/wrong" "${work}/none.mtx")
    execute_process(COMMAND "${work}/build/matrix_market" ${arguments} RESULT_VARIABLE code
                    ERROR_VARIABLE message)
    if(NOT code EQUAL 1 OR message STREQUAL "")
        message(FATAL_ERROR "'${arguments}' gave ${code} ${message}")
    endif()
endforeach()
