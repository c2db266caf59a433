# Headers that most sources include and that take long to parse, compiled once for many targets.
# -DCMAKE_DISABLE_PRECOMPILE_HEADERS=ON builds without; then a source that misses an include does not compile. So does a build
# with ccache, which does not cache what uses a precompiled header.
if(CMAKE_CXX_COMPILER_LAUNCHER MATCHES ccache)
    set(CMAKE_DISABLE_PRECOMPILE_HEADERS ON)
endif()

set(standard_headers <algorithm> <array> <cmath> <filesystem> <functional> <map> <numeric> <optional> <span> <sstream> <string> <variant> <vector>)

# weavefront_precompiled(NAME HEADERS headers... USES targets...): what precompile_like(target NAME) takes over.
# All targets of one name define the same macros for these headers.
function(weavefront_precompiled name)
    cmake_parse_arguments(ARG "" "" "HEADERS;USES" ${ARGN})
    add_library(precompiled_${name} OBJECT ${PROJECT_SOURCE_DIR}/cmake/precompiled.cpp)
    target_link_libraries(precompiled_${name} PRIVATE weavefront_options ${ARG_USES})
    target_precompile_headers(precompiled_${name} PRIVATE ${standard_headers} ${ARG_HEADERS})
endfunction()

# Gives a target the precompiled headers of a name.
function(precompile_like target name)
    target_precompile_headers(${target} REUSE_FROM precompiled_${name})
endfunction()

weavefront_precompiled(eigen HEADERS <Eigen/Core> USES Eigen3::Eigen)
weavefront_precompiled(fmt HEADERS <Eigen/Core> <fmt/format.h> <fmt/ranges.h> USES Eigen3::Eigen fmt::fmt)
