# SPDX-License-Identifier: Apache-2.0
#
# hawser-bench: a program apart from `hawser`, because it links foreign engines and GPL parts
# of SuiteSparse. It is never installed. Each peer is used where it is found; the source sees
# HAWSER_HAVE_<PEER> as 1 or 0. With HAWSER_BENCH_LIBRARIES=OFF the build is that of a machine
# which lacks the group `bench` of scripts/packages.txt; SuiteSparse stays, the library needs AMD.

hawser_sources(bench_sources bench)
if(NOT bench_sources)
    return()
endif()

# What is compared needs no foreign engine or solver: it is tested everywhere.
set(own_sources peers/scenes peers/scene_parts peers/mooring_scenes peers/stack_scenes
                peers/forest peers/meter peers/reference
                paper_matrix/block_system paper_matrix/paper_scene paper_matrix/paper_values
                paper_matrix/structures paper_matrix/matrix_market
                linear/form linear/assemble linear/tables linear/sweeps linear/reference
                hashes/compare)
list(TRANSFORM own_sources REPLACE "(.+)" "${PROJECT_SOURCE_DIR}/bench/\\1.cpp")
list(REMOVE_ITEM bench_sources ${own_sources})
list(APPEND own_sources "${PROJECT_SOURCE_DIR}/examples/matrix_market/market.cpp")
add_library(hawser_bench_own OBJECT ${own_sources})
hawser_use(hawser_bench_own hawser_scene)
hawser_unity(hawser_bench_own 7)
target_include_directories(hawser_bench_own PRIVATE
    ${PROJECT_SOURCE_DIR}/bench ${PROJECT_SOURCE_DIR}/examples)
target_link_libraries(hawser_bench_own PRIVATE AMD::AMD)
if(NOT HAWSER_BENCH)
    return()
endif()

find_package(PkgConfig QUIET)
if(PKG_CONFIG_FOUND)
    pkg_check_modules(ODE QUIET IMPORTED_TARGET ode)
    # Bullet in double precision; the .pc file carries BT_USE_DOUBLE_PRECISION.
    pkg_check_modules(BULLET QUIET IMPORTED_TARGET bullet-float64)
endif()
find_package(Simbody QUIET)
find_package(CLI11 REQUIRED)
find_package(fmt REQUIRED)
find_package(nlohmann_json 3.11 REQUIRED)

# The headers of Simbody 3.7 do not compile as C++20: files simbody*.cpp are C++17
# and talk to the rest through plain C++17 headers. They are left out where Simbody is missing.
set(simbody_sources ${bench_sources})
list(FILTER simbody_sources INCLUDE REGEX "/bench/(peers|wires)/simbody[^/]*\\.cpp$")
if(simbody_sources)
    list(REMOVE_ITEM bench_sources ${simbody_sources})
endif()

# The commands apart: they read CLI11 and nlohmann-json, the rest does not, and what is timed is not
# in them.
set(command_sources ${bench_sources})
list(FILTER command_sources INCLUDE REGEX "/bench/([a-z_]+|hashes/[a-z]+|partition/cost_study)\\.cpp$")
list(REMOVE_ITEM bench_sources ${command_sources})
# `hawser bench view` has the client of the tests, which knows nothing of the server's code.
list(APPEND command_sources "${PROJECT_SOURCE_DIR}/tests/live/client.cpp")
add_library(hawser_bench_commands OBJECT ${command_sources})
hawser_use(hawser_bench_commands hawser_report hawser_scene)
target_include_directories(hawser_bench_commands PRIVATE "${PROJECT_SOURCE_DIR}/tests")
hawser_unity(hawser_bench_commands 7)
hawser_compile_fast(hawser_bench_commands)
add_executable(hawser_bench ${bench_sources} $<TARGET_OBJECTS:hawser_bench_own>
    $<TARGET_OBJECTS:hawser_bench_commands>)
foreach(property IN ITEMS COMPILE_DEFINITIONS INCLUDE_DIRECTORIES)
    set_property(TARGET hawser_bench_commands APPEND PROPERTY ${property}
        $<TARGET_PROPERTY:hawser_bench,${property}>)
endforeach()
target_link_libraries(hawser_bench_commands PRIVATE CLI11::CLI11 fmt::fmt
    nlohmann_json::nlohmann_json)
set_target_properties(hawser_bench PROPERTIES OUTPUT_NAME hawser-bench)
hawser_use(hawser_bench hawser_report hawser_scene)
hawser_unity(hawser_bench 7)
target_include_directories(hawser_bench PRIVATE
    ${PROJECT_SOURCE_DIR}/bench ${PROJECT_SOURCE_DIR}/examples)
target_link_libraries(hawser_bench PRIVATE CLI11::CLI11 fmt::fmt nlohmann_json::nlohmann_json)

target_compile_definitions(hawser_bench PRIVATE
    HAWSER_BENCH_REFERENCE="${PROJECT_SOURCE_DIR}/bench/peers/reference")

# What an earlier configuration of the folder found stays in its cache: each use asks the option.
set(foreign_peers ODE BULLET SIMBODY MUJOCO METIS SCOTCH MUMPS)
function(hawser_bench_peer name found)
    if(found AND (HAWSER_BENCH_LIBRARIES OR NOT name IN_LIST foreign_peers))
        target_compile_definitions(hawser_bench PRIVATE HAWSER_HAVE_${name}=1)
        target_link_libraries(hawser_bench PRIVATE ${ARGN})
    else()
        target_compile_definitions(hawser_bench PRIVATE HAWSER_HAVE_${name}=0)
        message(STATUS "hawser-bench: ${name} left out")
    endif()
endfunction()

hawser_bench_peer(ODE "${ODE_FOUND}" PkgConfig::ODE)
hawser_bench_peer(BULLET "${BULLET_FOUND}" PkgConfig::BULLET)
# The targets that Debian's MuJoCo 2.2.2 exports name folders of other packages: asked by hand.
find_path(MUJOCO_INCLUDE_DIR mujoco/mujoco.h)
find_library(MUJOCO_LIBRARY mujoco)
mark_as_advanced(MUJOCO_INCLUDE_DIR MUJOCO_LIBRARY)
if(MUJOCO_INCLUDE_DIR AND MUJOCO_LIBRARY)
    target_include_directories(hawser_bench SYSTEM PRIVATE ${MUJOCO_INCLUDE_DIR})
    hawser_bench_peer(MUJOCO TRUE ${MUJOCO_LIBRARY})
else()
    hawser_bench_peer(MUJOCO FALSE)
endif()
if(HAWSER_BENCH_LIBRARIES AND Simbody_FOUND AND simbody_sources)
    add_library(hawser_bench_simbody OBJECT ${simbody_sources})
    hawser_settings(hawser_bench_simbody)
    # Debian builds Simbody with assertions on, and its inline State classes have other members
    # under NDEBUG: with it the program and the library disagree on their layout.
    target_compile_options(hawser_bench_simbody PRIVATE -UNDEBUG)
    set_target_properties(hawser_bench_simbody PROPERTIES CXX_STANDARD 17)
    target_include_directories(hawser_bench_simbody PRIVATE ${PROJECT_SOURCE_DIR}/bench)
    target_compile_definitions(hawser_bench_simbody PRIVATE ${HAWSER_ABI_DEFINITIONS})
    target_link_libraries(hawser_bench_simbody PRIVATE Eigen3::Eigen)
    target_include_directories(hawser_bench_simbody SYSTEM PRIVATE ${Simbody_INCLUDE_DIR})
    target_sources(hawser_bench PRIVATE $<TARGET_OBJECTS:hawser_bench_simbody>)
endif()
hawser_bench_peer(SIMBODY "${Simbody_FOUND}" ${Simbody_LIBRARIES})

foreach(peer IN ITEMS CHOLMOD LDL KLU METIS CAMD)
    string(TOLOWER ${peer} lower)
    find_path(${peer}_INCLUDE_DIR ${lower}.h PATH_SUFFIXES suitesparse)
    find_library(${peer}_LIBRARY ${lower})
    mark_as_advanced(${peer}_INCLUDE_DIR ${peer}_LIBRARY)
    if(${peer}_INCLUDE_DIR AND ${peer}_LIBRARY)
        target_include_directories(hawser_bench SYSTEM PRIVATE ${${peer}_INCLUDE_DIR})
        hawser_bench_peer(${peer} TRUE ${${peer}_LIBRARY})
    else()
        hawser_bench_peer(${peer} FALSE)
    endif()
endforeach()
find_path(SCOTCH_INCLUDE_DIR scotch.h PATH_SUFFIXES scotch)
find_library(SCOTCH_LIBRARY scotch)
find_library(SCOTCH_ERROR_LIBRARY scotcherr)
mark_as_advanced(SCOTCH_INCLUDE_DIR SCOTCH_LIBRARY SCOTCH_ERROR_LIBRARY)
if(SCOTCH_INCLUDE_DIR AND SCOTCH_LIBRARY AND SCOTCH_ERROR_LIBRARY)
    target_include_directories(hawser_bench SYSTEM PRIVATE ${SCOTCH_INCLUDE_DIR})
    hawser_bench_peer(SCOTCH TRUE ${SCOTCH_LIBRARY} ${SCOTCH_ERROR_LIBRARY})
else()
    hawser_bench_peer(SCOTCH FALSE)
endif()
# MUMPS without MPI: its headers are those of the version with.
find_path(MUMPS_INCLUDE_DIR dmumps_c.h)
find_library(MUMPS_LIBRARY dmumps_seq)
mark_as_advanced(MUMPS_INCLUDE_DIR MUMPS_LIBRARY)
if(MUMPS_INCLUDE_DIR AND MUMPS_LIBRARY)
    target_include_directories(hawser_bench SYSTEM PRIVATE ${MUMPS_INCLUDE_DIR})
    hawser_bench_peer(MUMPS TRUE ${MUMPS_LIBRARY})
else()
    hawser_bench_peer(MUMPS FALSE)
endif()
target_include_directories(hawser_bench SYSTEM PRIVATE ${AMD_INCLUDE_DIR})
target_link_libraries(hawser_bench PRIVATE AMD::AMD ${CMAKE_DL_LIBS})
