#include "silent_output.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cstdio>

namespace weavefront::partition {

SilentOutput::SilentOutput() {
    std::fflush(stdout);
    const int nowhere = ::open("/dev/null", O_WRONLY | O_CLOEXEC);
    if (nowhere < 0) return;
    kept_ = ::fcntl(STDOUT_FILENO, F_DUPFD_CLOEXEC, STDERR_FILENO + 1);
    if (kept_ >= 0 && ::dup2(nowhere, STDOUT_FILENO) < 0) {
        ::close(kept_);
        kept_ = -1;
    }
    ::close(nowhere);
}

SilentOutput::~SilentOutput() {
    if (kept_ < 0) return;
    std::fflush(stdout);
    ::dup2(kept_, STDOUT_FILENO);
    ::close(kept_);
}

}  // namespace weavefront::partition
