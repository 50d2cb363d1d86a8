# `simulate` in both precisions: a library for the program plumbline, and plumbline-f64 as a whole.
foreach(suffix "" "_f64")
    set(target plumbline_simulate${suffix})
    add_library(${target} STATIC
        parse_error.h parse_error.cpp
        simulate_cli.h simulate_cli.cpp
        simulate_command.h simulate_command.cpp)
    plumbline_target_settings(${target})
    target_compile_definitions(${target} PRIVATE PL_VERSION="${PROJECT_VERSION}")
    target_link_libraries(${target} PUBLIC plumbline::effects${suffix} PRIVATE plumbline::study${suffix} CLI11::CLI11)
endforeach()
target_compile_options(plumbline_simulate_f64 PRIVATE -Wno-useless-cast)

add_executable(plumbline-f64 main_f64.cpp)
plumbline_target_settings(plumbline-f64)
target_link_libraries(plumbline-f64 PRIVATE plumbline_simulate_f64 plumbline::study_f64 CLI11::CLI11)
