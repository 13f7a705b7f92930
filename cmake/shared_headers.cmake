# carom_share_headers(TARGET): compiles the target with headers that most units include, which are
# precompiled once for all such targets: 1.4 s less for each unit. The target must be compiled with
# carom_quick_options and link carom::util, as GCC refuses a precompiled header whose options and
# definitions differ. Only units of several files (CAROM_UNITY) use them: elsewhere every file is
# compiled with what it includes itself, so that a missing include is found, and ccache can tell
# whether a header has changed.
set(carom_shares_headers OFF)
if(CAROM_UNITY AND NOT CCACHE AND NOT carom_sanitizers AND NOT CMAKE_CXX_CLANG_TIDY AND CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    set(carom_shares_headers ON)
    file(CONFIGURE OUTPUT ${PROJECT_BINARY_DIR}/shared_headers.cpp CONTENT "// Only its headers are used.\n")
    add_library(carom_shared_headers OBJECT EXCLUDE_FROM_ALL ${PROJECT_BINARY_DIR}/shared_headers.cpp)
    target_link_libraries(carom_shared_headers PRIVATE carom_rules carom::util Eigen3::Eigen)
    target_compile_options(carom_shared_headers PRIVATE ${carom_quick_options})
    target_precompile_headers(carom_shared_headers PRIVATE
        <algorithm> <array> <cmath> <cstddef> <cstdint> <filesystem> <functional> <limits> <map> <memory>
        <numbers> <numeric> <optional> <set> <span> <sstream> <stdexcept> <string> <string_view>
        <system_error> <utility> <variant> <vector> <Eigen/Core> <fmt/format.h> <fmt/ranges.h>)
endif()
function(carom_share_headers target)
    if(carom_shares_headers)
        target_precompile_headers(${target} REUSE_FROM carom_shared_headers)
    endif()
endfunction()
