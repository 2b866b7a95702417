# brachisto::warnings: what our own code is compiled with, never exported.
add_library(brachisto_warnings INTERFACE)
add_library(brachisto::warnings ALIAS brachisto_warnings)
target_compile_options(brachisto_warnings INTERFACE
  -Wall -Wextra -Wpedantic -Wconversion -Wshadow -Wnon-virtual-dtor
  $<$<BOOL:${BRACHISTO_DEVELOPER}>:-Werror>
  # Of files that are compiled together, each names its own as it likes.
  $<$<BOOL:${CMAKE_UNITY_BUILD}>:-Wno-shadow>
  # g++ 12 sees overlapping copies inside std::string where there are none.
  $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict>)
