# `cmake --install`: program, library, headers, data, and a CMake package for find_package(percal CONFIG).
option(PERCAL_INSTALL "Install percal with this project" ${PROJECT_IS_TOP_LEVEL})
if(NOT PERCAL_INSTALL)
  return()
endif()
include(CMakePackageConfigHelpers)

set(PERCAL_PACKAGE_DIR ${CMAKE_INSTALL_LIBDIR}/cmake/percal)

# A static library links what it uses in the program downstream, so the private dependencies are exported with it.
set_target_properties(percal_dependencies PROPERTIES EXPORT_NAME dependencies)
install(TARGETS percal percal_dependencies EXPORT percalTargets
        ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR})
install(EXPORT percalTargets NAMESPACE percal:: DESTINATION ${PERCAL_PACKAGE_DIR})
install(TARGETS percal_program RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
install(DIRECTORY lib/percal DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} FILES_MATCHING PATTERN "*.hpp")
install(DIRECTORY data DESTINATION ${CMAKE_INSTALL_DATADIR}/percal
        PATTERN "*.out" EXCLUDE PATTERN "*.store*" EXCLUDE)

# Manual pages and completion scripts, written by the program itself; a program for another machine cannot be run here.
if(NOT CMAKE_CROSSCOMPILING)
  set(described ${PROJECT_BINARY_DIR}/described)
  set(compressed true)  # where there is no gzip manual pages stay as they are
  find_program(PERCAL_GZIP gzip)
  if(PERCAL_GZIP)
    set(compressed "${PERCAL_GZIP} -9n ${described}/man1/*.1")
  endif()
  add_custom_command(OUTPUT ${described}/percal ${described}/_percal
    COMMAND ${CMAKE_COMMAND} -E rm -rf ${described}/man1
    COMMAND ${CMAKE_COMMAND} -E make_directory ${described}/man1
    COMMAND percal_program man --all ${described}/man1
    COMMAND sh -c "${compressed}"
    COMMAND percal_program completion bash > ${described}/percal
    COMMAND percal_program completion zsh > ${described}/_percal
    DEPENDS percal_program COMMENT "Manual pages and completion" VERBATIM)
  add_custom_target(percal_described ALL DEPENDS ${described}/percal)
  install(DIRECTORY ${described}/man1 DESTINATION ${CMAKE_INSTALL_MANDIR})
  install(FILES ${described}/percal DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions)
  install(FILES ${described}/_percal DESTINATION ${CMAKE_INSTALL_DATADIR}/zsh/site-functions)
endif()

configure_package_config_file(${CMAKE_CURRENT_LIST_DIR}/percalConfig.cmake.in
                              ${CMAKE_CURRENT_BINARY_DIR}/percalConfig.cmake
                              INSTALL_DESTINATION ${PERCAL_PACKAGE_DIR} PATH_VARS CMAKE_INSTALL_DATADIR)
write_basic_package_version_file(${CMAKE_CURRENT_BINARY_DIR}/percalConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/percalConfig.cmake ${CMAKE_CURRENT_BINARY_DIR}/percalConfigVersion.cmake
        DESTINATION ${PERCAL_PACKAGE_DIR})
