# carom_module(NAME USES targets... PRIVATE targets...): the static library of src/NAME.
# USES is what its headers may show; PRIVATE stays inside its .cpp files.
function(carom_module name)
    cmake_parse_arguments(arg "" "" "USES;PRIVATE" ${ARGN})
    file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/src/${name}/*.cpp)
    list(FILTER sources EXCLUDE REGEX "/main\\.cpp$")
    add_library(carom_${name} STATIC ${sources})
    add_library(carom::${name} ALIAS carom_${name})
    target_include_directories(carom_${name} PUBLIC $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/src>)
    target_link_libraries(carom_${name} PUBLIC ${arg_USES} Threads::Threads
        PRIVATE $<BUILD_INTERFACE:carom_rules> ${arg_PRIVATE})
endfunction()
