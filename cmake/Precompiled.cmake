# One precompiled header for everybody: the standard library, fmt and our maths, which nearly every
# file includes anyway and which take longer to parse than most files to compile. Only for the
# builds that people wait for (presets release and ci): without it, as in preset dev, a file must
# include what it uses.
option(PLUMBLINE_PRECOMPILED "Share one precompiled header" OFF)

# plumbline_make_precompiled(NAME [DEFINITIONS ...] [HEADERS ...] [LINKS ...]): HEADERS beside the usual
# ones, with the libraries that they come from.
function(plumbline_make_precompiled name)
    cmake_parse_arguments(ARG "" "" "DEFINITIONS;HEADERS;LINKS" ${ARGN})
    file(WRITE "${CMAKE_BINARY_DIR}/${name}.cpp" "// Nothing: the header is what is wanted.\n")
    add_library(${name} OBJECT "${CMAKE_BINARY_DIR}/${name}.cpp")
    target_compile_features(${name} PUBLIC cxx_std_20)
    set_target_properties(${name} PROPERTIES CXX_EXTENSIONS OFF)
    target_include_directories(${name} PUBLIC "${CMAKE_SOURCE_DIR}")
    target_compile_options(${name} PRIVATE -ffp-contract=off)
    target_compile_definitions(${name} PRIVATE ${ARG_DEFINITIONS})
    target_link_libraries(${name} PUBLIC plumbline::glm fmt::fmt ${ARG_LINKS})
    plumbline_warnings(${name})
    plumbline_sanitizers(${name})
    target_precompile_headers(${name} PRIVATE
        "${CMAKE_SOURCE_DIR}/engine/core/math.h"
        <fmt/format.h>
        <algorithm> <array> <cmath> <cstdint> <filesystem> <functional> <map> <memory> <optional>
        <span> <string> <string_view> <utility> <variant> <vector> ${ARG_HEADERS})
endfunction()

# g++ in these builds collects its garbage once a gigabyte is full, not from 128 MB on: a fifteenth of
# their time.
if(PLUMBLINE_PRECOMPILED AND CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    add_compile_options(
        $<$<COMPILE_LANGUAGE:CXX>:--param=ggc-min-expand=200>
        $<$<COMPILE_LANGUAGE:CXX>:--param=ggc-min-heapsize=1000000>)
endif()

if(PLUMBLINE_PRECOMPILED)
    plumbline_make_precompiled(plumbline_precompiled)
    plumbline_make_precompiled(plumbline_precompiled_f64 DEFINITIONS PL_DOUBLE_PRECISION)
endif()

# plumbline_use_precompiled(TARGET [HEADER]): targets whose name holds f64 take the HEADER (usually the
# one above) with Real as double.
function(plumbline_use_precompiled target)
    if(NOT PLUMBLINE_PRECOMPILED)
        return()
    endif()
    set(header plumbline_precompiled ${ARGN})
    list(GET header -1 header)
    if(target MATCHES "f64")
        string(APPEND header _f64)
    endif()
    target_precompile_headers(${target} REUSE_FROM ${header})
endfunction()
