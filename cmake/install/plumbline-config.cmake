# plumbline::physics and plumbline::bullet_world; those with _f64 compute in double precision.
foreach(component IN LISTS plumbline_FIND_COMPONENTS)
    if(NOT component MATCHES "^(physics|bullet_world)$")
        set(plumbline_FOUND FALSE)
        set(plumbline_NOT_FOUND_MESSAGE "plumbline has no component ${component}; known: physics, bullet_world")
        return()
    endif()
endforeach()
if(TARGET plumbline::physics)  # found before
    return()
endif()
include("${CMAKE_CURRENT_LIST_DIR}/PhysicsDependencies.cmake")
include("${CMAKE_CURRENT_LIST_DIR}/plumbline-targets.cmake")
