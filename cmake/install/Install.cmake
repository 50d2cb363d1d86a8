# What `cmake --install` puts where: programs in bin, what they read in share/plumbline, and what a
# desktop and a shell look for. The program finds share/plumbline from its own place (core/io/files.cpp),
# so any prefix works, and a moved one.
include(GNUInstallDirs)

install(TARGETS plumbline plumbline-f64 RUNTIME DESTINATION "${CMAKE_INSTALL_BINDIR}")
install(TARGETS plumbline-engines RUNTIME DESTINATION "${CMAKE_INSTALL_LIBEXECDIR}/plumbline")

# All that the program may read at run time; not what made it, and not the benchmarks' scenes.
set(data_folder "${CMAKE_INSTALL_DATADIR}/plumbline")
install(DIRECTORY assets shaders config
    DESTINATION "${data_folder}"
    PATTERN "assets/source" EXCLUDE
    PATTERN "assets/models/bench" EXCLUDE
    PATTERN "assets/scenes/bench" EXCLUDE)

# Pages and completion come from the program's own description of its command line.
set(made "${CMAKE_BINARY_DIR}/install")
set(made_files "")
foreach(program plumbline plumbline-f64)
    add_custom_command(
        OUTPUT "${made}/${program}.1.gz" "${made}/${program}.bash"
        COMMAND ${CMAKE_COMMAND} -E make_directory "${made}"
        COMMAND ${program} help-data --man | gzip -9n > "${made}/${program}.1.gz"
        COMMAND ${program} help-data --bash > "${made}/${program}.bash"
        DEPENDS ${program}
        COMMENT "Writing the manual page and completion of ${program}"
        VERBATIM)
    list(APPEND made_files "${made}/${program}.1.gz")
    install(FILES "${made}/${program}.1.gz" DESTINATION "${CMAKE_INSTALL_MANDIR}/man1")
    install(FILES "${made}/${program}.bash"
        DESTINATION "${CMAKE_INSTALL_DATADIR}/bash-completion/completions" RENAME "${program}")
endforeach()
add_custom_target(plumbline_help_data ALL DEPENDS ${made_files})

install(FILES cmake/install/plumbline.desktop
    DESTINATION "${CMAKE_INSTALL_DATADIR}/applications")
install(FILES cmake/install/alt.plumbline.plumbline.metainfo.xml DESTINATION "${CMAKE_INSTALL_DATADIR}/metainfo")
set(icons "${CMAKE_INSTALL_DATADIR}/icons/hicolor")
install(FILES cmake/install/icons/plumbline.svg DESTINATION "${icons}/scalable/apps")
foreach(side 48 128 256)
    install(FILES cmake/install/icons/plumbline-${side}.png
        DESTINATION "${icons}/${side}x${side}/apps" RENAME plumbline.png)
endforeach()

install(FILES README.md assets/CREDITS.md DESTINATION "${CMAKE_INSTALL_DOCDIR}")
include(install/Library)
include(install/Package)
