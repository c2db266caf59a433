#include "weavefront/io/host_memory.hpp"

#include <gtest/gtest.h>

#include "scratch_directory.hpp"

namespace weavefront::io {
namespace {

// What a machine says of itself, in a folder.
class HostMemoryTest : public testing::Test {
  protected:
    void put(const std::string& name, const std::string& text) const {
        std::filesystem::create_directories((root_ / name).parent_path());
        std::ofstream(root_ / name) << text;
    }
    void SetUp() override {
        put("proc/meminfo",
            "MemTotal:       4000000 kB\nMemFree:         100 kB\nMemAvailable:    1000000 kB\n");
    }

    const parallel::Communicator comm_{MPI_COMM_SELF};
    const ScratchDirectory directory_{comm_};
    const std::filesystem::path root_ = directory_ / "";
};

TEST_F(HostMemoryTest, IsWhatTheKernelHasAvailable) { EXPECT_EQ(host_memory(root_), 1000000.0 * 1024); }

TEST_F(HostMemoryTest, IsLimitedByControlGroupsOfTheSecondVersion) {
    put("proc/self/cgroup", "0::/job/step\n");
    put("sys/fs/cgroup/job/memory.max", "500000000\n");
    put("sys/fs/cgroup/job/memory.current", "200000000\n");
    put("sys/fs/cgroup/job/memory.stat", "anon 120000000\ninactive_file 50000000\n");
    put("sys/fs/cgroup/job/step/memory.max", "max\n");
    put("sys/fs/cgroup/job/step/memory.current", "100\n");
    EXPECT_EQ(host_memory(root_), 500e6 - 200e6 + 50e6);
}

TEST_F(HostMemoryTest, IsLimitedByControlGroupsOfTheFirstVersion) {
    put("proc/self/cgroup", "9:name=systemd:/\n4:cpu,memory:/job\n3:cpuset:/other\n");
    put("sys/fs/cgroup/memory/job/memory.limit_in_bytes", "300000000\n");
    put("sys/fs/cgroup/memory/job/memory.usage_in_bytes", "400000000\n");
    put("sys/fs/cgroup/memory/job/memory.stat", "cache 9\ntotal_inactive_file 250000000\n");
    EXPECT_EQ(host_memory(root_), 150e6);
    // A container sees its own group as the uppermost one, and the path from outside.
    put("proc/self/cgroup", "4:memory:/outside/of/it\n");
    put("sys/fs/cgroup/memory/memory.limit_in_bytes", "300000000\n");
    put("sys/fs/cgroup/memory/memory.usage_in_bytes", "100000000\n");
    EXPECT_EQ(host_memory(root_), 200e6);
}

TEST_F(HostMemoryTest, OfThisMachineIsSomething) { EXPECT_GT(host_memory(), 0); }

}  // namespace
}  // namespace weavefront::io
