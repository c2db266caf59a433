#include "shared_text.hpp"

#include <stdexcept>

#include "weavefront/scene/read.hpp"

namespace weavefront::app {

std::string shared_text(const std::filesystem::path& path, const parallel::Communicator& comm) {
    std::string text, fault;
    if (comm.rank() == 0) {
        try {
            text = scene::read_text(path);
        } catch (const std::exception& error) {
            fault = error.what();
        }
    }
    fault = comm.broadcast(fault);
    if (!fault.empty()) throw std::runtime_error(fault);
    return comm.broadcast(text);
}

}  // namespace weavefront::app
