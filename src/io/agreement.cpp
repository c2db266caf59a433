#include "agreement.hpp"

#include <utility>

namespace weavefront::io {

std::optional<std::string> Agreement::verdict() {
    const auto mine = std::exchange(failure_, std::nullopt);
    const int candidate = mine ? comm_->rank() : comm_->size();
    int speaker = candidate;
    parallel::check(MPI_Allreduce(&candidate, &speaker, 1, MPI_INT, MPI_MIN, comm_->get()));
    if (speaker == comm_->size()) return std::nullopt;

    std::string text = mine.value_or(std::string());
    int length = static_cast<int>(text.size());
    parallel::check(MPI_Bcast(&length, 1, MPI_INT, speaker, comm_->get()));
    text.resize(static_cast<std::size_t>(length));
    parallel::check(MPI_Bcast(text.data(), length, MPI_CHAR, speaker, comm_->get()));
    return text;
}

}  // namespace weavefront::io
