# The Debian packages that `./dev package` makes: carom, the program with all its data files, and
# libcarom-dev, the simulation core for other programs.
set(doc_folder ${PROJECT_BINARY_DIR}/deb)
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME carom)
set(CPACK_PACKAGE_VENDOR "The carom developers")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "lecture films and figures of gases, from a scene file")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_COMPONENTS_ALL program development)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_RELEASE 1)
set(CPACK_DEBIAN_PACKAGE_MAINTAINER "The carom developers <carom@noreply.invalid>")
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_NAME carom)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_DEPENDS "fonts-inter (>= 4.0~)")
# The libraries of libav are loaded at run time, so dpkg-shlibdeps does not see them; this finds the
# dependencies that it would give if they were linked.
foreach(library IN ITEMS libavcodec libavfilter libavformat libavutil)
    string(REGEX MATCH "^[0-9]+" major "${${library}_VERSION}")
    set(package "")
    file(GLOB lists /var/lib/dpkg/info/${library}*.shlibs)
    foreach(list IN LISTS lists)
        file(STRINGS "${list}" line REGEX "^${library} ${major} " LIMIT_COUNT 1)
        if(line)
            string(REGEX REPLACE "^${library} ${major} " "" package "${line}")
        endif()
    endforeach()
    if(NOT package)
        message(FATAL_ERROR "no installed package has ${library} ${major}")
    endif()
    string(APPEND CPACK_DEBIAN_PROGRAM_PACKAGE_DEPENDS ", ${package}")
endforeach()
set(CPACK_COMPONENT_PROGRAM_DESCRIPTION "carom simulates hard spheres or disks in a box and rods or points on a line
with exact collision times, draws the gas beside histograms and theory curves, and writes
films (MP4, WebM, GIF), figures (SVG, PDF, PNG) and tables. A scene is a few
lines of YAML. No screen is needed.")
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME libcarom-dev)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SHLIBDEPS OFF)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS "libeigen3-dev (>= 3.4), libmpfr-dev (>= 4.2), libfmt-dev (>= 9.1), libxxhash-dev (>= 0.8)")
set(CPACK_COMPONENT_DEVELOPMENT_DESCRIPTION "The core of carom, the event-driven simulation of hard spheres, disks and
rods, as a static library with its headers and a package for CMake: find_package(carom)
gives carom::physics.")

# Files that Debian's policy also requires: the copyright and the changelog.
file(READ ${PROJECT_SOURCE_DIR}/LICENSE license)
string(REPLACE "\n\n" "\n.\n" license "${license}")
string(REPLACE "\n" "\n " license "${license}")
file(READ ${PROJECT_SOURCE_DIR}/templates/reveal/LICENSE.txt reveal_license)
string(REPLACE "\n\n" "\n.\n" reveal_license "${reveal_license}")
string(REPLACE "\n" "\n " reveal_license "${reveal_license}")
file(WRITE ${doc_folder}/copyright "Format: https://www.debian.org/doc/packaging-manuals/copyright-format/1.0/
Upstream-Name: carom

Files: *
Copyright: 2026 The carom authors
License: Expat
 ${license}

Files: usr/share/carom/templates/reveal/*
Copyright: 2011-2026 Hakim El Hattab and reveal.js contributors
License: Expat and BSD-3-clause
 ${reveal_license}
")
find_program(GZIP gzip REQUIRED)
string(TIMESTAMP now "%a, %d %b %Y %H:%M:%S +0000" UTC)
file(WRITE ${doc_folder}/changelog.Debian "carom (${PROJECT_VERSION}-1) unstable; urgency=medium

  * Package of this version; changelog.gz says what has changed.

 -- ${CPACK_DEBIAN_PACKAGE_MAINTAINER}  ${now}
")
configure_file(${PROJECT_SOURCE_DIR}/CHANGELOG.md ${doc_folder}/changelog COPYONLY)
execute_process(COMMAND ${GZIP} -9nf changelog changelog.Debian WORKING_DIRECTORY ${doc_folder} COMMAND_ERROR_IS_FATAL ANY)
foreach(package IN ITEMS program:carom development:libcarom-dev)
    string(REPLACE ":" ";" package ${package})
    list(GET package 0 component)
    list(GET package 1 name)
    install(FILES ${doc_folder}/copyright ${doc_folder}/changelog.gz ${doc_folder}/changelog.Debian.gz DESTINATION share/doc/${name} COMPONENT ${component})
endforeach()
include(CPack)
