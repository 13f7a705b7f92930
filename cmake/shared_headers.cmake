# carom_share_headers(TARGET): compiles the target with headers that most units include, which are
# precompiled once for all such targets: 1.4 s less for each unit, and 1.2 s more where it includes
# JSON. The target must be compiled with carom_quick_options: GCC takes the options of optimisation
# from the precompiled header, and refuses one whose definitions differ. Only units of several files
# (CAROM_UNITY) use them: elsewhere every file is compiled with what it includes itself, so that a
# missing include is found, and ccache can tell whether a header has changed.
set(carom_shares_headers OFF)
if(CAROM_UNITY AND NOT CCACHE AND NOT carom_sanitizers AND NOT CMAKE_CXX_CLANG_TIDY AND CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    set(carom_shares_headers ON)
    file(CONFIGURE OUTPUT ${PROJECT_BINARY_DIR}/shared_headers.cpp CONTENT "// Only its headers are used.\n")
    add_library(carom_shared_headers OBJECT EXCLUDE_FROM_ALL ${PROJECT_BINARY_DIR}/shared_headers.cpp)
    target_compile_options(carom_rules INTERFACE -pthread)  # as those with Pango have it, which defines a macro
    target_link_libraries(carom_shared_headers PRIVATE carom_rules fmt::fmt Eigen3::Eigen nlohmann_json::nlohmann_json)
    target_compile_options(carom_shared_headers PRIVATE ${carom_quick_options})
    target_compile_definitions(carom_shared_headers PRIVATE $<TARGET_PROPERTY:carom_util,INTERFACE_COMPILE_DEFINITIONS>)
    target_precompile_headers(carom_shared_headers PRIVATE
        <algorithm> <array> <charconv> <cmath> <cstddef> <cstdint> <filesystem> <fstream> <functional> <limits> <map>
        <memory> <mutex> <numbers> <numeric> <optional> <set> <span> <sstream> <stdexcept> <string> <string_view>
        <system_error> <thread> <utility> <variant> <vector>
        <Eigen/Core> <fmt/format.h> <fmt/ranges.h> <nlohmann/json.hpp>)
endif()
function(carom_share_headers target)
    if(carom_shares_headers)
        target_precompile_headers(${target} REUSE_FROM carom_shared_headers)
    endif()
endfunction()
