# plumbline_module(NAME [F64|ANY_PRECISION] FILES ... [FILES_F64 ...] [DEPENDS modules ...]
#                  [PRIVATE targets ...] [PRIVATE_F64 targets ...])
#
# Makes the static library plumbline_NAME. With F64 it also makes plumbline_NAME_f64, the same files
# (or FILES_F64: those that plumbline-f64 needs) with core/math.h's Real as double. With ANY_PRECISION
# no source of it depends on Real, which architecture.precision checks, and both programs link the
# one library. PRIVATE libraries never reach those who link the module.

include(Warnings)
include(Sanitizers)
include(Precompiled)

find_program(CCACHE_PROGRAM ccache)
if(CCACHE_PROGRAM)
    set(CMAKE_CXX_COMPILER_LAUNCHER "${CCACHE_PROGRAM}")
    set(CMAKE_C_COMPILER_LAUNCHER "${CCACHE_PROGRAM}")
endif()

function(plumbline_target_settings target)
    target_compile_features(${target} PUBLIC cxx_std_20)
    set_target_properties(${target} PROPERTIES CXX_EXTENSIONS OFF)
    target_include_directories(${target} PUBLIC "$<BUILD_INTERFACE:${CMAKE_SOURCE_DIR}>")
    # The same numbers on every build: no fused multiply-add behind our back.
    target_compile_options(${target} PRIVATE -ffp-contract=off)
    plumbline_warnings(${target})
    plumbline_sanitizers(${target})
    target_link_libraries(${target} PUBLIC plumbline::glm fmt::fmt)
    plumbline_use_precompiled(${target})
endfunction()

# For what is not in the inner loop of a step or a frame: -O1 compiles in two thirds of the time.
function(plumbline_rarely_run)
    foreach(target IN LISTS ARGN)
        target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:-O1>)
    endforeach()
endfunction()

# For a module of the innermost loops of a step: -O3 takes a fifteenth off them. Results keep their
# bits, as neither level reorders sums. Without the precompiled header: g++ 12 crashes on one of
# another level.
function(plumbline_inner_loops target)
    target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:-O3>)
    set_target_properties(${target} PROPERTIES DISABLE_PRECOMPILE_HEADERS ON)
endfunction()

# Static; with BUILD_SHARED_LIBS the libraries that are installed (install/Library.cmake) are shared.
function(plumbline_library target)
    set(kind STATIC)
    if(BUILD_SHARED_LIBS AND target MATCHES "^plumbline_(core|physics|bullet_world)(_f64)?$")
        set(kind SHARED)
    endif()
    add_library(${target} ${kind} ${ARGN})
    set_target_properties(${target} PROPERTIES
        LINKER_LANGUAGE CXX VERSION ${PROJECT_VERSION} SOVERSION ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR}
        INSTALL_RPATH "$ORIGIN")
endfunction()

function(plumbline_module name)
    cmake_parse_arguments(ARG "F64;ANY_PRECISION" "" "FILES;FILES_F64;DEPENDS;PRIVATE;PRIVATE_F64" ${ARGN})
    plumbline_library(plumbline_${name} ${ARG_FILES})
    add_library(plumbline::${name} ALIAS plumbline_${name})
    plumbline_target_settings(plumbline_${name})
    foreach(dependency IN LISTS ARG_DEPENDS)
        target_link_libraries(plumbline_${name} PUBLIC plumbline::${dependency})
    endforeach()
    target_link_libraries(plumbline_${name} PRIVATE ${ARG_PRIVATE})

    if(ARG_ANY_PRECISION)
        add_library(plumbline_${name}_f64 INTERFACE)
        add_library(plumbline::${name}_f64 ALIAS plumbline_${name}_f64)
        target_compile_definitions(plumbline_${name}_f64 INTERFACE PL_DOUBLE_PRECISION)
        target_link_libraries(plumbline_${name}_f64 INTERFACE plumbline_${name})
    endif()
    if(ARG_F64)
        set(files ${ARG_FILES})
        if(ARG_FILES_F64)
            set(files ${ARG_FILES_F64})
        endif()
        plumbline_library(plumbline_${name}_f64 ${files})
        add_library(plumbline::${name}_f64 ALIAS plumbline_${name}_f64)
        plumbline_target_settings(plumbline_${name}_f64)
        target_compile_definitions(plumbline_${name}_f64 PUBLIC PL_DOUBLE_PRECISION)
        plumbline_no_conversion_warnings(plumbline_${name}_f64)
        foreach(dependency IN LISTS ARG_DEPENDS)
            if(TARGET plumbline_${dependency}_f64)
                target_link_libraries(plumbline_${name}_f64 PUBLIC plumbline::${dependency}_f64)
            endif()
        endforeach()
        if(ARG_PRIVATE_F64)
            target_link_libraries(plumbline_${name}_f64 PRIVATE ${ARG_PRIVATE_F64})
        else()
            target_link_libraries(plumbline_${name}_f64 PRIVATE ${ARG_PRIVATE})
        endif()
    endif()
endfunction()
