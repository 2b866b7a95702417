# Debian packages of a build with a shared library, by CPack: one for each component of
# the install rules. The preset `packages` is such a build.
set(maintainer "The brachisto authors <brachisto@packages.invalid>")
if(DEFINED ENV{DEBFULLNAME} AND DEFINED ENV{DEBEMAIL})
  set(maintainer "$ENV{DEBFULLNAME} <$ENV{DEBEMAIL}>")
endif()
set(BRACHISTO_MAINTAINER ${maintainer}
  CACHE STRING "Who signs for the packages; by default DEBFULLNAME <DEBEMAIL>")

# Which sources these are. The version of the project is that of its next release: before
# it, packages say the time of their commit, by which they are in order, and its name.
# Sources without their history have the time of SOURCE_DATE_EPOCH alone.
find_package(Git QUIET)
set(commit "")
set(epoch "$ENV{SOURCE_DATE_EPOCH}")
if(GIT_FOUND AND EXISTS ${PROJECT_SOURCE_DIR}/.git)
  # git_says(VARIABLE ARGUMENTS…): empty where git fails.
  macro(git_says variable)
    execute_process(COMMAND ${GIT_EXECUTABLE} -C ${PROJECT_SOURCE_DIR} ${ARGN}
      OUTPUT_VARIABLE ${variable} OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
  endmacro()
  git_says(epoch log -1 --format=%ct)
  git_says(commit log -1 --format=.g%h)
  git_says(changes status --porcelain --untracked-files=no)
  git_says(release describe --exact-match --tags --match v${PROJECT_VERSION})
  if(changes)
    string(APPEND commit "+changed")
  endif()
endif()
set(CPACK_PACKAGE_VERSION ${PROJECT_VERSION})
if(epoch AND (changes OR NOT release))
  set(ENV{SOURCE_DATE_EPOCH} ${epoch})
  string(TIMESTAMP moment "%Y%m%d.%H%M%S" UTC)
  string(APPEND CPACK_PACKAGE_VERSION "~${moment}${commit}")
endif()

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME brachisto)
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "")
set(CPACK_PACKAGE_CONTACT ${BRACHISTO_MAINTAINER})
set(CPACK_PACKAGE_DIRECTORY ${PROJECT_BINARY_DIR}/debs)
set(CPACK_STRIP_FILES ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
  OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_VERBATIM_VARIABLES ON)
set(CPACK_COMPONENTS_GROUPING IGNORE)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_COMPRESSION_TYPE xz)
set(CPACK_DEBIAN_PACKAGE_SOURCE brachisto)
# Revisions of Debian itself would begin at 1.
set(CPACK_DEBIAN_PACKAGE_RELEASE 0.1)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_DEBIAN_ENABLE_COMPONENT_DEPENDS ON)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS ${PROJECT_BINARY_DIR}/src)

# What Debian wants beside, or instead of, what is installed.
set(CPACK_PRE_BUILD_SCRIPTS ${PROJECT_SOURCE_DIR}/src/cmake/packages/DebianFiles.cmake)
set(CPACK_BRACHISTO_EPOCH ${epoch})
set(CPACK_BRACHISTO_SOURCES ${PROJECT_SOURCE_DIR})

# package(COMPONENT NAME SECTION SYNOPSIS DESCRIPTION)
macro(package component name section synopsis description)
  list(APPEND CPACK_COMPONENTS_ALL ${component})
  string(TOUPPER ${component} key)
  set(CPACK_DEBIAN_${key}_PACKAGE_NAME ${name})
  set(CPACK_DEBIAN_${key}_PACKAGE_SECTION ${section})
  set(CPACK_COMPONENT_${key}_DESCRIPTION "${synopsis}\n${description}")
endmacro()

set(about "Given a cylinder whose centre of mass may lie off its axis, brachisto
finds the track from A to B that is the smooth-contact extremal, as a sparse
nonlinear program, to eleven digits and with a certificate: optimality
conditions recomputed outside the solver, contact at both ends, and the same
scene solved again with a higher degree.")

package(command brachisto science "brachistochrones of rolling bodies"
"${about}
.
This package has the command, its problem files and the documentation.")
set(CPACK_COMPONENT_COMMAND_DEPENDS library)
# Pictures are drawn by gnuplot if it is there; what is not drawn is said.
set(CPACK_DEBIAN_COMMAND_PACKAGE_RECOMMENDS "gnuplot-nox | gnuplot, fonts-dejavu-core")
set(CPACK_DEBIAN_COMMAND_PACKAGE_SUGGESTS "python3-brachisto")

get_target_property(soversion brachisto SOVERSION)
package(library libbrachisto${soversion} libs
"brachistochrones of rolling bodies (shared library)"
"${about}
.
This package has the shared library.")
# What is linked with it needs this version or a later one of the same soname. Debian
# tells the loader of it by a trigger.
set(control ${PROJECT_BINARY_DIR}/control)
file(WRITE ${control}/shlibs "libbrachisto ${soversion} libbrachisto${soversion}"
  " (>= ${CPACK_PACKAGE_VERSION})\n")
file(WRITE ${control}/triggers "activate-noawait ldconfig\n")
set(CPACK_DEBIAN_LIBRARY_PACKAGE_CONTROL_EXTRA ${control}/shlibs ${control}/triggers)

package(development libbrachisto-dev libdevel
"brachistochrones of rolling bodies (development files)"
"${about}
.
This package has the headers and what CMake and pkg-config need to find the
library.")
set(CPACK_COMPONENT_DEVELOPMENT_DEPENDS library)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SUGGESTS "brachisto")

if(BRACHISTO_BUILD_PYTHON)
  package(python python3-brachisto python "brachistochrones of rolling bodies (Python 3)"
"${about}
.
This package has the Python package: scenes, results as objects, motions as
NumPy arrays, and sweeps.")
  set(CPACK_COMPONENT_PYTHON_DEPENDS library)
  find_package(Python3 REQUIRED COMPONENTS Interpreter)
  math(EXPR next_minor "${Python3_VERSION_MINOR} + 1")
  string(CONCAT CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS
    "python3 (>= 3.${Python3_VERSION_MINOR}), python3 (<< 3.${next_minor}), "
    "python3-numpy")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_SUGGESTS "brachisto")
  # Debian compiles modules where they are installed.
  set(CPACK_DEBIAN_PYTHON_PACKAGE_CONTROL_EXTRA
    ${PROJECT_SOURCE_DIR}/src/cmake/packages/postinst
    ${PROJECT_SOURCE_DIR}/src/cmake/packages/prerm)
endif()

get_cmake_property(components COMPONENTS)
list(REMOVE_ITEM components ${CPACK_COMPONENTS_ALL})
if(components)
  message(FATAL_ERROR "no package has the install components: ${components}")
endif()
include(CPack)
