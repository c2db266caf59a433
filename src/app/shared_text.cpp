#include "shared_text.hpp"

#include "weavefront/parallel/on_root.hpp"
#include "weavefront/scene/read.hpp"

namespace weavefront::app {

std::string shared_text(const std::filesystem::path& path, const parallel::Communicator& comm,
                        std::size_t most) {
    std::string text;
    const auto failure = parallel::failure_on_root(comm, [&] { text = scene::read_text(path, most); });
    if (!failure.empty()) throw scene::InputError({failure});
    return comm.broadcast(text);
}

}  // namespace weavefront::app
