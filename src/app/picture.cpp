#include "picture.hpp"

#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>

#include <system_error>

extern char** environ;

namespace weavefront::app {

namespace {

/// Beside the program where it is installed, in bin where it was built; empty: nowhere.
std::filesystem::path plot_program() {
    std::error_code failure;
    const std::filesystem::path program = std::filesystem::read_symlink("/proc/self/exe", failure);
    if (failure) return {};
    for (const auto& candidate :
         {program.parent_path() / "weavefront-plot", program.parent_path() / "../../bin/weavefront-plot"})
        if (std::filesystem::is_regular_file(candidate, failure)) return candidate.lexically_normal();
    return {};
}

}  // namespace

void draw_pictures(const std::string& option, const std::filesystem::path& folder) {
    const std::filesystem::path program = plot_program();
    std::string name = program.string(), option_word = option, argument = folder.string();
    char* arguments[] = {name.data(), option_word.data(), argument.data(), nullptr};
    pid_t child = 0;
    int status = -1;
    std::fflush(stdout);
    const bool ran =
        !program.empty() && posix_spawn(&child, name.c_str(), nullptr, nullptr, arguments, environ) == 0;
    if (ran) waitpid(child, &status, 0);
    if (status != 0)
        fmt::print("No picture was drawn; draw it with: weavefront-plot {} {}\n", option, folder.string());
}

}  // namespace weavefront::app
