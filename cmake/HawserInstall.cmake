# SPDX-License-Identifier: Apache-2.0
#
# `cmake --install`: libraries, public headers, program, scenes, schema, and a package that another
# project uses by find_package(hawser [COMPONENTS scene session]) with hawser::hawser, hawser::scene
# and hawser::session. Components of the installation: library, program.

include(CMakePackageConfigHelpers)
set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/hawser)

install(TARGETS hawser EXPORT hawserTargets
    ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT library
    LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT library)
install(EXPORT hawserTargets NAMESPACE hawser:: DESTINATION ${package_dir} COMPONENT library)
foreach(name IN ITEMS scene session)
    if(TARGET hawser_${name})
        install(TARGETS hawser_${name} EXPORT hawser_${name}Targets
            ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT library)
        install(EXPORT hawser_${name}Targets NAMESPACE hawser:: DESTINATION ${package_dir}
            COMPONENT library)
    endif()
endforeach()
install(DIRECTORY include/hawser "${PROJECT_BINARY_DIR}/include/hawser"
    DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT library FILES_MATCHING PATTERN "*.h")

if(TARGET hawser_program)
    install(TARGETS hawser_program RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR}
        COMPONENT program)
endif()
foreach(folder IN ITEMS scenes exercises schema)
    if(IS_DIRECTORY "${PROJECT_SOURCE_DIR}/${folder}")
        install(DIRECTORY ${folder} DESTINATION ${CMAKE_INSTALL_DATADIR}/hawser
            COMPONENT program)
    endif()
endforeach()
install(FILES LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT library)

configure_package_config_file(cmake/hawserConfig.cmake.in hawserConfig.cmake
    INSTALL_DESTINATION ${package_dir})
write_basic_package_version_file(hawserConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES "${PROJECT_BINARY_DIR}/hawserConfig.cmake"
              "${PROJECT_BINARY_DIR}/hawserConfigVersion.cmake"
              cmake/FindAMD.cmake
    DESTINATION ${package_dir} COMPONENT library)
