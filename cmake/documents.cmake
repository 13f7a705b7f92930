# Installs the manual: the pages with their pictures in share/doc/carom, as in the source, and those
# that lie beside what they describe in share/carom. Their links lead to the installed files.
set(doc_folder ${CMAKE_INSTALL_DOCDIR})
set(data_folder ${CMAKE_INSTALL_DATADIR}/carom)
install(DIRECTORY docs DESTINATION ${doc_folder} PATTERN *.md EXCLUDE PATTERN *.sh EXCLUDE)
set(license LICENSE)
set(changelog CHANGELOG.md)
if(CAROM_DEB)  # cmake/deb.cmake installs these in the form that Debian requires
    set(license copyright)
    set(changelog changelog.gz)
else()
    install(FILES LICENSE CHANGELOG.md DESTINATION ${doc_folder})
endif()
install(CODE "set(source \"${PROJECT_SOURCE_DIR}\")
    set(adapted \"${PROJECT_BINARY_DIR}/documents\")
    set(places README.md=${doc_folder}/README.md LICENSE=${doc_folder}/${license} CHANGELOG.md=${doc_folder}/${changelog}
        docs=${doc_folder}/docs scenes=${data_folder}/scenes templates=${data_folder}/templates
        integrations=${data_folder}/integrations cluster=${data_folder}/cluster)")
install(SCRIPT ${PROJECT_SOURCE_DIR}/cmake/install_pages.cmake)
