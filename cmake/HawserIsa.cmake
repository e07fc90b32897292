# SPDX-License-Identifier: Apache-2.0
#
# Run-time SIMD dispatch: each file src/<room>/isa/*.cpp is compiled once per instruction set,
# with its code in `namespace hawser::HAWSER_ISA`. The library picks one at start.
#
# Such a file must not define anything outside that namespace, not even an instance of an
# inline function of the standard library or of Eigen: the linker keeps one copy of each, and
# the copy with AVX code would crash on a machine without AVX. scripts/check_isa_symbols.py
# tests this on the object files.

set(HAWSER_ISA_NAMES sse2 avx2 avx512)
# The source for AVX2 is that for SSE2 with wider parts: sanitizers, under which kernels take long
# to compile, see one of the two.
# Who reads and writes which array is the same in all of them: the thread sanitizer sees one.
if(HAWSER_SANITIZE)
    list(REMOVE_ITEM HAWSER_ISA_NAMES avx2)
    if(HAWSER_SANITIZE STREQUAL "thread")
        list(REMOVE_ITEM HAWSER_ISA_NAMES avx512)
    endif()
endif()
set(HAWSER_ISA_FLAGS_sse2 "")
set(HAWSER_ISA_FLAGS_avx2 -mavx2 -mfma)
set(HAWSER_ISA_FLAGS_avx512 -mavx512f -mavx512dq -mavx512vl -mavx512bw -mavx2 -mfma
                            -mprefer-vector-width=512)

function(hawser_add_isa_sources library)
    foreach(isa IN ITEMS avx2 avx512)
        if(NOT ${isa} IN_LIST HAWSER_ISA_NAMES)
            string(TOUPPER ${isa} upper)
            target_compile_definitions(${library} PUBLIC HAWSER_NO_${upper})
        endif()
    endforeach()
    file(GLOB sources CONFIGURE_DEPENDS "${PROJECT_SOURCE_DIR}/src/*/isa/*.cpp")
    if(NOT sources)
        return()
    endif()
    foreach(isa IN LISTS HAWSER_ISA_NAMES)
        set(objects hawser_isa_${isa})
        add_library(${objects} OBJECT ${sources})
        hawser_settings(${objects})
        target_include_directories(${objects} PRIVATE
            ${PROJECT_SOURCE_DIR}/include ${PROJECT_SOURCE_DIR}/src)
        target_compile_definitions(${objects} PRIVATE
            HAWSER_ISA=${isa} ${HAWSER_ABI_DEFINITIONS})
        # -O3 wherever speed counts: the kernels rely on the optimiser to become vector code.
        # Instrumented code would take four times as long to compile with it.
        # No vector crosses a function boundary that is not inlined: the ABI note is moot.
        target_compile_options(${objects} PRIVATE
            $<IF:$<CONFIG:Sanitize>,-O1,-O3> -Wno-psabi ${HAWSER_ISA_FLAGS_${isa}})
        target_link_libraries(${objects} PRIVATE Eigen3::Eigen)
        # Most kernels take less time to compile than this header, for which Eigen is read.
        hawser_precompile(${objects} <hawser/interactions.h>)
        target_sources(${library} PRIVATE $<TARGET_OBJECTS:${objects}>)
    endforeach()
endfunction()
