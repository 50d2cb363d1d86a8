# The game's own rules, as a library so that tests can link them.
add_library(plumbline_rules STATIC
    "${CMAKE_CURRENT_LIST_DIR}/aim.h"
    "${CMAKE_CURRENT_LIST_DIR}/camera_rig.cpp"
    "${CMAKE_CURRENT_LIST_DIR}/camera_rig.h"
    "${CMAKE_CURRENT_LIST_DIR}/components.h"
    "${CMAKE_CURRENT_LIST_DIR}/goal.cpp"
    "${CMAKE_CURRENT_LIST_DIR}/goal.h"
    "${CMAKE_CURRENT_LIST_DIR}/grab.cpp"
    "${CMAKE_CURRENT_LIST_DIR}/grab.h"
    "${CMAKE_CURRENT_LIST_DIR}/placement.cpp"
    "${CMAKE_CURRENT_LIST_DIR}/placement.h"
    "${CMAKE_CURRENT_LIST_DIR}/player.cpp"
    "${CMAKE_CURRENT_LIST_DIR}/player.h"
    "${CMAKE_CURRENT_LIST_DIR}/rules.cpp"
    "${CMAKE_CURRENT_LIST_DIR}/rules.h"
    "${CMAKE_CURRENT_LIST_DIR}/rules_archive.cpp"
    "${CMAKE_CURRENT_LIST_DIR}/rules_forces.cpp"
    "${CMAKE_CURRENT_LIST_DIR}/rules_light.cpp"
    "${CMAKE_CURRENT_LIST_DIR}/rules_viewer.cpp"
    "${CMAKE_CURRENT_LIST_DIR}/rules_things.cpp"
    "${CMAKE_CURRENT_LIST_DIR}/things.cpp"
    "${CMAKE_CURRENT_LIST_DIR}/things.h")
plumbline_target_settings(plumbline_rules)
target_link_libraries(plumbline_rules PUBLIC plumbline::scene)
