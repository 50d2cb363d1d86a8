# `cpack --preset package`: a .deb of what Install.cmake puts in place.
set(CPACK_GENERATOR DEB)
# The program, without the library.
set(CPACK_INSTALL_CMAKE_PROJECTS "${CMAKE_BINARY_DIR};plumbline;Unspecified;/")
set(CPACK_PACKAGE_NAME plumbline)
# As the licence names them; the project has no address.
set(CPACK_PACKAGE_CONTACT "The Plumbline authors")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "physics playground with measurable accuracy")
set(CPACK_PACKAGE_DESCRIPTION
"Walk through a garden with a flashlight; drop, grab, throw, freeze and stack
objects in a rigid-body simulation. Run any scene at several accuracy settings
and compare error and CPU time with a reference, on screen or in a report. A
gallery of hard cases can be walked into, or run without a window.")
set(CPACK_PACKAGE_DIRECTORY "${CMAKE_BINARY_DIR}/package")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_SET_DESTDIR OFF)

set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION education)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
# Loaded by name at run time, so that shlibdeps does not see it.
set(CPACK_DEBIAN_PACKAGE_DEPENDS "libgl1")
# OpenAL Soft and GL load their drivers by name; without them there is silence, or no image.
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "fonts-dejavu-core, libasound2, libgl1-mesa-dri, libpulse0")
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION TRUE)

# Debian's policy wants both of every package.
file(READ "${CMAKE_SOURCE_DIR}/LICENSE" licence)
file(WRITE "${CMAKE_BINARY_DIR}/install/copyright" "Plumbline\n\n${licence}\nModels, sounds and images: CREDITS.md in this folder.\n")
file(WRITE "${CMAKE_BINARY_DIR}/install/changelog"
"plumbline (${PROJECT_VERSION}) unstable; urgency=medium

  * See the history of the sources.

 -- ${CPACK_PACKAGE_CONTACT} <>  Sun, 22 Nov 2026 00:00:00 +0000
")
execute_process(COMMAND gzip -9nf "${CMAKE_BINARY_DIR}/install/changelog")
install(FILES "${CMAKE_BINARY_DIR}/install/copyright" "${CMAKE_BINARY_DIR}/install/changelog.gz"
    DESTINATION "${CMAKE_INSTALL_DOCDIR}")
include(CPack)
