# The Python that the package is built for is the first one that can be, and if there is
# none each that was tried is told with what it lacks.
#   cmake -DPYTHON=… -DSOURCES=… -DSCRATCH=… -P find_python.cmake
cmake_minimum_required(VERSION 3.25)
include(${SOURCES}/src/cmake/PythonWithNumPy.cmake)
if(DEFINED CHILD)  # which may fail
  python_with_numpy(found ${GIVEN})
  message(STATUS "found ${found}")
  return()
endif()

file(REMOVE_RECURSE ${SCRATCH})
# A Python without NumPy, an old one, one that does not run, and a good one.
function(make_python directory text)
  file(WRITE ${SCRATCH}/${directory}/python3 "#!/bin/sh\n${text}\n")
  file(CHMOD ${SCRATCH}/${directory}/python3 PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE)
endfunction()
make_python(bare "exec ${PYTHON} -I -S \"$@\"")
make_python(old "echo 'is Python 3.8, and 3.9 is needed' >&2; exit 1")
make_python(broken "exit 127")
make_python(good "exec ${PYTHON} \"$@\"")

# expect(PATTERN PATH [GIVEN])
function(expect pattern path)
  execute_process(COMMAND ${CMAKE_COMMAND} -E env PATH=${path} ${CMAKE_COMMAND} -DCHILD=1
      -DSOURCES=${SOURCES} "-DGIVEN=${ARGN}" -P ${CMAKE_CURRENT_FUNCTION_LIST_FILE}
    OUTPUT_VARIABLE said ERROR_VARIABLE said)
  string(REGEX REPLACE "[ \n]+" " " said "${said}")
  if(NOT said MATCHES "${pattern}")
    message(SEND_ERROR "expected ${pattern}, but it said: ${said}")
  endif()
endfunction()

set(s ${SCRATCH})
expect("found [^ ]*python3" "${s}/bare:${s}/old:${s}/broken:${s}/good:/usr/bin:/bin")
expect("Tried: ${s}/bare/python3 has no numpy" "/usr/bin:/bin" ${s}/bare/python3)
expect("Tried: ${s}/old/python3 is Python 3.8, and 3.9 is needed" "/usr/bin:/bin"
  ${s}/old/python3)
expect("Tried: ${s}/broken/python3 does not run" "/usr/bin:/bin" ${s}/broken/python3)
