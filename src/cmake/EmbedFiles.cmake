# Files as constants of a program, at build time:
#
#   cmake -DOUT=web_parts.cpp -DHEADER=plot/web_parts.hpp -DNAMESPACE=brachisto::plot
#         -DFILES=kName=path;kOther=path -P EmbedFiles.cmake
#
# Bytes, not string literals: of those a compiler need take no more than 65536.
set(text "#include \"${HEADER}\"\n\nnamespace {\n\n")
set(views "")
foreach(one IN LISTS FILES)
  string(REGEX MATCH "^([^=]+)=(.*)$" matched "${one}")
  set(name ${CMAKE_MATCH_1})
  file(READ "${CMAKE_MATCH_2}" bytes HEX)
  string(REGEX REPLACE "(..)" "0x\\1," bytes "${bytes}")
  string(APPEND text "constexpr unsigned char ${name}Bytes[] = {${bytes}};\n\n")
  string(APPEND views "const std::string_view ${name}{\n"
    "    reinterpret_cast<const char*>(${name}Bytes), sizeof ${name}Bytes};\n")
endforeach()
file(WRITE "${OUT}"
  "${text}}  // namespace\n\nnamespace ${NAMESPACE} {\n\n${views}\n}  // namespace ${NAMESPACE}\n")
