# The physics as a library, and our world for Bullet programs: find_package(plumbline COMPONENTS physics bullet_world), or pkg-config. docs/LIBRARY.md.
include(CMakePackageConfigHelpers)

set(targets plumbline_core plumbline_core_f64 plumbline_physics plumbline_physics_f64
    plumbline_bullet_world plumbline_bullet_world_f64)
foreach(target IN LISTS targets)
    string(REPLACE plumbline_ "" name ${target})
    set_target_properties(${target} PROPERTIES EXPORT_NAME ${name})
endforeach()
install(TARGETS ${targets} EXPORT plumbline-targets
    ARCHIVE DESTINATION "${CMAKE_INSTALL_LIBDIR}" COMPONENT library
    LIBRARY DESTINATION "${CMAKE_INSTALL_LIBDIR}" COMPONENT library
    INCLUDES DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}/plumbline")
if(BUILD_SHARED_LIBS)
    set_target_properties(plumbline plumbline-f64 PROPERTIES INSTALL_RPATH "$ORIGIN/../${CMAKE_INSTALL_LIBDIR}")
endif()

# The public headers of physics, which lie in its root, and core's.
set(headers "${CMAKE_INSTALL_INCLUDEDIR}/plumbline/engine")
install(DIRECTORY engine/core DESTINATION "${headers}" COMPONENT library
    FILES_MATCHING PATTERN "*.h" PATTERN "*_impl.h" EXCLUDE)
file(GLOB physics_headers CONFIGURE_DEPENDS engine/physics/*.h)
install(FILES ${physics_headers} DESTINATION "${headers}/physics" COMPONENT library)
install(FILES engine/bullet_world/small_step_dynamics_world.h DESTINATION "${headers}/bullet_world" COMPONENT library)

set(package "${CMAKE_INSTALL_LIBDIR}/cmake/plumbline")
install(EXPORT plumbline-targets NAMESPACE plumbline:: DESTINATION "${package}" COMPONENT library)
write_basic_package_version_file("${CMAKE_BINARY_DIR}/install/plumbline-config-version.cmake"
    COMPATIBILITY SameMinorVersion)
install(FILES
    cmake/install/plumbline-config.cmake
    cmake/PhysicsDependencies.cmake
    "${CMAKE_BINARY_DIR}/install/plumbline-config-version.cmake"
    DESTINATION "${package}" COMPONENT library)

# The folders as seen from that of the pkg-config files, whatever their names.
set(pkgconfig "${CMAKE_INSTALL_LIBDIR}/pkgconfig")
file(RELATIVE_PATH includes "/${pkgconfig}" "/${CMAKE_INSTALL_INCLUDEDIR}/plumbline")
foreach(suffix "" _f64)
    set(double "")
    set(bullet "-lBulletDynamics -lBulletCollision -lLinearMath")
    if(suffix)
        set(double "-DPL_DOUBLE_PRECISION -DBT_USE_DOUBLE_PRECISION")
        set(bullet "-lBulletDynamics-float64 -lBulletCollision-float64 -lLinearMath-float64")
    endif()
    foreach(name plumbline-physics plumbline-bullet-world)
        set(file "${CMAKE_BINARY_DIR}/install/${name}${suffix}.pc")
        configure_file(cmake/install/${name}.pc.in "${file}" @ONLY)
        install(FILES "${file}" DESTINATION "${pkgconfig}" COMPONENT library)
    endforeach()
endforeach()
