# Finds the Python that the package is built for.

# What is wrong with a Python, as a clause; nothing if it has all that the package needs.
set(python_examination [=[
import os, sys, sysconfig
if sys.version_info < (3, 9):
    sys.exit("is Python %d.%d, and 3.9 is needed" % sys.version_info[:2])
try:
    import numpy
except Exception:
    sys.exit("has no numpy")
if not os.path.exists(os.path.join(sysconfig.get_paths()["include"], "Python.h")):
    sys.exit("has no Python.h")
print(sys.executable)
]=])

# python_with_numpy(VARIABLE [GIVEN]): the program of the first Python in the PATH that has NumPy
# and headers; the given one, if there is one, and no other. It is an error if there is none: it
# says which were tried, and what each of them lacks.
function(python_with_numpy variable)
  set(candidates ${ARGN})
  if(NOT candidates)
    string(REPLACE ":" ";" directories "$ENV{PATH}")
    foreach(directory IN LISTS directories ITEMS /usr/bin)
      file(GLOB versions ${directory}/python3.[0-9] ${directory}/python3.[0-9][0-9])
      list(SORT versions COMPARE NATURAL ORDER DESCENDING)
      foreach(program IN LISTS directory versions)
        if(program STREQUAL directory)
          set(program ${directory}/python3)
        endif()
        if(EXISTS ${program} AND NOT program IN_LIST candidates)
          list(APPEND candidates ${program})
        endif()
      endforeach()
    endforeach()
  endif()
  set(tried "")
  foreach(program IN LISTS candidates)
    execute_process(COMMAND ${program} -c "${python_examination}"
      RESULT_VARIABLE failed OUTPUT_VARIABLE found ERROR_VARIABLE lack
      OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_STRIP_TRAILING_WHITESPACE)
    if(failed STREQUAL "0")
      set(${variable} ${found} PARENT_SCOPE)
      return()
    endif()
    if(NOT lack MATCHES "^(is|has) [^\n]*$")
      set(lack "does not run")
    endif()
    string(APPEND tried "\n  ${program} ${lack}")
  endforeach()
  if(NOT tried)
    set(tried "\n  there is no python3 in the PATH")
  endif()
  message(FATAL_ERROR "The Python package needs a Python with numpy and its headers (Debian: "
    "python3-dev python3-numpy). Tried:${tried}\n"
    "-DPython3_EXECUTABLE=PROGRAM names another one.")
endfunction()
