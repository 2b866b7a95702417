# cmake -DPROGRAM=FILE -DLIBRARY=FILE -DNM=FILE -P ipopt.cmake
#
# A program that asks Ipopt for MA97 gets the chain, and finds with it what it finds with MUMPS, in
# as many iterations. The library shows the names of MA97 and its own alone.
cmake_minimum_required(VERSION 3.25)
get_filename_component(folder ${LIBRARY} DIRECTORY)
set(ENV{LD_LIBRARY_PATH} ${folder}:$ENV{LD_LIBRARY_PATH})
foreach(intervals IN ITEMS 40 1000)
  foreach(solver IN ITEMS mumps ma97)
    execute_process(COMMAND ${PROGRAM} ${solver} ${intervals}
      OUTPUT_VARIABLE out ERROR_VARIABLE err RESULT_VARIABLE failed)
    if(failed OR NOT out MATCHES "^0 ([0-9]+) ([0-9.]+) ")
      message(FATAL_ERROR "${solver} on ${intervals} intervals: ${failed} ${out}${err}")
    endif()
    set(iterations_${solver} ${CMAKE_MATCH_1})
    # Ten digits, as many as the tolerance gives.
    string(SUBSTRING ${CMAKE_MATCH_2} 0 11 cost_${solver})
  endforeach()
  if(NOT "${iterations_ma97} ${cost_ma97}" STREQUAL "${iterations_mumps} ${cost_mumps}")
    message(FATAL_ERROR "${intervals} intervals: ${iterations_ma97} iterations to ${cost_ma97} "
      "with the chain, ${iterations_mumps} to ${cost_mumps} with MUMPS")
  endif()
endforeach()

execute_process(COMMAND ${NM} -D --defined-only ${LIBRARY} OUTPUT_VARIABLE names
  COMMAND_ERROR_IS_FATAL ANY)
string(REGEX REPLACE "[0-9a-f]+ T (ma97_[a-z_]+_d|brachisto_chain_[a-z]+)\n" "" others "${names}")
if(NOT others STREQUAL "" OR names STREQUAL "")
  message(FATAL_ERROR "the library shows: ${names}")
endif()
