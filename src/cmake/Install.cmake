# Installs the library, its headers and package files, and the command.
include(CMakePackageConfigHelpers)

set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/brachisto)
install(TARGETS brachisto
  EXPORT brachistoTargets
  FILE_SET HEADERS)
install(TARGETS brachisto_app)
install(EXPORT brachistoTargets NAMESPACE brachisto:: DESTINATION ${package_dir})

configure_package_config_file(
  ${PROJECT_SOURCE_DIR}/src/cmake/brachistoConfig.cmake.in
  ${PROJECT_BINARY_DIR}/brachistoConfig.cmake
  INSTALL_DESTINATION ${package_dir})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/brachistoConfigVersion.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES
  ${PROJECT_BINARY_DIR}/brachistoConfig.cmake
  ${PROJECT_BINARY_DIR}/brachistoConfigVersion.cmake
  ${PROJECT_SOURCE_DIR}/src/cmake/Dependencies.cmake
  DESTINATION ${package_dir})
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE ${PROJECT_SOURCE_DIR}/README.md
  DESTINATION ${CMAKE_INSTALL_DOCDIR})
install(DIRECTORY ${PROJECT_SOURCE_DIR}/problems
  DESTINATION ${CMAKE_INSTALL_DATADIR}/brachisto)
