# Removes what `cmake --install` has written, using its manifest, and the folders that become empty.
# Usage:
# cmake -D MANIFEST=build/release/install_manifest.txt -P cmake/uninstall.cmake, or the target
# `uninstall`.
if(NOT EXISTS "${MANIFEST}")
    message(FATAL_ERROR "nothing to remove: there is no ${MANIFEST}; it is written by cmake --install")
endif()
file(STRINGS "${MANIFEST}" files)
foreach(file IN LISTS files)
    set(path "$ENV{DESTDIR}${file}")
    if(EXISTS "${path}" OR IS_SYMLINK "${path}")
        file(REMOVE "${path}")
    endif()
    # Only the folders of carom itself: bin, share/man and others belong to the system.
    get_filename_component(folder "${path}" DIRECTORY)
    while(folder MATCHES "/carom(/|$)")
        file(GLOB left LIST_DIRECTORIES true "${folder}/*" "${folder}/.*")
        if(left OR NOT EXISTS "${folder}")
            break()
        endif()
        file(REMOVE_RECURSE "${folder}")
        get_filename_component(folder "${folder}" DIRECTORY)
    endwhile()
endforeach()
file(REMOVE "${MANIFEST}")
