#pragma once
/// @file
/// What is wrong with a scene, collected until everything has been read.

#include <string>
#include <string_view>
#include <vector>

namespace weavefront::scene {

/// Where a value was written: `file:line:column`, or the override it came from.
struct Location {
    std::string text = {};
    int line = 1;
    int column = 1;
};

/// Collects findings and throws them at once, in the order of the file.
class Findings {
  public:
    /// Notes one finding, `where: path: what`, as one line of bounded length in which all can be seen.
    void add(const Location& where, std::string_view path, std::string_view what);

    /// Notes `found ..., allowed ...[, did you mean 'hint'?]`. An empty `hint` is left out.
    void add(const Location& where, std::string_view path, std::string_view found, std::string_view allowed,
             std::string_view hint = {});

    /// Counts findings without words.
    void count(std::size_t further) { more_ += silent_ ? 0 : further; }

    /// While silent, findings are dropped.
    void silence(bool silent) { silent_ = silent; }
    [[nodiscard]] bool silent() const { return silent_; }

    [[nodiscard]] bool empty() const { return findings_.empty(); }

    /// Whether further findings are only counted: a file of a million faults shall not take a gigabyte of
    /// messages.
    [[nodiscard]] bool full() const;

    /// Takes over what another one has noted.
    void take(Findings& other);

    /// What was noted, in the order of the file.
    [[nodiscard]] std::vector<std::string> messages() const;

    /// Findings that were counted only.
    [[nodiscard]] std::size_t more() const { return more_; }

    /// Throws everything noted.
    /// @throws InputError unless nothing was
    void raise() const;

  private:
    struct Finding {
        int line;
        int column;
        std::string text;
    };
    std::vector<Finding> findings_;
    std::size_t more_ = 0;
    bool silent_ = false;
};

}  // namespace weavefront::scene
