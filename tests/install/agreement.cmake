# cmake -DROOT=DIRECTORY -P agreement.cmake
#
# What is written twice agrees: the documents quote the programs as they stand, and
# brachisto.hpp includes every other public header.
foreach(pair README:solve_scene docs/library:read_track docs/library:follow_offset
    docs/library:hanging_rope docs/library:double_integrator docs/library:least_time
    docs/library:keeping_off docs/library:fastest_bead)
  string(REPLACE ":" ";" pair ${pair})
  list(GET pair 0 document)
  list(GET pair 1 program)
  file(READ ${ROOT}/${document}.md text)
  file(READ ${ROOT}/tests/install/programs/${program}.cpp quoted)
  string(FIND "${text}" "```cpp\n${quoted}```" place)
  if(place EQUAL -1)
    message(SEND_ERROR "${document}.md does not quote ${program}.cpp as it stands")
  endif()
endforeach()

file(READ ${ROOT}/include/brachisto/brachisto.hpp all)
file(GLOB_RECURSE headers RELATIVE ${ROOT}/include ${ROOT}/include/*.hpp)
list(REMOVE_ITEM headers brachisto/brachisto.hpp)
foreach(header ${headers} brachisto/version.hpp)
  string(FIND "${all}" "#include \"${header}\"\n" place)
  if(place EQUAL -1)
    message(SEND_ERROR "brachisto.hpp does not include ${header}")
  endif()
endforeach()
