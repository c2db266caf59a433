#pragma once
/// @file
/// What a run tells its user.

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

#include "weavefront/parallel/communicator.hpp"

namespace weavefront::io {

/// Whether run.log begins or goes on.
enum class LogStart { anew, continued };

/// Whether lines reach the terminal.
enum class Terminal { shown, silent };

/// Plain lines on rank 0, to the terminal and to run.log; the other ranks are silent. On a terminal one line
/// at the bottom may be redrawn in place; whole lines appear above it.
class Log {
  public:
    /// @param directory  where run.log goes, under its temporary name; empty: terminal only
    /// @param comm       must outlive this object
    /// @param terminal   silent: run.log only
    /// @throws FileError on all ranks when run.log cannot be created
    /// @note Collective
    /// @param start      whether lines are added to the run.log of before, where there is one
    Log(const std::filesystem::path& directory, const parallel::Communicator& comm,
        Terminal terminal = Terminal::shown, LogStart start = LogStart::anew);
    ~Log();
    Log(Log&&) noexcept;
    Log& operator=(Log&&) noexcept;

    /// Gives run.log its name, in place of one that exists. @throws FileError on all ranks @note Collective
    void publish();

    /// A line to standard output and run.log.
    void info(std::string_view line);
    /// A line to standard error and run.log, marked as a warning.
    void warn(std::string_view line);
    /// A line to run.log only.
    void record(std::string_view line);

    /// True on rank 0 when standard output is a terminal.
    [[nodiscard]] bool interactive() const;
    /// Redraws the line at the bottom of the terminal; nothing elsewhere.
    void draw(std::string_view line);
    /// Leaves the line at the bottom as it is and goes on below it.
    void end_drawing();

  private:
    class Sinks;
    std::unique_ptr<Sinks> sinks_;  // null on the other ranks
    const parallel::Communicator* comm_;
};

}  // namespace weavefront::io
