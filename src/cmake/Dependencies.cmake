# Third-party libraries as imported targets. This file is installed too: the
# package of the library finds with it what its archive links to. None of them
# stands in a public header.
find_package(PkgConfig REQUIRED)
pkg_check_modules(IPOPT REQUIRED IMPORTED_TARGET GLOBAL ipopt)
find_package(Eigen3 3.4 REQUIRED NO_MODULE)
find_package(Boost 1.74 REQUIRED)
find_package(fmt 9 REQUIRED)
find_package(nlohmann_json 3.11 REQUIRED)
find_package(yaml-cpp 0.7 REQUIRED)
find_package(muparser REQUIRED)

# SuiteSparse of Debian 12 has no CMake package of its own.
if(NOT TARGET SuiteSparse::SuiteSparseConfig)
  find_path(SUITESPARSE_INCLUDE_DIR SuiteSparse_config.h
    PATH_SUFFIXES suitesparse REQUIRED)
  find_library(SUITESPARSE_CONFIG_LIBRARY suitesparseconfig REQUIRED)
  add_library(SuiteSparse::SuiteSparseConfig UNKNOWN IMPORTED)
  set_target_properties(SuiteSparse::SuiteSparseConfig PROPERTIES
    IMPORTED_LOCATION ${SUITESPARSE_CONFIG_LIBRARY}
    INTERFACE_INCLUDE_DIRECTORIES ${SUITESPARSE_INCLUDE_DIR})
endif()
