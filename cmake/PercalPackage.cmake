# `cpack -G DEB` in the build folder: one Debian package with program, library, headers, CMake package, Python module, data and docs.
# docs/how-to/packages.md
if(NOT PERCAL_INSTALL)
  return()
endif()
install(FILES README.md CHANGELOG.md cmake/copyright DESTINATION ${CMAKE_INSTALL_DOCDIR})
# As in the sources, so that links between pages hold.
install(DIRECTORY docs DESTINATION ${CMAKE_INSTALL_DOCDIR}
        FILES_MATCHING PATTERN "*.md" PATTERN "*.svg" PATTERN "*.cpp" PATTERN "tutorial.py")

# Debian's form of a changelog, compressed.
if(PERCAL_GZIP)
  string(TIMESTAMP now "%a, %d %b %Y %H:%M:%S +0000" UTC)
  file(WRITE ${PROJECT_BINARY_DIR}/described/changelog "percal (${PROJECT_VERSION}) unstable; urgency=low\n\n"
       "  * What changed: CHANGELOG.md beside this file.\n\n -- The percal authors <percal@localhost>  ${now}\n")
  execute_process(COMMAND ${PERCAL_GZIP} -9nf ${PROJECT_BINARY_DIR}/described/changelog)
  install(FILES ${PROJECT_BINARY_DIR}/described/changelog.gz DESTINATION ${CMAKE_INSTALL_DOCDIR})
endif()

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME percal)
set(CPACK_PACKAGE_VENDOR percal)
set(CPACK_PACKAGE_CONTACT "The percal authors <percal@localhost>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "${PROJECT_DESCRIPTION}")
set(CPACK_PACKAGE_DESCRIPTION
  "percal identifies the material parameters of soft solids from stress-stretch
curves and from the depths of particles shot into them, with its own explicit
finite-element impact solver as the forward model, and writes material cards
for LS-DYNA, Abaqus, CalculiX, OpenRadioss, FEBio and Ansys.
.
The package has the program, the static C++ library with its headers and CMake
package, the Python module and example data.")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS gnuplot-nox)
if(TARGET percal_python)
  math(EXPR next_minor "${Python3_VERSION_MINOR} + 1")
  string(APPEND CPACK_DEBIAN_PACKAGE_RECOMMENDS ", python3 (>= ${Python3_VERSION_MAJOR}.${Python3_VERSION_MINOR}), "
         "python3 (<< ${Python3_VERSION_MAJOR}.${next_minor}), python3-numpy")
endif()
set(CPACK_DEBIAN_PACKAGE_SUGGESTS
  "g++, cmake, libceres-dev, libnlopt-cxx-dev, libgsl-dev, libeigen3-dev, nlohmann-json3-dev, libfmt-dev, libsqlite3-dev, zlib1g-dev, libssl-dev, libpugixml-dev")
include(CPack)
