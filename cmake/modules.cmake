# carom_module(NAME [QUICK] USES targets... PRIVATE targets... SEPARATE files... PROGRAM files...): the static library of
# src/NAME, without the files of PROGRAM.
# USES is what its headers may show; PRIVATE stays inside its .cpp files.
# QUICK: no inner loop of simulation or drawing is there, so that it is compiled with -O1, in two thirds of the time.
# Without ccache the files of a folder are compiled as one (CAROM_UNITY), but for those that are SEPARATE: their unnamed
# namespaces share names with others of the folder.
function(carom_module name)
    cmake_parse_arguments(arg "QUICK" "" "USES;PRIVATE;SEPARATE;PROGRAM" ${ARGN})
    file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/src/${name}/*.cpp)
    list(TRANSFORM arg_PROGRAM PREPEND ${PROJECT_SOURCE_DIR}/src/${name}/)
    list(REMOVE_ITEM sources ${arg_PROGRAM})
    add_library(carom_${name} STATIC ${sources})
    add_library(carom::${name} ALIAS carom_${name})
    target_include_directories(carom_${name} PUBLIC $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/src>)
    target_link_libraries(carom_${name} PUBLIC ${arg_USES} Threads::Threads
        PRIVATE $<BUILD_INTERFACE:carom_rules> ${arg_PRIVATE})
    if(arg_QUICK)
        target_compile_options(carom_${name} PRIVATE $<$<CONFIG:Release>:-O1>)
    endif()
    if(CAROM_UNITY)
        set_target_properties(carom_${name} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
        list(TRANSFORM arg_SEPARATE PREPEND ${PROJECT_SOURCE_DIR}/src/${name}/)
        list(REMOVE_ITEM sources ${arg_SEPARATE})
        foreach(source IN LISTS sources)
            get_filename_component(folder ${source} DIRECTORY)
            get_filename_component(folder ${folder} NAME)
            set_source_files_properties(${source} PROPERTIES UNITY_GROUP ${folder})
        endforeach()
    endif()
endfunction()
