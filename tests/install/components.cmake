# cmake -DBUILD=DIRECTORY -DSTAGING=DIRECTORY -P components.cmake
#
# The components of a build, which become packages, have what belongs to them, and
# together what is installed without naming one, each file once.
cmake_minimum_required(VERSION 3.25)
load_cache(${BUILD} READ_WITH_PREFIX "" BUILD_SHARED_LIBS BRACHISTO_BUILD_PYTHON
  BRACHISTO_PYTHON_DIR CMAKE_INSTALL_LIBDIR CMAKE_INSTALL_LIBEXECDIR CMAKE_PROJECT_VERSION
  ARB_INCLUDE_DIR)
string(REGEX MATCH "^[0-9]+\\.[0-9]+" soversion ${CMAKE_PROJECT_VERSION})
set(lib ${CMAKE_INSTALL_LIBDIR})

# Regular expressions of paths. Each matches something, and something matches each path.
set(components command development)
set(command
  ${lib}/brachisto/libbrachisto-chain[.]so
  ${lib}/brachisto/libhsl[.]so
  bin/brachisto
  share/brachisto/problems/case[.]yaml
  share/brachisto/problems/.+[.]csv
  share/brachisto/problems/.+[.]yaml
  share/doc/brachisto/[A-Z]+[.]md
  share/doc/brachisto/LICENSE
  share/doc/brachisto/docs/.+
  share/brachisto/schemas/problem[.]schema[.]json
  share/brachisto/schemas/result[.]schema[.]json
  share/man/man1/brachisto[.]1
  share/man/man1/brachisto-[a-z-]+[.]1
  share/man/man5/brachisto-problem[.]5
  share/bash-completion/completions/brachisto
  share/zsh/site-functions/_brachisto
  share/fish/vendor_completions[.]d/brachisto[.]fish)
if(ARB_INCLUDE_DIR)
  list(APPEND command ${CMAKE_INSTALL_LIBEXECDIR}/brachisto/brachisto-prove)
endif()
set(development
  include/brachisto/brachisto[.]hpp
  include/brachisto_chain[.]h
  include/brachisto/version[.]hpp
  include/brachisto/.+[.]hpp
  ${lib}/cmake/brachisto/brachistoConfig[.]cmake
  ${lib}/cmake/brachisto/brachistoConfigVersion[.]cmake
  ${lib}/cmake/brachisto/brachistoTargets[.]cmake
  ${lib}/cmake/brachisto/brachistoTargets-[a-z]+[.]cmake
  ${lib}/cmake/brachisto/Dependencies[.]cmake
  ${lib}/pkgconfig/brachisto[.]pc)
if(BUILD_SHARED_LIBS)
  list(APPEND components library)
  list(APPEND development ${lib}/libbrachisto[.]so)
  set(library
    ${lib}/libbrachisto[.]so[.]${soversion}
    ${lib}/libbrachisto[.]so[.]${CMAKE_PROJECT_VERSION})
else()
  list(APPEND development ${lib}/libbrachisto[.]a)
endif()
if(BRACHISTO_BUILD_PYTHON)
  list(APPEND components python)
  set(python
    ${BRACHISTO_PYTHON_DIR}/brachisto/__init__[.]pyi?
    ${BRACHISTO_PYTHON_DIR}/brachisto/_core[.].+[.]so
    ${BRACHISTO_PYTHON_DIR}/brachisto/_[a-z]+[.]py
    ${BRACHISTO_PYTHON_DIR}/brachisto/py[.]typed)
endif()

# installed(VARIABLE NAME ARGUMENTS…): the paths that cmake --install gives.
function(installed variable name)
  execute_process(COMMAND ${CMAKE_COMMAND} --install ${BUILD}
    --prefix ${STAGING}/${name} ${ARGN} OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
  file(GLOB_RECURSE paths RELATIVE ${STAGING}/${name} ${STAGING}/${name}/*)
  set(${variable} ${paths} PARENT_SCOPE)
endfunction()

file(REMOVE_RECURSE ${STAGING})
installed(all all)
foreach(component IN LISTS components)
  installed(paths ${component} --component ${component})
  set(unexpected ${paths})
  foreach(pattern IN LISTS ${component})
    set(found ${paths})
    list(FILTER found INCLUDE REGEX "^${pattern}$")
    if(NOT found)
      message(SEND_ERROR "${component} has no ${pattern}")
    endif()
    list(FILTER unexpected EXCLUDE REGEX "^${pattern}$")
  endforeach()
  if(unexpected)
    message(SEND_ERROR "${component} has unexpected files: ${unexpected}")
  endif()
  list(APPEND together ${paths})
endforeach()

list(SORT all)
list(SORT together)
if(NOT all STREQUAL together)
  message(SEND_ERROR "the components are not what is installed:\n${together}\n${all}")
endif()
