#include "weavefront/io/host_memory.hpp"

#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <limits>
#include <optional>
#include <sstream>
#include <string>

namespace weavefront::io {

namespace {

/// The number after a key, where lines are "key number" or "key: number ...".
std::optional<double> number_of(const std::filesystem::path& path, const std::string& wanted) {
    std::ifstream file(path);
    for (std::string line; std::getline(file, line);) {
        std::istringstream words(line);
        std::string key;
        double number = 0;
        if (words >> key >> number && (key == wanted || key == wanted + ":")) return number;
    }
    return {};
}

/// The number that a file is; none where it is missing, or a word such as max.
std::optional<double> number_in(const std::filesystem::path& path) {
    double number = 0;
    std::ifstream file(path);
    return file >> number ? std::optional(number) : std::nullopt;
}

double available(const std::filesystem::path& root) {
    constexpr double kibi = 1024;
    if (const auto known = number_of(root / "proc/meminfo", "MemAvailable")) return kibi * *known;
    return static_cast<double>(::sysconf(_SC_PHYS_PAGES)) * static_cast<double>(::sysconf(_SC_PAGESIZE));
}

/// The files of one version of control groups.
struct Version {
    const char *folder, *limit, *usage, *of_files;
};
constexpr Version first{"sys/fs/cgroup/memory", "memory.limit_in_bytes", "memory.usage_in_bytes",
                        "total_inactive_file"};
constexpr Version second{"sys/fs/cgroup", "memory.max", "memory.current", "inactive_file"};

double left_in(const std::filesystem::path& group, const Version& version) {
    const auto limit = number_in(group / version.limit), usage = number_in(group / version.usage);
    if (!limit || !usage) return std::numeric_limits<double>::infinity();
    return std::max(0.0, *limit - *usage + number_of(group / "memory.stat", version.of_files).value_or(0));
}

}  // namespace

double host_memory(const std::filesystem::path& root) {
    double least = available(root);
    std::ifstream groups(root / "proc/self/cgroup");
    for (std::string line; std::getline(groups, line);) {  // number:controllers:/path
        std::istringstream parts(line);
        std::string number, controllers, path;
        std::getline(std::getline(parts, number, ':'), controllers, ':');
        std::getline(parts, path);
        const bool is_second = controllers.empty();
        if (!is_second && ("," + controllers + ",").find(",memory,") == std::string::npos) continue;
        const auto& version = is_second ? second : first;
        // What holds for a group holds for those within it. A container sees its own group as the uppermost
        // one.
        auto group = std::filesystem::path(path).relative_path();
        for (;; group = group.parent_path()) {
            least = std::min(least, left_in(root / version.folder / group, version));
            if (group.empty()) break;
        }
    }
    return least;
}

}  // namespace weavefront::io
