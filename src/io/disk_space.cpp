#include "disk_space.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>

#include "results_skeleton.hpp"
#include "weavefront/io/file_error.hpp"
#include "weavefront/io/new_file.hpp"

namespace weavefront::io {

void require_space(const ResultsSetup& setup, double bytes) {
    constexpr double of_other_files = 1e6;  // history, log and summary
    std::error_code unknown;                // then creating the file tells why
    const auto folder = std::filesystem::absolute(setup.path, unknown).parent_path();
    const auto disk = std::filesystem::space(folder, unknown);
    if (unknown) return;
    const auto left = static_cast<double>(disk.available) + bytes;
    const double needed = results_bytes(setup, setup.max_frames) + of_other_files;
    if (needed > left)
        throw FileError(
            fmt::format("{} may grow to {:.4g} GB with its {} frames, but only {:.4g} GB are free there: "
                        "write fewer frames "
                        "(output.interval) or fields (output.fields), or to another disk (--output)",
                        setup.path.string(), needed / 1e9, setup.max_frames, left / 1e9));
}

void require_size(const ResultsSetup& setup) {
    constexpr off_t of_structure = 1 << 20;
    const auto name = temporary_name(setup.path);
    const int descriptor = ::open(name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0666);
    if (descriptor < 0) return;  // then creating the file tells why
    const double bytes = results_bytes(setup, setup.max_frames);
    int cause = ::ftruncate(descriptor, static_cast<off_t>(bytes)) == 0 ? 0 : errno;
    if (cause == 0) cause = ::posix_fallocate(descriptor, 0, of_structure);
    ::close(descriptor);
    ::unlink(name.c_str());
    if (cause != 0)
        throw FileError(fmt::format(
            "{} may grow to {:.4g} GB with its {} frames, which is refused (disk, quota, ulimit -f): {}",
            setup.path.string(), bytes / 1e9, setup.max_frames, std::generic_category().message(cause)));
}

double taken_by(const std::filesystem::path& path) {
    struct stat found {};
    constexpr double of_block = 512;
    return ::stat(path.c_str(), &found) == 0 ? of_block * static_cast<double>(found.st_blocks) : 0.0;
}

}  // namespace weavefront::io
