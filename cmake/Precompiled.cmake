# One precompiled header for everybody: the standard library, fmt and our maths, which nearly every
# file includes anyway and which take longer to parse than most files to compile. Only for the
# builds that people wait for (presets release and ci): without it, as in preset dev, a file must
# include what it uses.
option(PLUMBLINE_PRECOMPILED "Share one precompiled header" OFF)

function(plumbline_make_precompiled name)
    file(WRITE "${CMAKE_BINARY_DIR}/${name}.cpp" "// Nothing: the header is what is wanted.\n")
    add_library(${name} OBJECT "${CMAKE_BINARY_DIR}/${name}.cpp")
    target_compile_features(${name} PUBLIC cxx_std_20)
    set_target_properties(${name} PROPERTIES CXX_EXTENSIONS OFF)
    target_include_directories(${name} PUBLIC "${CMAKE_SOURCE_DIR}")
    target_compile_options(${name} PRIVATE -ffp-contract=off)
    target_compile_definitions(${name} PRIVATE ${ARGN})
    target_link_libraries(${name} PUBLIC glm::glm fmt::fmt)
    plumbline_warnings(${name})
    plumbline_sanitizers(${name})
    target_precompile_headers(${name} PRIVATE
        "${CMAKE_SOURCE_DIR}/engine/core/math.h"
        <fmt/format.h>
        <algorithm> <array> <cmath> <cstdint> <filesystem> <functional> <map> <memory> <optional>
        <span> <string> <string_view> <utility> <variant> <vector>)
endfunction()

if(PLUMBLINE_PRECOMPILED)
    plumbline_make_precompiled(plumbline_precompiled)
    plumbline_make_precompiled(plumbline_precompiled_f64 PL_DOUBLE_PRECISION)
endif()

# Targets whose name holds f64 take the one with Real as double.
function(plumbline_use_precompiled target)
    if(NOT PLUMBLINE_PRECOMPILED)
        return()
    endif()
    if(target MATCHES "f64")
        target_precompile_headers(${target} REUSE_FROM plumbline_precompiled_f64)
    else()
        target_precompile_headers(${target} REUSE_FROM plumbline_precompiled)
    endif()
endfunction()
