#include "shared_text.hpp"

#include "weavefront/parallel/on_root.hpp"

namespace weavefront::app {

namespace {

/// What rank 0 reads.
template <class Read>
std::string shared(Read read, const parallel::Communicator& comm) {
    std::string bytes;
    const auto failure = parallel::failure_on_root(comm, [&] { bytes = read(); });
    if (!failure.empty()) throw scene::InputError({failure});
    return comm.broadcast(bytes);
}

}  // namespace

std::string shared_text(const std::filesystem::path& path, const parallel::Communicator& comm,
                        std::size_t most) {
    return shared([&] { return scene::read_text(path, most); }, comm);
}

scene::ReadFile shared_files(const parallel::Communicator& comm) {
    return [&comm](const std::filesystem::path& path, std::size_t most) {
        return shared([&] { return scene::read_bytes(path, most); }, comm);
    };
}

}  // namespace weavefront::app
