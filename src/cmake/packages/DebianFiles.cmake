# Run by CPack on the trees that become packages: copyright, changelogs, overrides of
# lintian and completions of zsh where Debian looks for them, manual pages compressed.
if(CPACK_BRACHISTO_EPOCH)
  set(ENV{SOURCE_DATE_EPOCH} ${CPACK_BRACHISTO_EPOCH})
endif()
string(TIMESTAMP date "%a, %d %b %Y %H:%M:%S +0000" UTC)

# compressed(FILES…): in their places, alike at any time.
function(compressed)
  execute_process(COMMAND gzip -9nf ${ARGN} COMMAND_ERROR_IS_FATAL ANY)
endfunction()

foreach(component IN LISTS CPACK_COMPONENTS_ALL)
  string(TOUPPER ${component} key)
  set(name ${CPACK_DEBIAN_${key}_PACKAGE_NAME})
  set(share ${CPACK_TEMPORARY_INSTALL_DIRECTORY}/${component}/usr/share)
  set(doc ${share}/doc/${name})

  file(COPY ${CMAKE_CURRENT_LIST_DIR}/copyright DESTINATION ${doc})
  file(REMOVE ${doc}/LICENSE ${doc}/CHANGELOG.md)
  file(COPY_FILE ${CPACK_BRACHISTO_SOURCES}/CHANGELOG.md ${doc}/changelog)
  file(WRITE ${doc}/changelog.Debian
"brachisto (${CPACK_PACKAGE_VERSION}-${CPACK_DEBIAN_PACKAGE_RELEASE}) bookworm; urgency=medium

  * Packages as the build makes them; what changed is in changelog.gz.

 -- ${CPACK_PACKAGE_CONTACT}  ${date}
")
  compressed(${doc}/changelog ${doc}/changelog.Debian)
  file(GLOB pages ${share}/man/man*/*.[1-8])
  if(pages)
    compressed(${pages})
  endif()
  if(EXISTS ${share}/zsh/site-functions)
    file(RENAME ${share}/zsh/site-functions ${share}/zsh/vendor-completions)
  endif()
  if(EXISTS ${CMAKE_CURRENT_LIST_DIR}/${component}.lintian)
    configure_file(${CMAKE_CURRENT_LIST_DIR}/${component}.lintian
      ${share}/lintian/overrides/${name} COPYONLY)
  endif()
endforeach()
