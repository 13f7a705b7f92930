# Man pages and completions, which the program writes from its table of commands whenever it was linked anew.
set(manual_folder ${PROJECT_BINARY_DIR}/manual)
if(CMAKE_CROSSCOMPILING AND NOT CMAKE_CROSSCOMPILING_EMULATOR)
    message(STATUS "No man pages and completions: this machine cannot run the program (CMAKE_CROSSCOMPILING_EMULATOR)")
else()
    add_custom_command(TARGET carom POST_BUILD
        COMMAND ${CMAKE_COMMAND} -E rm -rf ${manual_folder}
        COMMAND ${CMAKE_CROSSCOMPILING_EMULATOR} $<TARGET_FILE:carom> help --files ${manual_folder}
        VERBATIM)
    install(DIRECTORY ${manual_folder}/man/ DESTINATION ${CMAKE_INSTALL_MANDIR})
    install(DIRECTORY ${manual_folder}/bash-completion ${manual_folder}/zsh ${manual_folder}/fish DESTINATION ${CMAKE_INSTALL_DATADIR})
endif()
