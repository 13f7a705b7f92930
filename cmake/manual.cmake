# Man pages and shell completions, which the program writes from its table of commands each time it
# has been linked.
set(manual_folder ${PROJECT_BINARY_DIR}/manual)
if(CMAKE_CROSSCOMPILING AND NOT CMAKE_CROSSCOMPILING_EMULATOR)
    message(STATUS "No man pages and completions: this machine cannot run the program (CMAKE_CROSSCOMPILING_EMULATOR)")
else()
    add_custom_command(TARGET carom POST_BUILD
        COMMAND ${CMAKE_COMMAND} -E rm -rf ${manual_folder}
        COMMAND ${CMAKE_CROSSCOMPILING_EMULATOR} $<TARGET_FILE:carom> help --files ${manual_folder}
        VERBATIM)
    install(DIRECTORY ${manual_folder}/man/ DESTINATION ${CMAKE_INSTALL_MANDIR})
    if(CAROM_DEB)
        install(CODE "file(GLOB pages \"\$ENV{DESTDIR}\${CMAKE_INSTALL_PREFIX}/${CMAKE_INSTALL_MANDIR}/man1/*.1\")
            execute_process(COMMAND gzip -9nf \${pages} COMMAND_ERROR_IS_FATAL ANY)")
    endif()
    install(DIRECTORY ${manual_folder}/bash-completion ${manual_folder}/fish DESTINATION ${CMAKE_INSTALL_DATADIR})
    set(zsh_folder ${CMAKE_INSTALL_DATADIR}/zsh/site-functions)
    if(CAROM_DEB)
        set(zsh_folder ${CMAKE_INSTALL_DATADIR}/zsh/vendor-completions)  # as in Debian packages
    endif()
    install(DIRECTORY ${manual_folder}/zsh/site-functions/ DESTINATION ${zsh_folder})
endif()
