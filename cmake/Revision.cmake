# The state of the sources, for the head of run.log, as git describes it when the build is configured. It goes
# into one generated file that is written only when it changes, so a new commit recompiles that file and
# nothing else.
set(revision unknown)
find_package(Git QUIET)
if(GIT_FOUND)
    execute_process(COMMAND ${GIT_EXECUTABLE} rev-parse --show-toplevel
                    WORKING_DIRECTORY ${PROJECT_SOURCE_DIR} OUTPUT_VARIABLE top OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
    file(REAL_PATH ${PROJECT_SOURCE_DIR} real_source)
    # Sources unpacked inside somebody else's repository are not of its revision.
    if(top AND top PATH_EQUAL real_source)
        execute_process(COMMAND ${GIT_EXECUTABLE} describe --always --tags --dirty
                        WORKING_DIRECTORY ${PROJECT_SOURCE_DIR} OUTPUT_VARIABLE described OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
        if(described MATCHES "^[-A-Za-z0-9._+]+$")
            set(revision ${described})
        endif()
    endif()
endif()
configure_file(${PROJECT_SOURCE_DIR}/src/app/revision.cpp.in ${PROJECT_BINARY_DIR}/revision.cpp @ONLY)
