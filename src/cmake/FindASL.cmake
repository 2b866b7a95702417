# The AMPL Solver Library, which reads .nl files (Debian: libamplsolver-dev).
# Tests and benchmarks alone have a use for it.
find_path(ASL_INCLUDE_DIR asl_pfgh.h PATH_SUFFIXES ampl-netlib-solvers asl)
find_library(ASL_LIBRARY NAMES amplsolver asl)
mark_as_advanced(ASL_INCLUDE_DIR ASL_LIBRARY)
include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(ASL REQUIRED_VARS ASL_LIBRARY ASL_INCLUDE_DIR)
if(ASL_FOUND AND NOT TARGET ASL::ASL)
  add_library(ASL::ASL UNKNOWN IMPORTED)
  set_target_properties(ASL::ASL PROPERTIES
    IMPORTED_LOCATION ${ASL_LIBRARY}
    INTERFACE_INCLUDE_DIRECTORIES ${ASL_INCLUDE_DIR})
endif()
