# carom_module(NAME [QUICK] USES targets... PRIVATE targets... PROGRAM files... LOOPS files... UNITS
# "paths..."...):
# adds the static library of src/NAME, without the files listed as PROGRAM.
# USES: libraries that its headers may expose. PRIVATE: libraries used only in its .cpp files.
# QUICK: it has no inner loop of simulation or drawing and is compiled with little optimisation
# (carom_quick_options).
# LOOPS: files of a QUICK module with inner loops: each takes more than about 1 % of the instructions
# of a run or a film. These are compiled with -O3, in a unity build as one unit.
# UNITS: without ccache (CAROM_UNITY) the files of several folders are compiled as one unit, in half
# the time. Each entry lists folders of src/NAME (. is src/NAME itself) and single files; a folder
# that is in no entry is a unit of its own. Names in unnamed namespaces must be unique within a
# unit: where two files use the same name for good reason, one of them is put into another unit.
function(carom_module name)
    cmake_parse_arguments(arg "QUICK" "" "USES;PRIVATE;PROGRAM;LOOPS;UNITS" ${ARGN})
    file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/src/${name}/*.cpp)
    list(TRANSFORM arg_PROGRAM PREPEND ${PROJECT_SOURCE_DIR}/src/${name}/)
    list(REMOVE_ITEM sources ${arg_PROGRAM})
    list(TRANSFORM arg_LOOPS PREPEND ${PROJECT_SOURCE_DIR}/src/${name}/)
    list(REMOVE_ITEM sources ${arg_LOOPS})
    set(libraries carom_${name})
    set(loops)
    if(arg_LOOPS)
        add_library(carom_${name}_loops OBJECT ${arg_LOOPS})
        set_target_properties(carom_${name}_loops PROPERTIES UNITY_BUILD "${CAROM_UNITY}" UNITY_BUILD_BATCH_SIZE 0)
        list(APPEND libraries carom_${name}_loops)
        set(loops $<TARGET_OBJECTS:carom_${name}_loops>)
    endif()
    # Loops first: of an inline function that is compiled in several units, the linker takes the first.
    add_library(carom_${name} STATIC ${loops} ${sources})
    add_library(carom::${name} ALIAS carom_${name})
    foreach(library IN LISTS libraries)
        target_include_directories(${library} PUBLIC $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/src>)
        target_link_libraries(${library} PUBLIC ${arg_USES} Threads::Threads
            PRIVATE $<BUILD_INTERFACE:carom_rules> ${arg_PRIVATE})
    endforeach()
    if(arg_QUICK)
        target_compile_options(carom_${name} PRIVATE ${carom_quick_options})
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
            foreach(wanted IN ITEMS ${folder} ${path})  # a file's entry overrides its folder's
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
