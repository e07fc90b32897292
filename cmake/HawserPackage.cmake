# SPDX-License-Identifier: Apache-2.0
#
# Packages by CPack: two Debian packages from the components of HawserInstall.cmake, `hawser`
# (program, scenes, exercises, schema) and `libhawser-dev` (libraries, headers, CMake package).
# `make release` builds and checks them (scripts/release.sh).

set(CPACK_PACKAGE_NAME hawser)
set(CPACK_PACKAGE_VERSION ${PROJECT_VERSION})
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "${PROJECT_DESCRIPTION}")
set(CPACK_PACKAGE_CONTACT "the authors of Hawser <hawser@localhost>")
set(CPACK_PACKAGE_CHECKSUM SHA256)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_GENERATOR DEB)

set(CPACK_COMPONENTS_ALL program library)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_NAME hawser)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_LIBRARY_PACKAGE_NAME libhawser-dev)
set(CPACK_DEBIAN_LIBRARY_PACKAGE_SECTION libdevel)
# The static libraries need these when a program is linked.
set(CPACK_DEBIAN_LIBRARY_PACKAGE_DEPENDS
    "libeigen3-dev, libsuitesparse-dev, libfmt-dev, libnetcdf-dev, libhdf5-dev")
set(CPACK_COMPONENT_PROGRAM_DESCRIPTION "Program hawser with its scenes, exercises and schema")
set(CPACK_COMPONENT_LIBRARY_DESCRIPTION "Libraries hawser, hawser_scene and hawser_session with headers")

include(CPack)
