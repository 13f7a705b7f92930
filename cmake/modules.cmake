# carom_module(NAME [QUICK] USES targets... PRIVATE targets... PROGRAM files... LOOPS files... UNITS "paths..."...): the static library of
# src/NAME, without the files of PROGRAM.
# USES is what its headers may show; PRIVATE stays inside its .cpp files.
# QUICK: no inner loop of simulation or drawing is there, so that it is compiled with -Og, in half of the time.
# LOOPS: files of a QUICK module with loops over all particles of a frame, which are compiled with -O3, each by itself.
# UNITS: without ccache (CAROM_UNITY) the files of several folders are compiled as one, in half of the time. Each of UNITS lists
# folders of src/NAME (. is itself) and single files; a folder that is in none is a unit by itself. Names in the unnamed namespaces
# of one unit must differ: where two files share a name that each of them is right to use, one is listed in another unit.
function(carom_module name)
    cmake_parse_arguments(arg "QUICK" "" "USES;PRIVATE;PROGRAM;LOOPS;UNITS" ${ARGN})
    file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/src/${name}/*.cpp)
    list(TRANSFORM arg_PROGRAM PREPEND ${PROJECT_SOURCE_DIR}/src/${name}/)
    list(REMOVE_ITEM sources ${arg_PROGRAM})
    add_library(carom_${name} STATIC ${sources})
    add_library(carom::${name} ALIAS carom_${name})
    target_include_directories(carom_${name} PUBLIC $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/src>)
    target_link_libraries(carom_${name} PUBLIC ${arg_USES} Threads::Threads
        PRIVATE $<BUILD_INTERFACE:carom_rules> ${arg_PRIVATE})
    if(arg_QUICK)
        target_compile_options(carom_${name} PRIVATE $<$<CONFIG:Release>:-Og>)
        list(TRANSFORM arg_LOOPS PREPEND ${PROJECT_SOURCE_DIR}/src/${name}/)
        set_source_files_properties(${arg_LOOPS} PROPERTIES COMPILE_OPTIONS $<$<CONFIG:Release>:-O3>)
    endif()
    if(CAROM_UNITY)
        set_target_properties(carom_${name} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
        foreach(source IN LISTS sources)
            cmake_path(RELATIVE_PATH source BASE_DIRECTORY ${PROJECT_SOURCE_DIR}/src/${name} OUTPUT_VARIABLE path)
            cmake_path(GET path PARENT_PATH folder)
            if(NOT folder)
                set(folder .)
            endif()
            set(group ${folder})
            foreach(wanted IN ITEMS ${folder} ${path})  # a file's own entry comes before its folder's
                set(number 0)
                foreach(unit IN LISTS arg_UNITS)
                    math(EXPR number "${number} + 1")
                    string(REPLACE " " ";" unit "${unit}")
                    if(wanted IN_LIST unit)
                        set(group unit_${number})
                    endif()
                endforeach()
            endforeach()
            string(REPLACE "/" "_" group ${group})
            set_source_files_properties(${source} PROPERTIES UNITY_GROUP ${group})
        endforeach()
    endif()
endfunction()
