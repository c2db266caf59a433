# src/scene/fabrics.yaml becomes a source of weavefront::scene.
set(library_file ${PROJECT_SOURCE_DIR}/src/scene/fabrics.yaml)
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${library_file})
file(READ ${library_file} library_text)
configure_file(${PROJECT_SOURCE_DIR}/src/scene/library_text.cpp.in ${PROJECT_BINARY_DIR}/library_text.cpp @ONLY)
target_sources(weavefront_scene PRIVATE ${PROJECT_BINARY_DIR}/library_text.cpp)
