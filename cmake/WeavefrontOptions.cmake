option(WEAVEFRONT_TESTS "Build the tests" ON)
option(WEAVEFRONT_WERROR "Treat warnings as errors" ON)
set(WEAVEFRONT_ARCH native CACHE STRING "Processor to build for, as given to -march: native, x86-64-v3, x86-64-v4")
option(WEAVEFRONT_COVERAGE "Count the lines that are executed, for gcovr" OFF)
set(WEAVEFRONT_MPI "" CACHE STRING "MPI to build with: openmpi, mpich; empty: the default of the system")
option(WEAVEFRONT_FUZZ "Build the fuzz targets with libFuzzer; needs clang++" OFF)
set(WEAVEFRONT_BOUND_WITHOUT nothing CACHE STRING  # tests/stability/parts.py measures what each part saves
    "Part that the tight bound on the time step lacks: nothing, flat_contact, free_crossovers, coupling")
set(WEAVEFRONT_SANITIZE "" CACHE STRING "Sanitizers to build with, as given to -fsanitize=")

if(NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
    set(CMAKE_BUILD_TYPE Release CACHE STRING "" FORCE)
endif()
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)

add_library(weavefront_options INTERFACE)
target_compile_features(weavefront_options INTERFACE cxx_std_20)
target_compile_options(weavefront_options INTERFACE
    -march=${WEAVEFRONT_ARCH}
    -ffp-contract=off  # same bits from every build
    -fno-math-errno -fno-trapping-math  # errno of sqrt is never read, and no operation is made to trap
    $<$<CXX_COMPILER_ID:GNU>:-fno-tree-slp-vectorize>  # g++ 12.2 fuses multiply and add there in spite of -ffp-contract=off (GCC bug 107647)
    -Wall -Wextra -Wpedantic -Wconversion -Wshadow
    $<$<CXX_COMPILER_ID:GNU>:-Wno-psabi>
    $<$<BOOL:${WEAVEFRONT_WERROR}>:-Werror>)
if(WEAVEFRONT_SANITIZE)
    # The address sanitizer sees what null, vptr and object-size look for, x86 reads at any alignment, and the four take a third of the build.
    target_compile_options(weavefront_options INTERFACE -fsanitize=${WEAVEFRONT_SANITIZE} -fno-omit-frame-pointer -fno-sanitize-recover=all
        -fno-sanitize=null,vptr,object-size,alignment)
    target_link_options(weavefront_options INTERFACE -fsanitize=${WEAVEFRONT_SANITIZE})
endif()
if(WEAVEFRONT_COVERAGE)
    target_compile_options(weavefront_options INTERFACE --coverage)
    target_link_options(weavefront_options INTERFACE --coverage)
endif()
