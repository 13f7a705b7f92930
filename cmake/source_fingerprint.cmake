# carom_source_fingerprint(TARGET): adds a generated source file that defines
# carom::source_fingerprint and is regenerated whenever a file of src/ changes.
function(carom_source_fingerprint target)
    file(GLOB_RECURSE files RELATIVE ${PROJECT_SOURCE_DIR} CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/src/*)
    list(SORT files)
    set(folder ${PROJECT_BINARY_DIR}/source_fingerprint)
    list(JOIN files "\n" lines)
    file(CONFIGURE OUTPUT ${folder}/files.txt CONTENT "${lines}\n" @ONLY)
    list(TRANSFORM files PREPEND ${PROJECT_SOURCE_DIR}/)
    set(script ${PROJECT_SOURCE_DIR}/cmake/write_source_fingerprint.cmake)
    add_custom_command(OUTPUT ${folder}/source_fingerprint.cpp
        COMMAND ${CMAKE_COMMAND} -DROOT=${PROJECT_SOURCE_DIR} -DLIST=${folder}/files.txt
                -DOUTPUT=${folder}/source_fingerprint.cpp -P ${script}
        DEPENDS ${files} ${folder}/files.txt ${script}
        VERBATIM)
    target_sources(${target} PRIVATE ${folder}/source_fingerprint.cpp)
endfunction()
