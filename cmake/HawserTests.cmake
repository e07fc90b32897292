# SPDX-License-Identifier: Apache-2.0
#
# One test executable per folder tests/<name>: hawser_test_<name>; its tests are called
# <name>.Suite.case (`ctest -R '^factor\.'`). Files directly in tests/ make hawser_test. Shared
# helpers are headers (and sources) in tests/support.
# Tests run in the source folder: "scenes/x.json" opens. The environment names HAWSER_BIN_DIR,
# the folder of the programs.

find_package(GTest REQUIRED)
find_package(rapidcheck QUIET)
find_package(fmt QUIET)
find_package(nlohmann_json QUIET)
find_package(PNG QUIET)
find_package(Python3 COMPONENTS Interpreter REQUIRED)
include(GoogleTest)

# Labels. `slow`: takes long. `program`: belongs to the programs. `fast` and `threads`: the rest,
# without and with several threads in the code under test. The preset asan-ubsan builds and runs
# both but for tests that take long to compile or to run: those of `assembly` and of steps, whose
# kernels run in the tests of `world`, `wire` and `machine` as well, of the sea, of cranes, and of
# the rooms that record, verify, report, draw, export and exercise; `make test-sanitized` runs them,
# too. tsan runs those labelled `threads`. The targets hawser_fast_tests and hawser_thread_tests
# build them.
set(HAWSER_SLOW_TESTS slow validate)
set(HAWSER_PROGRAM_TESTS bench cli)
set(HAWSER_THREAD_TESTS runtime threads)
set(HAWSER_UNSANITIZED_TESTS assembly crane draw exercise export headers marine record repair report
                             stepper systems verify)
# Tests that need more than the library.
set(HAWSER_REPORT_TESTS cli draw exercise export files live marine record report session verify)
set(HAWSER_SCENE_TESTS bench cli draw exercise export files live record report scene scenes session
                       slow stepper threads validate verify world)
# Tests that take seconds, each with its folder: they start first, so that all processors end
# together on a machine that has not run them before.
set(HAWSER_LONG_TESTS validate:Validate.wires validate:Validate.robust_wires
    validate:Validate.winches machine:MemoryEnds.* record:WireCutRandom.* slow:AnchorLinesMinute.*
    factor:InstructionSets.* bench:Hashes.* files:Forged* wire:CatenaryRandom.*
    wire:WireResolution.* stepper:Forms.* stepper:JointDamping.* scene:Mistakes.*
    world:WireNodes.* threads:Threads.*)
# Suites whose tests share what the first of them takes seconds to make: each is one test.
set(HAWSER_JOINED_SUITES cli:Figures)
add_custom_target(hawser_fast_tests)
add_custom_target(hawser_thread_tests)

hawser_sources(support_sources tests/support)
if(support_sources)
    add_library(hawser_test_support STATIC ${support_sources})
    hawser_use(hawser_test_support)
    hawser_unity(hawser_test_support 16)
    target_compile_options(hawser_test_support PRIVATE $<$<CONFIG:Release>:-O1 -g0>)
    target_include_directories(hawser_test_support PRIVATE ${PROJECT_SOURCE_DIR}/tests)
    target_link_libraries(hawser_test_support PUBLIC GTest::gtest)
endif()

# Options of sources of tests; what they test keeps its own optimisation.
function(hawser_test_settings target)
    target_compile_options(${target} PRIVATE
        $<$<CONFIG:Release>:-O1 -g0> $<$<CONFIG:Sanitize>:-O0>)
    target_include_directories(${target} PRIVATE ${PROJECT_SOURCE_DIR}/tests)
    foreach(library IN ITEMS rapidcheck fmt::fmt PNG::PNG nlohmann_json::nlohmann_json)
        if(TARGET ${library})
            target_link_libraries(${target} PRIVATE ${library})
        endif()
    endforeach()
    target_link_libraries(${target} PRIVATE AMD::AMD GTest::gtest)
endfunction()

# The executables share one set of precompiled headers. The preset tsan builds too few of them.
if(HAWSER_UNITY AND NOT HAWSER_SANITIZE STREQUAL "thread")
    file(CONFIGURE OUTPUT test_headers.cpp CONTENT "")
    add_library(hawser_test_headers OBJECT "${CMAKE_CURRENT_BINARY_DIR}/test_headers.cpp")
    hawser_use(hawser_test_headers)
    hawser_test_settings(hawser_test_headers)
    target_compile_options(hawser_test_headers PRIVATE -fPIE)  # as executables have it
    hawser_precompile(hawser_test_headers <Eigen/Dense> <gtest/gtest.h> <hawser/hawser.h>
        <algorithm> <cmath> <filesystem> <fstream> <map> <set> <string>
        $<$<TARGET_EXISTS:nlohmann_json::nlohmann_json>:<nlohmann/json.hpp$<ANGLE-R>>)
endif()

function(hawser_add_test_executable target folder)
    add_executable(${target} ${ARGN})
    set(libraries "")
    if(folder IN_LIST HAWSER_REPORT_TESTS)
        list(APPEND libraries hawser_report)
    endif()
    if(folder IN_LIST HAWSER_SCENE_TESTS)
        list(APPEND libraries hawser_scene)
    endif()
    if(folder STREQUAL live)
        list(PREPEND libraries hawser_live)
    endif()
    hawser_use(${target} ${libraries})
    if(folder STREQUAL scene)  # tests write files of these formats
        foreach(format IN ITEMS NETCDF HDF5)
            if(HAWSER_${format})
                target_link_libraries(${target} PRIVATE PkgConfig::${format})
                target_compile_definitions(${target} PRIVATE HAWSER_HAVE_${format}=1)
            endif()
        endforeach()
    endif()
    hawser_unity(${target} 6)
    hawser_test_settings(${target})
    if(TARGET hawser_test_support)
        target_link_libraries(${target} PRIVATE hawser_test_support)
    endif()
    target_link_libraries(${target} PRIVATE GTest::gtest_main)
    if(TARGET hawser_test_headers)
        target_precompile_headers(${target} REUSE_FROM hawser_test_headers)
    endif()

    if(folder IN_LIST HAWSER_SLOW_TESTS)
        set(label slow)
    elseif(folder IN_LIST HAWSER_PROGRAM_TESTS)
        set(label program)
    else()
        set(label fast)
        if(NOT folder IN_LIST HAWSER_UNSANITIZED_TESTS)
            add_dependencies(hawser_fast_tests ${target})
        endif()
        if(folder IN_LIST HAWSER_THREAD_TESTS)
            set(label threads)
            add_dependencies(hawser_thread_tests ${target})
        endif()
    endif()
    set(properties LABELS ${label} TIMEOUT 600
        ENVIRONMENT "HAWSER_BIN_DIR=${PROJECT_BINARY_DIR}/bin")
    # PRE_TEST: a test that fails to start must fail in ctest, not break the build.
    set(discovery TEST_PREFIX ${folder}. DISCOVERY_MODE PRE_TEST DISCOVERY_TIMEOUT 60
        WORKING_DIRECTORY "${PROJECT_SOURCE_DIR}")
    set(others "")
    foreach(suite IN LISTS HAWSER_JOINED_SUITES)
        if(suite MATCHES "^${folder}:(.*)$")
            set(name "${folder}.${CMAKE_MATCH_1}")
            add_test(NAME ${name} COMMAND ${target} --gtest_filter=${CMAKE_MATCH_1}.*
                WORKING_DIRECTORY "${PROJECT_SOURCE_DIR}")
            set_tests_properties(${name} PROPERTIES ${properties} COST 10)
            list(APPEND others "${CMAKE_MATCH_1}.*")
        endif()
    endforeach()
    set(long ${HAWSER_LONG_TESTS})
    list(FILTER long INCLUDE REGEX "^${folder}:")
    list(TRANSFORM long REPLACE "^${folder}:" "")
    list(JOIN long ":" long)
    if(long)
        gtest_discover_tests(${target} ${discovery} TEST_FILTER "${long}"
            TEST_LIST ${target}_LONG_TESTS PROPERTIES ${properties} COST 10)
        list(APPEND others "${long}")
    endif()
    if(others)
        list(JOIN others ":" others)
        list(APPEND discovery TEST_FILTER "-${others}")
    endif()
    gtest_discover_tests(${target} ${discovery} PROPERTIES ${properties})
endfunction()

file(GLOB top_tests CONFIGURE_DEPENDS "${PROJECT_SOURCE_DIR}/tests/*.cpp")
if(top_tests)
    hawser_add_test_executable(hawser_test top ${top_tests})
endif()

file(GLOB folders CONFIGURE_DEPENDS LIST_DIRECTORIES TRUE RELATIVE "${PROJECT_SOURCE_DIR}/tests"
     "${PROJECT_SOURCE_DIR}/tests/*")
list(REMOVE_ITEM folders support consumer)
foreach(folder IN LISTS folders)
    if(IS_DIRECTORY "${PROJECT_SOURCE_DIR}/tests/${folder}")
        hawser_sources(sources tests/${folder})
        if(sources)
            hawser_add_test_executable(hawser_test_${folder} ${folder} ${sources})
        endif()
    endif()
endforeach()

# Lanes once more with the instructions that every machine has: vectors there end where they are not
# asked to.
if(TARGET hawser_test_stepper AND NOT HAWSER_SANITIZE STREQUAL "thread")
    set(lanes *Link*:*Forms*)
    if(HAWSER_SANITIZE)
        string(APPEND lanes :-JointDamping.*)  # half of the time, of the same code
    endif()
    add_test(NAME stepper.lanes_sse2
        COMMAND hawser_test_stepper --gtest_filter=${lanes} --gtest_brief=1
        WORKING_DIRECTORY "${PROJECT_SOURCE_DIR}")
    set_tests_properties(stepper.lanes_sse2 PROPERTIES LABELS fast TIMEOUT 600 COST 10
        ENVIRONMENT "HAWSER_ISA=sse2")
endif()

if(TARGET hawser_test_bench)
    target_sources(hawser_test_bench PRIVATE
        $<TARGET_OBJECTS:hawser_bench_own> "${PROJECT_SOURCE_DIR}/bench/linear/scalar.cpp")
    target_include_directories(hawser_test_bench PRIVATE
        ${PROJECT_SOURCE_DIR}/bench ${PROJECT_SOURCE_DIR}/examples)
endif()

# ---- checks of the build itself ----------------------------------------------------------------
if(NOT HAWSER_SANITIZE)
    foreach(isa IN ITEMS avx2 avx512)
        if(TARGET hawser_isa_${isa})
            add_test(NAME isa_symbols.${isa}
                COMMAND Python3::Interpreter "${PROJECT_SOURCE_DIR}/scripts/check_isa_symbols.py"
                        ${isa} $<FILTER:$<TARGET_OBJECTS:hawser_isa_${isa}>,EXCLUDE,[.][gp]ch$>
                COMMAND_EXPAND_LISTS)
            set_tests_properties(isa_symbols.${isa} PROPERTIES LABELS build)
        endif()
    endforeach()

    add_test(NAME scripts
        COMMAND Python3::Interpreter "${PROJECT_SOURCE_DIR}/tests/scripts/test_scripts.py")
    set_tests_properties(scripts PROPERTIES LABELS build)

    if(HAWSER_CCACHE AND HAWSER_UNITY AND CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
        add_test(NAME compiler_cache
            COMMAND Python3::Interpreter "${PROJECT_SOURCE_DIR}/tests/scripts/test_cache.py"
                    ${CMAKE_CXX_COMPILER_LAUNCHER} ${CMAKE_CXX_COMPILER})
        set_tests_properties(compiler_cache PROPERTIES LABELS build)
    endif()

    add_test(NAME consumer
        COMMAND ${CMAKE_COMMAND}
            -DHAWSER_BINARY_DIR=${PROJECT_BINARY_DIR}
            -DCONSUMER_SOURCE_DIR=${PROJECT_SOURCE_DIR}/tests/consumer
            -DEXAMPLES_SOURCE_DIR=${PROJECT_SOURCE_DIR}/examples/library
            -DSCENES_DIR=${PROJECT_SOURCE_DIR}/scenes
            -DCXX_COMPILER=${CMAKE_CXX_COMPILER}
            -P "${PROJECT_SOURCE_DIR}/tests/consumer/run.cmake")
    set_tests_properties(consumer PROPERTIES LABELS build TIMEOUT 600 COST 10)

    add_test(NAME example_matrix_market
        COMMAND ${CMAKE_COMMAND}
            -DHAWSER_BINARY_DIR=${PROJECT_BINARY_DIR}
            -DEXAMPLE_SOURCE_DIR=${PROJECT_SOURCE_DIR}/examples/matrix_market
            -DCXX_COMPILER=${CMAKE_CXX_COMPILER}
            -P "${PROJECT_SOURCE_DIR}/examples/matrix_market/test.cmake")
    set_tests_properties(example_matrix_market PROPERTIES LABELS build TIMEOUT 600 COST 10)
endif()
