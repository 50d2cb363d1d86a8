# Finds each library once; wraps those without a CMake target of their own in an imported one.
# Everything comes from system packages (cmake/packages.txt); nothing is downloaded.
include(PhysicsDependencies)
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
pkg_check_modules(IMGUI REQUIRED IMPORTED_TARGET imgui)
pkg_check_modules(EGL REQUIRED IMPORTED_TARGET egl)

# Another engine that scenes are compared with; without it `study --engines` has the others.
pkg_check_modules(ODE IMPORTED_TARGET ode)

if(PLUMBLINE_TESTS)
    find_package(GTest REQUIRED)
    find_package(benchmark REQUIRED)
    # The narrow phase is held against it; without it one test is left out.
    pkg_check_modules(CCD IMPORTED_TARGET ccd)
endif()
