# src/scene/fabrics.yaml and projectiles.yaml become a source of weavefront::scene.
foreach(library fabrics projectiles)
    set(file ${PROJECT_SOURCE_DIR}/src/scene/${library}.yaml)
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${file})
    file(READ ${file} ${library}_text)
endforeach()
configure_file(${PROJECT_SOURCE_DIR}/src/scene/library_text.cpp.in ${PROJECT_BINARY_DIR}/library_text.cpp @ONLY)
target_sources(weavefront_scene PRIVATE ${PROJECT_BINARY_DIR}/library_text.cpp)
