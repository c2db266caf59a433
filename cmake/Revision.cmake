# The state of the sources, for the head of run.log, as git describes it when the program is built: as a script
# this file writes it into one source file, which changes with the state only, so that a new commit recompiles
# that file and nothing else.
if(NOT CMAKE_SCRIPT_MODE_FILE)
    add_custom_target(revision
        COMMAND ${CMAKE_COMMAND} -DSOURCE_DIR=${PROJECT_SOURCE_DIR} -DBINARY_DIR=${PROJECT_BINARY_DIR} -P ${CMAKE_CURRENT_LIST_FILE}
        BYPRODUCTS ${PROJECT_BINARY_DIR}/revision.cpp
        COMMENT "Asking git for the revision")
    return()
endif()

set(revision unknown)
find_package(Git QUIET)
if(GIT_FOUND)
    execute_process(COMMAND ${GIT_EXECUTABLE} rev-parse --show-toplevel
                    WORKING_DIRECTORY ${SOURCE_DIR} OUTPUT_VARIABLE top OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
    file(REAL_PATH ${SOURCE_DIR} real_source)
    # Sources unpacked inside somebody else's repository are not of its revision.
    if(top AND top STREQUAL real_source)
        execute_process(COMMAND ${GIT_EXECUTABLE} describe --always --tags --dirty
                        WORKING_DIRECTORY ${SOURCE_DIR} OUTPUT_VARIABLE described OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
        if(described MATCHES "^[-A-Za-z0-9._+]+$")
            set(revision ${described})
        endif()
    endif()
endif()
configure_file(${SOURCE_DIR}/src/app/revision.cpp.in ${BINARY_DIR}/revision.cpp @ONLY)
