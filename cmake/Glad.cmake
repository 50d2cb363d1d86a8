# Generates the OpenGL loader offline from the registry file that Debian's python3-glad carries.
# The system's own interpreter: another python3 earlier in PATH would lack the module.
set(GLAD_DIR "${CMAKE_BINARY_DIR}/glad")
add_custom_command(
    OUTPUT "${GLAD_DIR}/src/gl.c" "${GLAD_DIR}/include/glad/gl.h"
    COMMAND /usr/bin/python3 -m glad --reproducible --api gl:core=3.3
            --extensions GL_KHR_debug,GL_ARB_timer_query,GL_EXT_texture_filter_anisotropic
            --out-path "${GLAD_DIR}" c
    COMMENT "Generating the OpenGL loader"
    VERBATIM)
add_library(glad STATIC "${GLAD_DIR}/src/gl.c" "${GLAD_DIR}/include/glad/gl.h")
target_include_directories(glad SYSTEM PUBLIC "${GLAD_DIR}/include")
target_link_libraries(glad PUBLIC ${CMAKE_DL_LIBS})
