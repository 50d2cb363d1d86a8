# `simulate` in both precisions: a library for the program plumbline, and plumbline-f64 as a whole.
# What it prints about the command line does not depend on the precision.
add_library(plumbline_command_docs STATIC command_line/command_docs.h command_line/command_docs.cpp)
plumbline_target_settings(plumbline_command_docs)
target_link_libraries(plumbline_command_docs PRIVATE CLI11::CLI11)

string(TOUPPER "${CMAKE_BUILD_TYPE}" type)
string(STRIP "${CMAKE_CXX_FLAGS} ${CMAKE_CXX_FLAGS_${type}} -ffp-contract=off" plumbline_build_flags)
foreach(suffix "" "_f64")
    set(target plumbline_simulate${suffix})
    add_library(${target} STATIC
        program.h program.cpp
        command_line/option_ranges.h command_line/option_ranges.cpp
        command_line/parse_error.h command_line/parse_error.cpp
        command_line/program_words.h command_line/program_words.cpp
        command_line/refuse.h
        command_line/threads_option.h command_line/threads_option.cpp
        commands/simulate_cli.h commands/simulate_cli.cpp
        commands/simulate_command.h commands/simulate_command.cpp)
    plumbline_target_settings(${target})
    target_compile_definitions(${target} PRIVATE PL_VERSION="${PROJECT_VERSION}"
        PL_BULLET_VERSION="${BULLET_VERSION}" PL_BUILD_FLAGS="${plumbline_build_flags}")
    target_link_libraries(${target} PUBLIC plumbline::effects${suffix} PRIVATE plumbline::study${suffix} plumbline_command_docs CLI11::CLI11)
endforeach()
target_compile_options(plumbline_simulate_f64 PRIVATE
    $<$<COMPILE_LANG_AND_ID:CXX,GNU>:-Wno-useless-cast>)

add_executable(plumbline-f64 main_f64.cpp)
plumbline_target_settings(plumbline-f64)
target_link_libraries(plumbline-f64 PRIVATE plumbline_simulate_f64 plumbline::study_f64 CLI11::CLI11)
plumbline_rarely_run(plumbline_command_docs plumbline_simulate plumbline_simulate_f64 plumbline-f64)
