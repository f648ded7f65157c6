# The target `docs`: the pages of the C++ library in BUILD/docs/html, where Doxygen is there.
find_program(PERCAL_DOXYGEN doxygen)
mark_as_advanced(PERCAL_DOXYGEN)
find_package(Python3 QUIET COMPONENTS Interpreter)
if(NOT PERCAL_DOXYGEN OR NOT Python3_FOUND)
  return()
endif()
set(PERCAL_DOCS_OUTPUT ${PROJECT_BINARY_DIR}/docs)
configure_file(docs/Doxyfile.in ${PROJECT_BINARY_DIR}/Doxyfile @ONLY)
add_custom_target(docs
  COMMAND ${CMAKE_COMMAND} -E make_directory ${PERCAL_DOCS_OUTPUT}
  COMMAND ${PERCAL_DOXYGEN} ${PROJECT_BINARY_DIR}/Doxyfile
  COMMENT "Pages of the C++ library: ${PERCAL_DOCS_OUTPUT}/html/index.html" VERBATIM)
