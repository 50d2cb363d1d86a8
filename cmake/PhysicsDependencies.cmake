# What core and physics need: of this build, and of whoever uses them as an installed library.
find_package(PkgConfig REQUIRED)
find_package(Threads REQUIRED)
find_package(fmt REQUIRED)
find_package(spdlog REQUIRED)
pkg_check_modules(XXHASH REQUIRED IMPORTED_TARGET libxxhash)

find_path(GLM_INCLUDE_DIR glm/glm.hpp REQUIRED)
add_library(plumbline::glm INTERFACE IMPORTED)  # our name: a project may have one of its own
target_include_directories(plumbline::glm SYSTEM INTERFACE "${GLM_INCLUDE_DIR}")
# Depth, angles and aliasing rules said once for everyone who includes GLM.
target_compile_definitions(plumbline::glm INTERFACE
    GLM_FORCE_SILENT_WARNINGS GLM_ENABLE_EXPERIMENTAL GLM_FORCE_XYZW_ONLY)

# Bullet in both precisions. The dynamics part only: no soft bodies, no OpenCL.
find_path(BULLET_INCLUDE_DIR btBulletDynamicsCommon.h PATH_SUFFIXES bullet REQUIRED)
pkg_check_modules(BULLET REQUIRED bullet)  # for its version
foreach(suffix "" "-float64")
    set(target "plumbline::bullet${suffix}")
    add_library(${target} INTERFACE IMPORTED)
    target_include_directories(${target} SYSTEM INTERFACE "${BULLET_INCLUDE_DIR}")
    foreach(part BulletDynamics BulletCollision LinearMath)
        find_library(LIB_${part}${suffix} "${part}${suffix}" REQUIRED)
        target_link_libraries(${target} INTERFACE "${LIB_${part}${suffix}}")
    endforeach()
endforeach()
target_compile_definitions(plumbline::bullet-float64 INTERFACE BT_USE_DOUBLE_PRECISION)
