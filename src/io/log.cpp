#include "weavefront/io/log.hpp"

#include <spdlog/details/null_mutex.h>
#include <spdlog/logger.h>
#include <spdlog/sinks/base_sink.h>
#include <spdlog/sinks/stdout_sinks.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <system_error>
#include <utility>

#include "agreement.hpp"
#include "weavefront/io/file_error.hpp"
#include "weavefront/io/new_file.hpp"

namespace weavefront::io {

namespace {

/// Whether somebody looks on. Open MPI gives every process a terminal of its own, whatever its launcher
/// prints to: then that counts.
bool on_terminal() {
    if (::isatty(STDOUT_FILENO) != 1) return false;
    if (std::getenv("OMPI_COMM_WORLD_RANK") == nullptr) return true;
    std::error_code unknown;
    const auto shown =
        std::filesystem::read_symlink("/proc/" + std::to_string(::getppid()) + "/fd/1", unknown).string();
    return unknown || shown.starts_with("/dev/pts/") || shown.starts_with("/dev/tty");
}

/// run.log. A line that it cannot take, on a full disk, is told to standard error and counted; the run goes
/// on.
class FileSink final : public spdlog::sinks::base_sink<spdlog::details::null_mutex> {
  public:
    FileSink(const std::filesystem::path& path, LogStart start)
        : is_held_back_(start == LogStart::continued && std::filesystem::exists(path)),
          file_(is_held_back_ ? NewFile::appended_to(path) : std::make_unique<NewFile>(path)) {}
    ~FileSink() override {
        if (lost_ > 1) std::fprintf(stderr, "warning: run.log lacks %d lines\n", lost_);
    }
    FileSink(const FileSink&) = delete;
    FileSink& operator=(const FileSink&) = delete;

    void publish() {
        file_->publish();
        if (std::exchange(is_held_back_, false)) append(std::exchange(held_back_, {}));
    }

  private:
    void sink_it_(const spdlog::details::log_msg& message) override {
        spdlog::memory_buf_t line;
        formatter_->format(message, line);
        append({line.data(), line.size()});
    }
    void flush_() override {}

    void append(std::string_view text) {
        if (is_held_back_) {
            held_back_ += text;
            return;
        }
        try {
            file_->append(text);
        } catch (const FileError& failure) {
            if (++lost_ == 1)
                std::fprintf(stderr, "warning: a line of the log is lost: %s\n", failure.what());
        }
    }

    bool is_held_back_;  // a log that goes on is not touched before the run is certain to start
    std::string held_back_;
    std::unique_ptr<NewFile> file_;
    int lost_ = 0;
};

}  // namespace

class Log::Sinks {
  public:
    Sinks(const std::filesystem::path& directory, Terminal terminal, LogStart start)
        : interactive_(terminal == Terminal::shown && on_terminal()),
          out_("out"),
          error_("error"),
          file_("run.log") {
        if (terminal == Terminal::shown) {
            out_.sinks().push_back(std::make_shared<spdlog::sinks::stdout_sink_mt>());
            error_.sinks().push_back(std::make_shared<spdlog::sinks::stderr_sink_mt>());
        }
        if (!directory.empty()) {
            in_file_ = std::make_shared<FileSink>(directory / "run.log", start);
            file_.sinks().push_back(in_file_);
        }
        // A time on every line would hide the text, and no two runs would agree.
        for (auto* logger : {&out_, &error_, &file_}) {
            logger->set_pattern("%v");
            logger->flush_on(spdlog::level::info);
        }
    }

    void info(std::string_view line) {
        above_drawing([&] { out_.info(line); });
        file_.info(line);
    }
    void warn(std::string_view line) {
        const std::string marked = "warning: " + std::string(line);
        above_drawing([&] { error_.info(marked); });
        file_.info(marked);
    }
    void record(std::string_view line) { file_.info(line); }
    void publish() {
        if (in_file_) in_file_->publish();
    }

    [[nodiscard]] bool interactive() const { return interactive_; }

    void draw(std::string_view line) {
        if (!interactive_) return;
        drawn_ = line;
        std::fprintf(stdout, "\r%s\x1b[K", drawn_.c_str());
        std::fflush(stdout);
    }

    void end_drawing() {
        if (drawn_.empty()) return;
        drawn_.clear();
        std::fputc('\n', stdout);
        std::fflush(stdout);
    }

  private:
    template <class Print>
    void above_drawing(Print print) {
        const std::string drawn = drawn_;
        if (!drawn.empty()) {
            std::fputs("\r\x1b[K", stdout);
            std::fflush(stdout);
        }
        print();
        if (!drawn.empty()) draw(drawn);
    }

    bool interactive_;
    std::string drawn_;
    std::shared_ptr<FileSink> in_file_;  // none: terminal only
    spdlog::logger out_, error_, file_;
};

Log::Log(const std::filesystem::path& directory, const parallel::Communicator& comm, Terminal terminal,
         LogStart start)
    : comm_(&comm) {
    Agreement agreement(comm);
    agreement.attempt_on_root([&] { sinks_ = std::make_unique<Sinks>(directory, terminal, start); });
    agreement.settle<FileError>();
}

Log::~Log() = default;
Log::Log(Log&&) noexcept = default;
Log& Log::operator=(Log&&) noexcept = default;

void Log::publish() {
    Agreement agreement(*comm_);
    agreement.attempt_on_root([&] { sinks_->publish(); });
    agreement.settle<FileError>();
}

void Log::info(std::string_view line) {
    if (sinks_) sinks_->info(line);
}

void Log::warn(std::string_view line) {
    if (sinks_) sinks_->warn(line);
}

void Log::record(std::string_view line) {
    if (sinks_) sinks_->record(line);
}

bool Log::interactive() const { return sinks_ && sinks_->interactive(); }

void Log::draw(std::string_view line) {
    if (sinks_) sinks_->draw(line);
}

void Log::end_drawing() {
    if (sinks_) sinks_->end_drawing();
}

}  // namespace weavefront::io
