#include "file_checksum.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <xxhash.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <span>
#include <vector>

#include "agreement.hpp"
#include "descriptor.hpp"
#include "weavefront/io/file_error.hpp"

namespace weavefront::io {

namespace {

// Ranks read a file in pieces of this size; the checksum is that of the checksums of the pieces.
constexpr std::int64_t piece_bytes = std::int64_t{16} << 20;

/// The last bytes of a sealed file.
struct Seal {
    std::array<char, 16> name{'w', 'e', 'a', 'v', 'e', 'f', 'r', 'o',
                              'n', 't', ' ', 's', 'e', 'a', 'l', '\n'};
    std::uint64_t bytes = 0;     ///< before it
    std::uint64_t checksum = 0;  ///< XXH3 of the checksums of the pieces
};
static_assert(sizeof(Seal) == 32);

/// XXH3 of the first bytes of a file. @note Collective
std::uint64_t checksum_of(const std::string& path, std::int64_t bytes, Agreement& agreement,
                          const parallel::Communicator& comm) {
    const auto pieces = (bytes + piece_bytes - 1) / piece_bytes;
    std::vector<std::int64_t> checksums(static_cast<std::size_t>(pieces),
                                        0);  // zero where another rank reads
    agreement.attempt([&] {
        const auto first = pieces * comm.rank() / comm.size(),
                   last = pieces * (comm.rank() + 1) / comm.size();
        if (first == last) return;
        const Descriptor file(path, O_RDONLY);
        std::vector<std::byte> buffer(static_cast<std::size_t>(std::min(bytes, piece_bytes)));
        for (auto piece = first; piece < last; ++piece) {
            const auto at = piece * piece_bytes;
            const auto part =
                std::span(buffer).first(static_cast<std::size_t>(std::min(piece_bytes, bytes - at)));
            file.read(part, at);
            checksums[static_cast<std::size_t>(piece)] =
                std::bit_cast<std::int64_t>(XXH3_64bits(part.data(), part.size()));
        }
    });
    agreement.settle<FileError>();
    comm.sum(checksums);
    return XXH3_64bits(checksums.data(), checksums.size() * sizeof(std::int64_t));
}

std::int64_t size_on_root(const std::string& path, Agreement& agreement, const parallel::Communicator& comm) {
    std::array<std::int64_t, 1> size{0};
    agreement.attempt_on_root([&] { size[0] = Descriptor(path, O_RDONLY).size(); });
    agreement.settle<FileError>();
    comm.sum(size);
    return size[0];
}

}  // namespace

void seal_file(const std::string& path, const parallel::Communicator& comm) {
    Agreement agreement(comm);
    const auto bytes = size_on_root(path, agreement, comm);
    Seal seal;
    seal.bytes = static_cast<std::uint64_t>(bytes);
    seal.checksum = checksum_of(path, bytes, agreement, comm);
    agreement.attempt_on_root([&] {
        const Descriptor file(path, O_RDWR);
        file.write(std::as_bytes(std::span(&seal, 1)), bytes);
        file.sync();
    });
    agreement.settle<FileError>();
}

void require_sealed(const std::string& path, const parallel::Communicator& comm) {
    Agreement agreement(comm);
    const auto size = size_on_root(path, agreement, comm);
    const auto bytes = size - static_cast<std::int64_t>(sizeof(Seal));
    if (bytes < 0) throw FileError(fmt::format("{} is no checkpoint: it has {} bytes", path, size));
    const auto checksum = checksum_of(path, bytes, agreement, comm);
    agreement.attempt_on_root([&] {
        Seal seal, expected;
        Descriptor(path, O_RDONLY).read(std::as_writable_bytes(std::span(&seal, 1)), bytes);
        if (seal.name != expected.name)
            throw FileError(path + " is no checkpoint, or it was cut: its end is not that of a checkpoint");
        if (seal.bytes != static_cast<std::uint64_t>(bytes))
            throw FileError(fmt::format("{} was cut or changed: it has {} bytes, written were {}", path,
                                        bytes, seal.bytes));
        if (seal.checksum != checksum)
            throw FileError(fmt::format("{} was changed: its checksum is {:016x}, written was {:016x}", path,
                                        checksum, seal.checksum));
    });
    agreement.settle<FileError>();
}

}  // namespace weavefront::io
