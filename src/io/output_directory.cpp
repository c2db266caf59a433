#include "weavefront/io/output_directory.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <system_error>

#include "agreement.hpp"
#include "run_lock.hpp"
#include "weavefront/io/file_error.hpp"
#include "weavefront/io/new_file.hpp"
#include "weavefront/scene/read.hpp"

namespace weavefront::io {

namespace {

// In the order in which they go: who finds a summary finds the other files of its run.
constexpr std::array of_run{"summary.json",           "history.csv", "results.vtkhdf", "checkpoint.h5",
                            "checkpoint.previous.h5", "run.log"};
constexpr std::array of_study{"study.csv", "study.json", "v50.csv", "v50.json", "run.log"};

std::string reason_of(int cause) { return std::generic_category().message(cause); }

bool is_there(const std::filesystem::path& path) {
    struct stat found {};
    return ::lstat(path.c_str(), &found) == 0;
}

/// @return whether it was created
bool create_writable(const std::filesystem::path& directory) {
    std::error_code failure;
    const bool is_created = std::filesystem::create_directories(directory, failure);
    if (failure && std::filesystem::is_symlink(directory) && !std::filesystem::exists(directory))
        throw FileError("output directory " + directory.string() + " cannot be created: it is a link to " +
                        std::filesystem::read_symlink(directory).string() + ", which is missing");
    if (failure)
        throw FileError("output directory " + directory.string() +
                        " cannot be created: " + failure.message());
    if (!std::filesystem::is_directory(directory, failure))
        throw FileError("output directory " + directory.string() + " is not a directory");
    if (::access(directory.c_str(), W_OK | X_OK) != 0)
        throw FileError("output directory " + directory.string() +
                        " cannot be written to: " + reason_of(errno));
    return is_created;
}

void remove_file(const std::filesystem::path& path) {
    if (::unlink(path.c_str()) != 0 && errno != ENOENT)
        throw FileError(path.string() + " cannot be removed: " + reason_of(errno));
}

template <class Names>
std::vector<std::string> names_there(const std::filesystem::path& directory, const Names& names) {
    std::vector<std::string> there;
    for (const auto* name : names)
        for (const auto& path : {directory / name, temporary_name(directory / name)})
            if (is_there(path)) {
                require_regular_or_missing(path);
                there.push_back(path.filename().string());
            }
    return there;
}

template <class Names>
void remove_temporaries(const std::filesystem::path& directory, const Names& names) {
    for (const auto* name : names) remove_file(temporary_name(directory / name));
}

/// @return why the files of before are refused; empty: they are not
std::string refusal(const std::filesystem::path& directory, Earlier earlier) {
    auto there = names_there(directory, of_run);
    if (earlier == Earlier::kept) {
        std::erase_if(there, [](const std::string& name) { return name.starts_with("run.log"); });
        (void)names_there(directory, of_study);
    }
    if (there.empty() && earlier == Earlier::continued)
        return fmt::format("{} holds no run that could go on", directory.string());
    if (there.empty() || earlier == Earlier::replaced || earlier == Earlier::continued) return {};
    const bool can_go_on =
        std::ranges::any_of(there, [](const auto& name) { return name.starts_with("checkpoint."); });
    const auto remedy =
        std::string(earlier == Earlier::refused && can_go_on ? "--restart auto goes on with it, " : "") +
        (earlier == Earlier::refused ? "--overwrite replaces it, " : "") + "--output names another folder";
    return fmt::format("{} holds a run already ({}): {}", directory.string(), fmt::join(there, ", "), remedy);
}

}  // namespace

OutputDirectory::OutputDirectory(const std::filesystem::path& path, const parallel::Communicator& comm,
                                 Earlier earlier)
    : path_(path), comm_(comm) {
    std::string refused;
    Agreement agreement(comm);
    agreement.attempt_on_root([&] {
        if (earlier == Earlier::continued && !is_there(path)) {
            refused = refusal(path, earlier);
            return;
        }
        is_created_ = create_writable(path);
        lock_ = std::make_unique<RunLock>(path);
        refused = refusal(path, earlier);
        if (earlier == Earlier::replaced || earlier == Earlier::continued) remove_temporaries(path, of_run);
        if (earlier == Earlier::kept && refused.empty()) remove_temporaries(path, of_study);
    });
    agreement.settle<FileError>();
    refused = comm.broadcast(refused);
    if (!refused.empty()) throw scene::InputError({refused});
}

OutputDirectory::~OutputDirectory() {
    lock_.reset();
    if (is_created_) ::rmdir(path_.c_str());  // which leaves one that holds something
}

void OutputDirectory::remove_summary() {
    Agreement agreement(comm_);
    agreement.attempt_on_root([&] { remove_file(path_ / "summary.json"); });
    agreement.settle<FileError>();
}

std::vector<std::string> OutputDirectory::clear() {
    std::vector<std::string> there;
    Agreement agreement(comm_);
    agreement.attempt_on_root([&] {
        for (const auto* name : of_run) {
            if (!is_there(path_ / name)) continue;
            require_regular_or_missing(path_ / name);
            remove_file(path_ / name);
            there.emplace_back(name);
        }
    });
    agreement.settle<FileError>();
    return there;
}

}  // namespace weavefront::io
