#include "versions.hpp"

#include <fmt/format.h>
#include <hdf5.h>
#include <metis.h>
#include <mpi.h>

#include <Eigen/Core>

namespace weavefront::app {

std::map<std::string, std::string> library_versions() {
    int major = 0, minor = 0;
    MPI_Get_version(&major, &minor);
    return {{"weavefront", WEAVEFRONT_VERSION},
            {"mpi", fmt::format("{}.{}", major, minor)},
            {"hdf5", H5_VERS_INFO},
            {"metis", fmt::format("{}.{}.{}", METIS_VER_MAJOR, METIS_VER_MINOR, METIS_VER_SUBMINOR)},
            {"eigen", fmt::format("{}.{}.{}", EIGEN_WORLD_VERSION, EIGEN_MAJOR_VERSION, EIGEN_MINOR_VERSION)},
            {"compiler", fmt::format("g++ {}", __VERSION__)}};
}

}  // namespace weavefront::app
