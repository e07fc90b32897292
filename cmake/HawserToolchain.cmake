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

# Most of the time to compile goes into headers (Eigen, nlohmann-json, GoogleTest). A unity build
# reads them once for many sources, precompiled headers do so for a whole target: together the
# build costs a third. Names in anonymous namespaces of one target must then differ from each
# other, and a missing include is only seen by other presets and clang-tidy.
option(HAWSER_UNITY "Compile several sources of a target together, with precompiled headers" OFF)

if(PROJECT_IS_TOP_LEVEL)
    if(NOT CMAKE_BUILD_TYPE)
        set(CMAKE_BUILD_TYPE Release CACHE STRING "" FORCE)
    endif()
    set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
    set(CMAKE_RUNTIME_OUTPUT_DIRECTORY "${PROJECT_BINARY_DIR}/bin")

    # -g1 keeps function names and lines for profilers at little cost.
    set(CMAKE_CXX_FLAGS_RELEASE "-O3 -g1 -DNDEBUG")
    set(CMAKE_CXX_FLAGS_DEBUG "-Og -g")
    set(CMAKE_CXX_FLAGS_RELASSERT "-O2 -g1")
    set(CMAKE_CXX_FLAGS_SANITIZE "-O1 -g1")

    find_program(HAWSER_CCACHE ccache)
    if(HAWSER_CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
        set(CMAKE_CXX_COMPILER_LAUNCHER "${HAWSER_CCACHE}")
        if(HAWSER_UNITY)
            # ccache refuses precompiled headers without the sloppiness; no source uses __TIME__.
            # It has to compare the text of headers, not preprocessed text, which has no comments:
            # g++ takes a header under #pragma once for another one if its text is not that of
            # the precompiled one. Not for other presets: clang-tidy does not see through env.
            list(PREPEND CMAKE_CXX_COMPILER_LAUNCHER
                env CCACHE_DEPEND=1 CCACHE_SLOPPINESS=pch_defines,time_macros)
        endif()
    endif()
    if(HAWSER_UNITY AND CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
        # g++ collects garbage from 128 MB on, a tenth of its time; the largest unit takes 1.3 GB
        # without.
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
            # The address sanitizer stops at bad pointers anyway; these checks of pointers would
            # near double the time to compile.
            add_compile_options(-fno-sanitize=null,alignment,object-size,vptr,pointer-overflow)
        endif()
        # Instrumentation hides initialisations from g++ 12 and it then warns falsely.
        add_compile_options(-Wno-maybe-uninitialized)
    endif()
endif()

option(HAWSER_WERROR "Treat warnings as errors" ${PROJECT_IS_TOP_LEVEL})

# hawser_unity(TARGET BATCH): compile up to BATCH sources together, where HAWSER_UNITY is on.
function(hawser_unity target batch)
    if(HAWSER_UNITY)
        set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE ${batch})
    endif()
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

# hawser_compile_fast(TARGET): a target in which no step's time is spent; -O3 would take half as
# long again to compile.
function(hawser_compile_fast target)
    target_compile_options(${target} PRIVATE
        $<$<CONFIG:Release>:-O1> $<$<CONFIG:Sanitize>:-O0>)
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
