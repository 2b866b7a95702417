# Installs the library, its headers and package files, the command and the documents: in
# the components that become packages, of which `command` takes what names no other.
include(CMakePackageConfigHelpers)
set(CMAKE_INSTALL_DEFAULT_COMPONENT_NAME command)

set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/brachisto)
install(TARGETS brachisto
  EXPORT brachistoTargets
  LIBRARY COMPONENT library NAMELINK_COMPONENT development
  ARCHIVE COMPONENT development
  FILE_SET HEADERS COMPONENT development)
install(TARGETS brachisto_app)
if(TARGET brachisto_prove)
  install(TARGETS brachisto_prove DESTINATION ${CMAKE_INSTALL_LIBEXECDIR}/brachisto)
endif()
install(EXPORT brachistoTargets NAMESPACE brachisto::
  DESTINATION ${package_dir} COMPONENT development)

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
  DESTINATION ${package_dir} COMPONENT development)

# An archive brings the libraries along that it stands on; a shared library has them.
file(RELATIVE_PATH prefix_from_pc
  ${CMAKE_INSTALL_FULL_LIBDIR}/pkgconfig ${CMAKE_INSTALL_PREFIX})
if(NOT BUILD_SHARED_LIBS)
  set(pc_packages "ipopt, fmt, yaml-cpp, muparser")
  set(pc_libraries "-lklu -ldmumps_seq")
endif()
configure_file(${PROJECT_SOURCE_DIR}/src/cmake/brachisto.pc.in
  ${PROJECT_BINARY_DIR}/brachisto.pc @ONLY)
install(FILES ${PROJECT_BINARY_DIR}/brachisto.pc
  DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig COMPONENT development)

install(FILES
  ${PROJECT_SOURCE_DIR}/LICENSE ${PROJECT_SOURCE_DIR}/README.md
  ${PROJECT_SOURCE_DIR}/CHANGELOG.md ${PROJECT_SOURCE_DIR}/CONTRIBUTING.md
  DESTINATION ${CMAKE_INSTALL_DOCDIR})
install(DIRECTORY ${PROJECT_SOURCE_DIR}/docs DESTINATION ${CMAKE_INSTALL_DOCDIR})
# share/man, share/bash-completion, share/zsh, share/fish, share/brachisto/schemas.
install(DIRECTORY ${PROJECT_BINARY_DIR}/src/app/share/
  DESTINATION ${CMAKE_INSTALL_DATADIR})
install(DIRECTORY ${PROJECT_SOURCE_DIR}/problems
  DESTINATION ${CMAKE_INSTALL_DATADIR}/brachisto)
