# plumbline::physics, and plumbline::physics_f64 with Real as double.
foreach(component IN LISTS plumbline_FIND_COMPONENTS)
    if(NOT component STREQUAL physics)
        set(plumbline_FOUND FALSE)
        set(plumbline_NOT_FOUND_MESSAGE "plumbline has no component ${component}; known: physics")
        return()
    endif()
endforeach()
if(TARGET plumbline::physics)  # found before
    return()
endif()
include("${CMAKE_CURRENT_LIST_DIR}/PhysicsDependencies.cmake")
include("${CMAKE_CURRENT_LIST_DIR}/plumbline-targets.cmake")
