# Everything comes from Debian 12's packages; cmake/bootstrap.sh installs them.
if(WEAVEFRONT_MPI)
    # Debian names the compilers and the launcher of each MPI, and the HDF5 that was built with it.
    find_program(MPI_CXX_COMPILER mpicxx.${WEAVEFRONT_MPI} REQUIRED)
    find_program(MPIEXEC_EXECUTABLE mpiexec.${WEAVEFRONT_MPI} REQUIRED)
    find_program(HDF5_C_COMPILER_EXECUTABLE h5pcc.${WEAVEFRONT_MPI} REQUIRED)
endif()
find_package(MPI REQUIRED COMPONENTS CXX)
find_package(Eigen3 3.4 REQUIRED NO_MODULE)
find_package(yaml-cpp REQUIRED)
find_package(fmt REQUIRED)
find_package(spdlog REQUIRED)
find_package(nlohmann_json REQUIRED)
find_package(CLI11 REQUIRED)
find_package(Boost 1.74 REQUIRED)  # headers only
find_package(OpenSSL REQUIRED COMPONENTS Crypto)
if(WEAVEFRONT_TESTS)
    find_package(benchmark REQUIRED)
endif()

# FindHDF5 needs the C language enabled.
set(HDF5_PREFER_PARALLEL ON)
find_package(HDF5 REQUIRED COMPONENTS C)
if(NOT HDF5_IS_PARALLEL)
    message(FATAL_ERROR "HDF5 found, but without MPI; install libhdf5-openmpi-dev")
endif()
target_link_libraries(HDF5::HDF5 INTERFACE MPI::MPI_CXX)

# METIS, udunits2 and xxHash ship no CMake package.
foreach(library metis udunits2 xxhash)
    find_library(${library}_LIBRARY ${library} REQUIRED)
    find_path(${library}_INCLUDE_DIR ${library}.h REQUIRED)
    add_library(${library} INTERFACE IMPORTED GLOBAL)
    target_link_libraries(${library} INTERFACE ${${library}_LIBRARY})
    target_include_directories(${library} SYSTEM INTERFACE ${${library}_INCLUDE_DIR})
endforeach()
