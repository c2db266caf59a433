#include "run_lock.hpp"

#include <fcntl.h>
#include <fmt/chrono.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <charconv>
#include <csignal>
#include <ctime>
#include <fstream>
#include <limits>
#include <optional>
#include <sstream>
#include <string>
#include <system_error>

#include "weavefront/io/file_error.hpp"
#include "weavefront/io/new_file.hpp"

namespace weavefront::io {

namespace {

/// What a lock says of its run.
struct Holder {
    std::string host, started;
    pid_t process = 0;
    std::string
        ticks;  ///< at which the process began, since the host did: tells it from a later one with its number
};

std::string host_name() {
    std::array<char, 256> name{};
    ::gethostname(name.data(), name.size() - 1);
    return name.data();
}

/// Field 22 of /proc/PID/stat; "ended": it has, and its parent has not asked how; empty: unknown. The
/// command, which may hold spaces, ends with the last parenthesis.
std::string ticks_of(pid_t process) {
    std::ifstream file(fmt::format("/proc/{}/stat", process));
    std::string text;
    std::getline(file, text);
    const auto command_end = text.rfind(')');
    if (command_end == std::string::npos) return "";
    std::istringstream fields(text.substr(command_end + 1));
    std::string state, field;
    fields >> state;
    for (int i = 4; i <= 22; ++i) fields >> field;
    if (state == "Z" || state == "X") return "ended";
    return fields ? field : "";
}

std::string text_of(const Holder& holder) {
    return fmt::format("host {}\nprocess {}\nticks {}\nstarted {}\n", holder.host, holder.process,
                       holder.ticks, holder.started);
}

/// The text of a lock; none when it is no regular file or cannot be read.
std::optional<std::string> text_in(const std::filesystem::path& path) {
    const int descriptor = ::open(path.c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
    if (descriptor < 0) return {};
    std::array<char, 1024> text{};
    struct stat found {};
    const bool is_file = ::fstat(descriptor, &found) == 0 && S_ISREG(found.st_mode);
    const auto length = is_file ? ::read(descriptor, text.data(), text.size()) : -1;
    ::close(descriptor);
    return length < 0 ? std::nullopt
                      : std::optional(std::string(text.data(), static_cast<std::size_t>(length)));
}

std::optional<Holder> holder_in(const std::string& text) {
    Holder holder;
    std::string host, process, ticks, started;
    std::istringstream words(text);
    words >> host >> holder.host >> process >> holder.process >> ticks >> holder.ticks >> started >>
        holder.started;
    const bool is_whole =
        words && host == "host" && process == "process" && ticks == "ticks" && started == "started";
    return is_whole && holder.process > 0 ? std::optional(holder) : std::nullopt;
}

bool is_gone(const Holder& holder) {
    if (::kill(holder.process, 0) != 0 && errno == ESRCH) return true;
    const auto ticks = ticks_of(holder.process);
    return !ticks.empty() && ticks != holder.ticks;
}

[[noreturn]] void refuse(const std::filesystem::path& lock, const std::string& by) {
    throw FileError(
        fmt::format("output directory {} is in use by another run{}", lock.parent_path().string(), by));
}

/// Refuses a lock that holds. @return the text of one that does not
std::string require_stale(const std::filesystem::path& lock, const std::string& here) {
    const auto text = text_in(lock);
    const auto holder = holder_in(text.value_or(""));
    if (!holder)
        refuse(lock, fmt::format(": {} does not say by which; remove it when there is none", lock.string()));
    const auto run =
        fmt::format(": process {} on {} since {}", holder->process, holder->host, holder->started);
    if (holder->host != here)
        refuse(lock, fmt::format("{}, which cannot be seen from {}; remove {} when it has ended", run, here,
                                 lock.string()));
    if (!is_gone(*holder)) refuse(lock, run);
    return *text;
}

/// Removes a stale lock, unless another run has taken it over meanwhile.
void take_away(const std::filesystem::path& lock, const std::string& stale) {
    const auto aside = lock.string() + fmt::format(".{}", ::getpid());
    if (::rename(lock.c_str(), aside.c_str()) != 0) return;
    const bool is_stale = text_in(aside) == stale;
    if (!is_stale && ::link(aside.c_str(), lock.c_str()) != 0) ::unlink(aside.c_str());
    ::unlink(aside.c_str());
    if (!is_stale) refuse(lock, "");
}

}  // namespace

RunLock::RunLock(const std::filesystem::path& folder) : path_(folder / "run.lock") {
    const Holder own{host_name(), fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(std::time(nullptr))),
                     ::getpid(), ticks_of(::getpid())};
    const auto text = text_of(own);
    constexpr int attempts = 2;
    for (int attempt = 0;; ++attempt) {
        descriptor_ = ::open(path_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0666);
        if (descriptor_ >= 0) {
            if (::write(descriptor_, text.data(), text.size()) == static_cast<ssize_t>(text.size())) return;
            const int cause = errno;
            ::close(descriptor_);
            ::unlink(path_.c_str());
            throw FileError(fmt::format("{} cannot be written: {}", path_.string(),
                                        std::generic_category().message(cause)));
        }
        if (errno != EEXIST)
            throw FileError(fmt::format("{} cannot be created: {}", path_.string(),
                                        std::generic_category().message(errno)));
        if (attempt == attempts) refuse(path_, "");
        take_away(path_, require_stale(path_, own.host));
    }
}

RunLock::~RunLock() {
    if (is_in_place(descriptor_, path_)) ::unlink(path_.c_str());
    ::close(descriptor_);
}

}  // namespace weavefront::io
