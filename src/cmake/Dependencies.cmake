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

# SuiteSparse of Debian 12 has no CMake package of its own. KLU and what it
# stands on are LGPL; UMFPACK, which is GPL, is not used.
if(NOT TARGET SuiteSparse::KLU)
  find_path(SUITESPARSE_INCLUDE_DIR klu.h PATH_SUFFIXES suitesparse REQUIRED)
  find_library(KLU_LIBRARY klu REQUIRED)
  add_library(SuiteSparse::KLU UNKNOWN IMPORTED)
  set_target_properties(SuiteSparse::KLU PROPERTIES
    IMPORTED_LOCATION ${KLU_LIBRARY}
    INTERFACE_INCLUDE_DIRECTORIES ${SUITESPARSE_INCLUDE_DIR})
endif()

# Debian's own way to MUMPS; Ipopt of Debian 13 does not hand on what it links.
if(NOT TARGET MUMPS::MUMPS)
  find_path(MUMPS_INCLUDE_DIR dmumps_c.h REQUIRED)
  find_library(MUMPS_LIBRARY dmumps_seq REQUIRED)
  add_library(MUMPS::MUMPS UNKNOWN IMPORTED)
  set_target_properties(MUMPS::MUMPS PROPERTIES
    IMPORTED_LOCATION ${MUMPS_LIBRARY}
    INTERFACE_INCLUDE_DIRECTORIES ${MUMPS_INCLUDE_DIR})
endif()
