# Finds the libraries that dependencies.txt lists; each C library becomes an imported target
# dep::NAME.
find_package(PkgConfig REQUIRED)
find_package(Threads REQUIRED)

file(STRINGS ${PROJECT_SOURCE_DIR}/dependencies.txt rows REGEX "^[^#]")
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/dependencies.txt)
foreach(row IN LISTS rows)
    string(REGEX REPLACE "[ \t]*\\|[ \t]*" "|" row "${row}")
    string(REPLACE "|" ";" fields "${row}")
    list(GET fields 4 finder)
    list(GET fields 5 minimum)
    list(GET fields 6 role)
    if(role STREQUAL "test" AND NOT CAROM_TESTS)
        continue()
    endif()
    if(finder MATCHES "^config (.+)$")
        string(STRIP "${CMAKE_MATCH_1}" name)
        # Eigen 5 rejects a request for version 3.4, so the version is compared here.
        find_package(${name} REQUIRED CONFIG)
        if(${name}_VERSION VERSION_LESS minimum)
            message(FATAL_ERROR "${name} ${${name}_VERSION} is older than ${minimum}")
        endif()
    elseif(finder MATCHES "^pkg (.+)$")
        string(STRIP "${CMAKE_MATCH_1}" name)
        pkg_check_modules(${name} REQUIRED IMPORTED_TARGET "${name}>=${minimum}")
        add_library(dep::${name} ALIAS PkgConfig::${name})
    endif()
endforeach()

# yaml-cpp 0.7 exports the target `yaml-cpp`, on some systems without its include folder; since 0.8
# there is also `yaml-cpp::yaml-cpp`, and some systems have only this name.
add_library(dep_yaml_cpp INTERFACE)
if(TARGET yaml-cpp::yaml-cpp)
    target_link_libraries(dep_yaml_cpp INTERFACE yaml-cpp::yaml-cpp)
else()
    target_link_libraries(dep_yaml_cpp INTERFACE yaml-cpp)
endif()
add_library(dep::yaml-cpp ALIAS dep_yaml_cpp)
