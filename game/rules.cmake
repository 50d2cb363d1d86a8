# The game's own rules, as a library so that tests can link them.
add_library(plumbline_rules STATIC
    "${CMAKE_CURRENT_LIST_DIR}/rules/aim.h"
    "${CMAKE_CURRENT_LIST_DIR}/rules/camera_rig.cpp"
    "${CMAKE_CURRENT_LIST_DIR}/rules/camera_rig.h"
    "${CMAKE_CURRENT_LIST_DIR}/components.h"
    "${CMAKE_CURRENT_LIST_DIR}/rules/goal.cpp"
    "${CMAKE_CURRENT_LIST_DIR}/rules/goal.h"
    "${CMAKE_CURRENT_LIST_DIR}/rules/grab.cpp"
    "${CMAKE_CURRENT_LIST_DIR}/rules/grab.h"
    "${CMAKE_CURRENT_LIST_DIR}/rules/placement.cpp"
    "${CMAKE_CURRENT_LIST_DIR}/rules/placement.h"
    "${CMAKE_CURRENT_LIST_DIR}/rules/player.cpp"
    "${CMAKE_CURRENT_LIST_DIR}/rules/player.h"
    "${CMAKE_CURRENT_LIST_DIR}/rules/rules.cpp"
    "${CMAKE_CURRENT_LIST_DIR}/rules/rules.h"
    "${CMAKE_CURRENT_LIST_DIR}/rules/rules_archive.cpp"
    "${CMAKE_CURRENT_LIST_DIR}/rules/rules_forces.cpp"
    "${CMAKE_CURRENT_LIST_DIR}/rules/rules_light.cpp"
    "${CMAKE_CURRENT_LIST_DIR}/rules/rules_viewer.cpp"
    "${CMAKE_CURRENT_LIST_DIR}/rules/rules_things.cpp"
    "${CMAKE_CURRENT_LIST_DIR}/rules/things.cpp"
    "${CMAKE_CURRENT_LIST_DIR}/rules/things.h"
    "${CMAKE_CURRENT_LIST_DIR}/rules/rules_use.cpp"
    "${CMAKE_CURRENT_LIST_DIR}/rules/use.cpp"
    "${CMAKE_CURRENT_LIST_DIR}/rules/use.h")
plumbline_target_settings(plumbline_rules)
target_link_libraries(plumbline_rules PUBLIC plumbline::scene)
