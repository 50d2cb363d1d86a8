# Finds each library once; wraps those without a CMake target of their own in an imported one.
# Everything comes from system packages (cmake/packages.txt); nothing is downloaded.
find_package(PkgConfig REQUIRED)
find_package(Threads REQUIRED)
find_package(fmt REQUIRED)
find_package(spdlog REQUIRED)
find_package(glfw3 3.3 REQUIRED)
find_package(PNG REQUIRED)
find_package(JPEG REQUIRED)
find_package(OpenEXR REQUIRED)
find_package(tomlplusplus REQUIRED)
find_package(nlohmann_json REQUIRED)
find_package(CLI11 REQUIRED)
find_package(OpenAL REQUIRED)
find_package(embree 3 REQUIRED)
find_package(meshoptimizer REQUIRED)

pkg_check_modules(ASSIMP REQUIRED IMPORTED_TARGET assimp)
pkg_check_modules(SNDFILE REQUIRED IMPORTED_TARGET sndfile)
pkg_check_modules(XXHASH REQUIRED IMPORTED_TARGET libxxhash)
pkg_check_modules(IMGUI REQUIRED IMPORTED_TARGET imgui)
pkg_check_modules(EGL REQUIRED IMPORTED_TARGET egl)

find_path(GLM_INCLUDE_DIR glm/glm.hpp REQUIRED)
add_library(glm::glm INTERFACE IMPORTED)
target_include_directories(glm::glm SYSTEM INTERFACE "${GLM_INCLUDE_DIR}")
# Depth, angles and aliasing rules said once for everyone who includes GLM.
target_compile_definitions(glm::glm INTERFACE
    GLM_FORCE_SILENT_WARNINGS GLM_ENABLE_EXPERIMENTAL GLM_FORCE_XYZW_ONLY)

# Bullet in both precisions. The dynamics part only: no soft bodies, no OpenCL.
find_path(BULLET_INCLUDE_DIR btBulletDynamicsCommon.h PATH_SUFFIXES bullet REQUIRED)
pkg_check_modules(BULLET REQUIRED bullet)  # for its version
foreach(suffix "" "-float64")
    set(target "bullet${suffix}")
    add_library(${target} INTERFACE IMPORTED)
    target_include_directories(${target} SYSTEM INTERFACE "${BULLET_INCLUDE_DIR}")
    foreach(part BulletDynamics BulletCollision LinearMath)
        find_library(LIB_${part}${suffix} "${part}${suffix}" REQUIRED)
        target_link_libraries(${target} INTERFACE "${LIB_${part}${suffix}}")
    endforeach()
endforeach()
target_compile_definitions(bullet-float64 INTERFACE BT_USE_DOUBLE_PRECISION)

# Another engine that scenes are compared with; without it `study --engines` has the others.
pkg_check_modules(ODE IMPORTED_TARGET ode)

if(PLUMBLINE_TESTS)
    find_package(GTest REQUIRED)
    find_package(benchmark REQUIRED)
endif()
