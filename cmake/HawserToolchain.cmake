# SPDX-License-Identifier: Apache-2.0
#
# Compiler, linker and warning settings of every target of this project.

set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
# Always: the static library can then go into a Python module or an FMU.
set(CMAKE_POSITION_INDEPENDENT_CODE ON)

# Eigen aligns fixed-size types by the instruction set that the including file is compiled
# for: a user's -mavx would change the layout of public types. 16 bytes fits every x86-64.
set(HAWSER_ABI_DEFINITIONS EIGEN_MAX_ALIGN_BYTES=16)

# Headers (Eigen, nlohmann-json, GoogleTest) take most of the time to compile. A unity build reads
# them once for many sources, precompiled headers once for a whole target: together they cost a
# third. Names in anonymous namespaces of one target must then differ from each other, and only
# other presets and clang-tidy notice a missing include.
option(HAWSER_UNITY "Compile several sources of a target together, with precompiled headers" OFF)

if(PROJECT_IS_TOP_LEVEL)
    if(NOT CMAKE_BUILD_TYPE)
        set(CMAKE_BUILD_TYPE Release CACHE STRING "" FORCE)
    endif()
    set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
    set(CMAKE_RUNTIME_OUTPUT_DIRECTORY "${PROJECT_BINARY_DIR}/bin")

    # Kernels (src/*/isa) have -O3, see HawserIsa.cmake. Elsewhere -O3 gains nothing that
    # scripts/compare_speed.py can measure. Line numbers of the release build would be 85 % of the
    # program's size: presets for debugging and sanitizers have them.
    set(CMAKE_CXX_FLAGS_RELEASE "-O2 -DNDEBUG")
    set(CMAKE_CXX_FLAGS_DEBUG "-Og -g")
    set(CMAKE_CXX_FLAGS_RELASSERT "-O2 -g1")
    set(CMAKE_CXX_FLAGS_SANITIZE "-O1 -g1")

    find_program(HAWSER_CCACHE ccache)
    if(HAWSER_CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
        set(CMAKE_CXX_COMPILER_LAUNCHER "${HAWSER_CCACHE}")
        if(HAWSER_UNITY)
            # Environment of ccache:
            #   BASEDIR, NOHASHDIR  make paths relative, so that another checkout of the same
            #                       sources finds the objects
            #   DEPEND              compare the text of headers. Preprocessed text has no comments,
            #                       and g++ takes a header under #pragma once for another one if
            #                       its text differs from that of the precompiled header.
            #   SLOPPINESS          accept precompiled headers; no source uses __TIME__
            # Other presets do without: clang-tidy cannot read a compiler command behind env.
            list(PREPEND CMAKE_CXX_COMPILER_LAUNCHER
                env "CCACHE_BASEDIR=${PROJECT_SOURCE_DIR}" CCACHE_NOHASHDIR=1 CCACHE_DEPEND=1
                CCACHE_SLOPPINESS=pch_defines,time_macros)
        endif()
    endif()
    # Debug information and __FILE__ name sources relative to the source folder.
    add_compile_options("-ffile-prefix-map=${PROJECT_SOURCE_DIR}/=")
    if(HAWSER_UNITY AND CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
        # By default g++ collects garbage from 128 MB on, which takes a tenth of its time. Without,
        # the largest unit needs 1.3 GB.
        add_compile_options(--param=ggc-min-heapsize=1000000)
    endif()
    find_program(HAWSER_MOLD mold)
    if(HAWSER_MOLD)
        add_link_options(-fuse-ld=mold)
    endif()

    set(HAWSER_SANITIZE "" CACHE STRING "Value of -fsanitize= for all targets, or empty")
    if(HAWSER_SANITIZE)
        add_compile_options(-fsanitize=${HAWSER_SANITIZE} -fno-omit-frame-pointer
                            -fno-sanitize-recover=all)
        add_link_options(-fsanitize=${HAWSER_SANITIZE})
        if(HAWSER_SANITIZE MATCHES "address.*undefined")
            # The address sanitizer stops at bad pointers anyway. These checks of pointers would
            # nearly double the time to compile.
            add_compile_options(-fno-sanitize=null,alignment,object-size,vptr,pointer-overflow)
        endif()
        # Instrumentation hides initialisations from g++ 12 and it then warns falsely.
        add_compile_options(-Wno-maybe-uninitialized)
    endif()
endif()

option(HAWSER_WERROR "Treat warnings as errors" ${PROJECT_IS_TOP_LEVEL})

# hawser_unity(TARGET BATCH): compile up to BATCH sources of a target together, if HAWSER_UNITY is
# on. Sources with the property SKIP_UNITY_BUILD_INCLUSION, and those added later, stay apart.
#
# CMake's own UNITY_BUILD writes absolute paths into its sources: another checkout would not find
# the objects in the compiler cache.
function(hawser_unity target batch)
    if(NOT HAWSER_UNITY)
        return()
    endif()
    get_target_property(sources ${target} SOURCES)
    set(apart "")
    set(units "")
    set(text "")
    set(count 0)
    foreach(source IN LISTS sources)
        if(NOT source MATCHES "^[^$]*[.]cpp$")
            list(APPEND apart "${source}")
            continue()
        endif()
        get_source_file_property(skipped "${source}" SKIP_UNITY_BUILD_INCLUSION)
        if(skipped)
            list(APPEND apart "${source}")
            continue()
        endif()
        file(RELATIVE_PATH name "${PROJECT_SOURCE_DIR}" "${source}")
        string(APPEND text "#include \"${name}\"\n")
        math(EXPR count "${count} + 1")
        if(count EQUAL ${batch})
            hawser_unit(units ${target} "${text}")
            set(text "")
            set(count 0)
        endif()
    endforeach()
    if(count GREATER 0)
        hawser_unit(units ${target} "${text}")
    endif()
    set_target_properties(${target} PROPERTIES SOURCES "${apart};${units}")
    target_include_directories(${target} PRIVATE "${PROJECT_SOURCE_DIR}")
endfunction()

# hawser_unit(LIST TARGET TEXT): write a source with this text and append it to the list.
function(hawser_unit list target text)
    list(LENGTH ${list} number)
    set(file "${PROJECT_BINARY_DIR}/unity/${target}_${number}.cpp")
    file(CONFIGURE OUTPUT "${file}" CONTENT "${text}" @ONLY)
    set(${list} ${${list}} "${file}" PARENT_SCOPE)
endfunction()

# hawser_first(LIST REGEX): put the sources of a list first that match, so that they share units.
function(hawser_first list regex)
    set(first ${${list}})
    set(rest ${${list}})
    list(FILTER first INCLUDE REGEX "${regex}")
    list(FILTER rest EXCLUDE REGEX "${regex}")
    set(${list} ${first} ${rest} PARENT_SCOPE)
endfunction()

# hawser_precompile(TARGET HEADER...): read these headers once for all sources of a target, where
# HAWSER_UNITY is on. Sources include what they use all the same.
function(hawser_precompile target)
    if(HAWSER_UNITY)
        target_precompile_headers(${target} PRIVATE ${ARGN})
    endif()
endfunction()

# hawser_compile_fast(TARGET): options of a target that does not run within a step; -O2 would take
# half as long again to compile.
function(hawser_compile_fast target)
    target_compile_options(${target} PRIVATE
        $<$<CONFIG:Release>:-O1> $<$<CONFIG:Sanitize>:-O0>
        # With -O1, g++ 12 warns falsely about comparing strings that were put together.
        $<$<CXX_COMPILER_ID:GNU>:-Wno-stringop-overread>)
endfunction()

# hawser_client_headers(TARGET): compile a target above the library with the clients' precompiled
# headers, if HAWSER_UNITY is on. All such targets have the options of hawser_compile_fast.
function(hawser_client_headers target)
    if(NOT HAWSER_UNITY)
        return()
    endif()
    if(NOT TARGET hawser_client_pch)
        file(CONFIGURE OUTPUT client_headers.cpp CONTENT "")
        add_library(hawser_client_pch OBJECT "${CMAKE_CURRENT_BINARY_DIR}/client_headers.cpp")
        hawser_settings(hawser_client_pch)
        hawser_compile_fast(hawser_client_pch)
        target_link_libraries(hawser_client_pch PRIVATE
            hawser nlohmann_json::nlohmann_json fmt::fmt)
        target_precompile_headers(hawser_client_pch PRIVATE <hawser/hawser.h> <fmt/format.h>
            <nlohmann/json.hpp> <algorithm> <cmath> <filesystem> <fstream> <functional> <map>
            <set> <sstream> <stdexcept> <string> <unordered_map>)
    endif()
    target_precompile_headers(${target} REUSE_FROM hawser_client_pch)
    # A program is compiled with -fPIE otherwise, which the precompiled header is not.
    target_compile_options(${target} PRIVATE -fPIC)
endfunction()

# Warnings and code generation of one target.
#
# Floating point: no -ffast-math, no -march=native. Fused multiply-add is allowed where the
# instruction set has it (-ffp-contract=fast); results therefore depend on the dispatched
# instruction set, which is part of the state hash.
#
# g++ 12 warns falsely about overlapping copies inside std::string (GCC bug 105651).
function(hawser_settings target)
    target_compile_options(${target} PRIVATE
        -Wall -Wextra -Wpedantic -Wshadow $<$<BOOL:${HAWSER_WERROR}>:-Werror>
        $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict>
        -ffp-contract=fast -fno-math-errno)
endfunction()
