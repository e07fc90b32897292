# SPDX-License-Identifier: Apache-2.0
#
# One test executable per folder tests/<name>: hawser_test_<name>. Shared helpers are in
# tests/support.
#
# Tiers: quick, full and long; each includes the smaller ones. A test is quick unless its name ends
# in _full or _long (tests/support/tier.h). ctest starts a process for each of two shards of an
# executable, not for each test:
#   <name>.quick.1, <name>.quick.2   label quick
#   <name>.full.1, <name>.full.2     label full, if the folder has such tests
#   <name>.long                      label long, likewise
# Tests run in the source folder, so "scenes/x.json" opens. The environment variable HAWSER_BIN_DIR
# names the folder of the programs.

find_package(GTest REQUIRED)
find_package(rapidcheck QUIET)
find_package(fmt QUIET)
find_package(nlohmann_json QUIET)
find_package(PNG QUIET)
find_package(Python3 COMPONENTS Interpreter REQUIRED)

# Tests that need more than the library.
set(HAWSER_REPORT_TESTS cli docs draw exercise export files golden live marine record report session
                        verify)
set(HAWSER_SCENE_TESTS bench cli docs draw exercise export files golden live record report scene
                       scenes session slow stepper threads validate verify vessel world)
# Folders of which no test is quick: those of bench test the benchmarks, not the library.
set(HAWSER_FULL_TESTS bench slow)
# Tests that start the program: it is built with them. Those of scene skip a test without it.
set(HAWSER_PROGRAM_TESTS cli golden validate)
if(NOT HAWSER_SANITIZE)
    list(APPEND HAWSER_PROGRAM_TESTS scene)
endif()
# Tests whose own code computes enough to need optimisation.
set(HAWSER_OPTIMISED_TESTS assembly bench collide factor marine nonsmooth)
# Tests that run several threads: the thread sanitizer runs these.
set(HAWSER_THREAD_TESTS runtime threads)
# Folders whose quick tests take longest: they start first, so that all processors end together.
set(HAWSER_FIRST_TESTS exercise validate wire world stepper machine scene cli)
add_custom_target(hawser_quick_tests)
add_custom_target(hawser_full_tests)
add_dependencies(hawser_full_tests hawser_quick_tests)
foreach(program IN ITEMS hawser_program hawser_bench)
    if(TARGET ${program})
        add_dependencies(hawser_full_tests ${program})
    endif()
endforeach()
add_custom_target(hawser_thread_tests)

hawser_sources(support_sources tests/support)
add_library(hawser_test_support STATIC ${support_sources})
hawser_use(hawser_test_support)
hawser_unity(hawser_test_support 16)
target_compile_options(hawser_test_support PRIVATE $<$<CONFIG:Release>:-O1>)
target_include_directories(hawser_test_support PRIVATE ${PROJECT_SOURCE_DIR}/tests)
target_link_libraries(hawser_test_support PUBLIC GTest::gtest)

# Options of sources of tests. Only tests that compute dense references themselves are optimised.
function(hawser_test_settings target level)
    target_compile_options(${target} PRIVATE
        $<$<CONFIG:Release>:${level}> $<$<CONFIG:Sanitize>:-O0>)
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
    hawser_test_settings(hawser_test_headers -O0)
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
        target_sources(${target} PRIVATE
            "${PROJECT_SOURCE_DIR}/tests/machine/failing.cpp")
    endif()
    hawser_use(${target} ${libraries})
    if(folder STREQUAL scene)  # the schema is checked by valijson; tests write files of these formats
        find_path(VALIJSON_INCLUDE_DIR valijson/validator.hpp REQUIRED)
        target_include_directories(${target} SYSTEM PRIVATE ${VALIJSON_INCLUDE_DIR})
        foreach(format IN ITEMS NETCDF HDF5)
            if(HAWSER_${format})
                target_link_libraries(${target} PRIVATE PkgConfig::${format})
                target_compile_definitions(${target} PRIVATE HAWSER_HAVE_${format}=1)
            endif()
        endforeach()
    endif()
    hawser_unity(${target} 6)
    if(folder IN_LIST HAWSER_OPTIMISED_TESTS)
        hawser_test_settings(${target} -O1)
    else()
        hawser_test_settings(${target} -O0)
        if(TARGET hawser_test_headers)
            target_precompile_headers(${target} REUSE_FROM hawser_test_headers)
        endif()
    endif()
    target_link_libraries(${target} PRIVATE hawser_test_support)

    if(folder IN_LIST HAWSER_FULL_TESTS)
        add_dependencies(hawser_full_tests ${target})
        hawser_add_shards(${target} ${folder} full 2 "-*_long")
    else()
        add_dependencies(hawser_quick_tests ${target})
        hawser_add_shards(${target} ${folder} quick 2 "-*_full:*_long:*_full/*:*_long/*")
    endif()
    if(folder IN_LIST HAWSER_PROGRAM_TESTS AND TARGET hawser_program)
        add_dependencies(${target} hawser_program)
    endif()
    if(folder IN_LIST HAWSER_THREAD_TESTS)
        add_dependencies(hawser_thread_tests ${target})
    endif()

    set(tests "")
    foreach(source IN LISTS ARGN)
        file(STRINGS "${source}" names REGEX "_(full|long)[)\"]")
        list(APPEND tests ${names})
    endforeach()
    if(tests MATCHES "_full[)\"]" AND NOT folder IN_LIST HAWSER_FULL_TESTS)
        hawser_add_shards(${target} ${folder} full 2 "*_full:*_full/*")
    endif()
    if(tests MATCHES "_long[)\"]")
        hawser_add_shards(${target} ${folder} long 1 "*_long:*_long/*")
    endif()
endfunction()

# hawser_add_shards(TARGET FOLDER TIER COUNT FILTER): add the tests <folder>.<tier>.<number>.
function(hawser_add_shards target folder tier count filter)
    list(FIND HAWSER_FIRST_TESTS ${folder} cost)
    if(cost LESS 0)
        set(cost 1)
    else()
        math(EXPR cost "100 - ${cost}")
    endif()
    foreach(shard RANGE 1 ${count})
        set(name ${folder}.${tier}.${shard})
        if(count EQUAL 1)
            set(name ${folder}.${tier})
        endif()
        math(EXPR index "${shard} - 1")
        add_test(NAME ${name} COMMAND ${target} --gtest_brief=1 "--gtest_filter=${filter}"
            WORKING_DIRECTORY "${PROJECT_SOURCE_DIR}")
        set_tests_properties(${name} PROPERTIES LABELS ${tier} COST ${cost} TIMEOUT 7200
            ENVIRONMENT "HAWSER_BIN_DIR=${PROJECT_BINARY_DIR}/bin;GTEST_TOTAL_SHARDS=${count};GTEST_SHARD_INDEX=${index}")
    endforeach()
endfunction()

file(GLOB folders CONFIGURE_DEPENDS LIST_DIRECTORIES TRUE RELATIVE "${PROJECT_SOURCE_DIR}/tests"
     "${PROJECT_SOURCE_DIR}/tests/*")
list(REMOVE_ITEM folders support consumer scripts)
foreach(folder IN LISTS folders)
    if(IS_DIRECTORY "${PROJECT_SOURCE_DIR}/tests/${folder}")
        hawser_sources(sources tests/${folder})
        if(sources)
            hawser_add_test_executable(hawser_test_${folder} ${folder} ${sources})
        endif()
    endif()
endforeach()

# Functions of lanes are inlined into kernels: their checks are compiled for each instruction set.
if(TARGET hawser_test_factor)
    foreach(isa IN LISTS HAWSER_ISA_NAMES)
        set(objects hawser_test_lanes_${isa})
        add_library(${objects} OBJECT tests/factor/isa/lanes.cpp)
        hawser_settings(${objects})
        target_include_directories(${objects} PRIVATE ${PROJECT_SOURCE_DIR}/include
            ${PROJECT_SOURCE_DIR}/src ${PROJECT_SOURCE_DIR}/tests)
        target_compile_definitions(${objects} PRIVATE HAWSER_ISA=${isa})
        target_compile_options(${objects} PRIVATE -Wno-psabi ${HAWSER_ISA_FLAGS_${isa}})
        target_sources(hawser_test_factor PRIVATE $<TARGET_OBJECTS:${objects}>)
    endforeach()
endif()

# Kernels for lanes once more with the instructions that every machine has: vectors have other
# lengths there.
if(TARGET hawser_test_stepper AND NOT HAWSER_SANITIZE STREQUAL "thread")
    add_test(NAME stepper.sse2
        COMMAND hawser_test_stepper --gtest_filter=*Link*:*Forms*:-*_full:*_long --gtest_brief=1
        WORKING_DIRECTORY "${PROJECT_SOURCE_DIR}")
    set_tests_properties(stepper.sse2 PROPERTIES LABELS quick TIMEOUT 600 COST 90
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
            set_tests_properties(isa_symbols.${isa} PROPERTIES LABELS quick)
        endif()
    endforeach()

    add_test(NAME scripts
        COMMAND Python3::Interpreter "${PROJECT_SOURCE_DIR}/tests/scripts/test_scripts.py")
    set_tests_properties(scripts PROPERTIES LABELS quick)

    # Commands of README.md and of the tutorials: the short ones are quick.
    if(TARGET hawser_program)
        foreach(tier IN ITEMS quick full)
            add_test(NAME page_commands.${tier}
                COMMAND Python3::Interpreter "${PROJECT_SOURCE_DIR}/tests/docs/test_commands.py"
                        --tier ${tier} --bin "${PROJECT_BINARY_DIR}/bin")
            set_tests_properties(page_commands.${tier} PROPERTIES LABELS ${tier} TIMEOUT 7200)
        endforeach()
        add_dependencies(hawser_quick_tests hawser_program)
    endif()

    # Statistics in Python need numpy only. Without numpy the test is skipped.
    set(HAWSER_PYTHON_EXECUTABLE /usr/bin/python3 CACHE FILEPATH "Interpreter of the Python package")
    add_test(NAME python.quick
        COMMAND "${HAWSER_PYTHON_EXECUTABLE}" "${PROJECT_SOURCE_DIR}/python/tests/quick.py")
    set_tests_properties(python.quick PROPERTIES LABELS quick SKIP_RETURN_CODE 77)

    if(HAWSER_CCACHE AND HAWSER_UNITY AND CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
        add_test(NAME compiler_cache
            COMMAND Python3::Interpreter "${PROJECT_SOURCE_DIR}/tests/scripts/test_cache.py"
                    ${CMAKE_CXX_COMPILER_LAUNCHER} ${CMAKE_CXX_COMPILER})
        set_tests_properties(compiler_cache PROPERTIES LABELS quick)
    endif()

    add_test(NAME consumer
        COMMAND ${CMAKE_COMMAND}
            -DHAWSER_BINARY_DIR=${PROJECT_BINARY_DIR}
            -DCONSUMER_SOURCE_DIR=${PROJECT_SOURCE_DIR}/tests/consumer
            -DEXAMPLES_SOURCE_DIR=${PROJECT_SOURCE_DIR}/examples/library
            -DSCENES_DIR=${PROJECT_SOURCE_DIR}/scenes
            -DCXX_COMPILER=${CMAKE_CXX_COMPILER}
            -P "${PROJECT_SOURCE_DIR}/tests/consumer/run.cmake")
    set_tests_properties(consumer PROPERTIES LABELS full TIMEOUT 600 COST 10)

    add_test(NAME example_matrix_market
        COMMAND ${CMAKE_COMMAND}
            -DHAWSER_BINARY_DIR=${PROJECT_BINARY_DIR}
            -DEXAMPLE_SOURCE_DIR=${PROJECT_SOURCE_DIR}/examples/matrix_market
            -DCXX_COMPILER=${CMAKE_CXX_COMPILER}
            -P "${PROJECT_SOURCE_DIR}/examples/matrix_market/test.cmake")
    set_tests_properties(example_matrix_market PROPERTIES LABELS full TIMEOUT 600 COST 10)
endif()
