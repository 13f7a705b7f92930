# Installs the simulation core for other programs: find_package(carom CONFIG) provides
# carom::physics. Only the public headers listed here are installed, together with the libraries
# that they need. Headers go to include/carom, so that their includes of each other work as in src/.
include(CMakePackageConfigHelpers)
set(package_folder ${CMAKE_INSTALL_LIBDIR}/cmake/carom)

set(public_headers_of_util archive.h diagnostics.h interrupt.h overloaded.h)
set(public_headers_of_physics
    advance_result.h box.h collision/velocity_changes.h exact_positions.h gas.h particles.h placement/placement.h placement/problem.h reversal/precision.h run.h simulation.h surface.h surfaces/behaviours.h
    surfaces/surface_problem.h temperature.h theory/theory.h value_rule.h vec.h ways_back.h)
foreach(module util physics)
    list(TRANSFORM public_headers_of_${module} PREPEND ${PROJECT_SOURCE_DIR}/src/${module}/)
    target_sources(carom_${module} PUBLIC FILE_SET HEADERS BASE_DIRS ${PROJECT_SOURCE_DIR}/src FILES ${public_headers_of_${module}})
    set_target_properties(carom_${module} PROPERTIES EXPORT_NAME ${module})
    target_compile_features(carom_${module} PUBLIC cxx_std_20)
endforeach()
# For #include <carom/physics/simulation.h> in user code; the file set provides the path for
# "physics/gas.h" inside the headers.
target_include_directories(carom_physics INTERFACE $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
# Arrays may be allocated in the library and freed in user code, so both must use the same allocator
# of Eigen: by default it depends on -march and on sanitizers. It is a definition of the lowest
# module, so that all have it, and the libraries of their LOOPS, too.
target_compile_definitions(carom_util PUBLIC EIGEN_MAX_ALIGN_BYTES=64)

install(TARGETS carom_util carom_physics EXPORT carom
    ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT development
    FILE_SET HEADERS DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/carom COMPONENT development)
install(EXPORT carom NAMESPACE carom:: FILE carom-targets.cmake DESTINATION ${package_folder} COMPONENT development)

configure_package_config_file(cmake/carom-config.cmake.in ${PROJECT_BINARY_DIR}/carom-config.cmake
    INSTALL_DESTINATION ${package_folder} NO_SET_AND_CHECK_MACRO)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/carom-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/carom-config.cmake ${PROJECT_BINARY_DIR}/carom-config-version.cmake
    DESTINATION ${package_folder} COMPONENT development)
