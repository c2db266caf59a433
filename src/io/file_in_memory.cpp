#include "file_in_memory.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <system_error>
#include <vector>

#include "hdf5_group_writer.hpp"
#include "weavefront/io/file_error.hpp"

namespace weavefront::io {

FileInMemory::FileInMemory(const std::string& shown)
    : shown_(shown), number_(::memfd_create("weavefront", MFD_CLOEXEC)) {
    if (number_ < 0)
        throw FileError(
            fmt::format("{} cannot be created: {}", shown_, std::generic_category().message(errno)));
}

FileInMemory::~FileInMemory() { ::close(number_); }

std::string FileInMemory::path() const { return fmt::format("/proc/self/fd/{}", number_); }

H5File FileInMemory::create_hdf5() const {
    const auto doing = "creating " + shown_;
    const H5Properties creation = creation_properties(H5P_FILE_CREATE, doing),
                       access = unlocked_access(doing);
    // HDF5's usual driver asks for the path behind the link that leads to the file, and there is none.
    checked(H5Pset_fapl_stdio(access.get()), doing);
    return H5File(checked(H5Fcreate(path().c_str(), H5F_ACC_TRUNC, creation.get(), access.get()), doing));
}

void FileInMemory::copy_to(const Descriptor& file) const {
    const Descriptor from(path(), O_RDONLY, shown_);
    const auto size = from.size();
    file.resize(size);
    std::vector<std::byte> bytes(1 << 20);
    for (std::int64_t at = ::lseek(number_, 0, SEEK_DATA); at >= 0; at = ::lseek(number_, at, SEEK_DATA)) {
        const auto end = std::min<std::int64_t>(::lseek(number_, at, SEEK_HOLE), size);
        while (at < end) {
            const auto part =
                std::span(bytes).first(std::min(bytes.size(), static_cast<std::size_t>(end - at)));
            from.read(part, at);
            file.write(part, at);
            at += static_cast<std::int64_t>(part.size());
        }
    }
}

}  // namespace weavefront::io
