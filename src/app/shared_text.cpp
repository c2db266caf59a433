#include "shared_text.hpp"

#include "weavefront/parallel/on_root.hpp"
#include "weavefront/scene/read.hpp"

namespace weavefront::app {

std::string shared_text(const std::filesystem::path& path, const parallel::Communicator& comm) {
    std::string text;
    parallel::on_root(comm, [&] { text = scene::read_text(path); });
    return comm.broadcast(text);
}

}  // namespace weavefront::app
