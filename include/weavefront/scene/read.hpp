#pragma once
/// @file
/// Reading and validating a scene file.

#include <filesystem>
#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

#include "weavefront/scene/scene.hpp"

namespace weavefront::scene {

/// What the user did wrong, exit status 2. Of a scene: everything at once, one line each: `file:line:column:
/// what was found, what is allowed[, did you mean ...]`.
class InputError : public std::runtime_error {
  public:
    /// @param more so many findings beside `messages` were counted, not kept
    explicit InputError(std::vector<std::string> messages, std::size_t more = 0);
    [[nodiscard]] const std::vector<std::string>& messages() const { return messages_; }
    /// What a user is shown: the first twenty messages and how many more there are.
    [[nodiscard]] std::vector<std::string> shown() const;
    /// Findings that `messages` lacks.
    [[nodiscard]] std::size_t more() const { return more_; }

  private:
    std::vector<std::string> messages_;
    std::size_t more_;
};

/// Collects messages on a table, where every row may be at fault: the first thousand, and how many more there
/// are.
class MessageList {
  public:
    void add(const std::string& message);
    [[nodiscard]] bool empty() const { return messages_.empty(); }
    /// @throws InputError unless nothing was added
    void raise() const;

  private:
    std::vector<std::string> messages_;
    std::size_t more_ = 0;
};

/// What a command needs of a scene.
enum class Need { fabrics, impact };

/// Reads the bytes of a file that a scene names. @param most bytes @throws InputError when it cannot
using ReadFile = std::function<std::string(const std::filesystem::path& path, std::size_t most)>;

/// Reads a scene file, applies overrides, validates it.
/// @param path      YAML file
/// @param overrides `PATH=VALUE` with dots between keys, as given to `--set`
/// @param need      `impact` demands target, time and output as well; `fabrics` only the fabrics
/// @throws InputError with every finding at once, or when the file cannot be read
/// @note Reads a file; in a parallel run one rank reads the text and all call `parse_scene`.
Scene read_scene(const std::filesystem::path& path, const std::vector<std::string>& overrides = {},
                 Need need = Need::impact);

/// The same from text.
/// @param name      stands in the messages where the file name would
/// @param read_file reads the files of shapes; absent: from the disk of this host
Scene parse_scene(const std::string& text, const std::string& name,
                  const std::vector<std::string>& overrides = {}, Need need = Need::impact,
                  const ReadFile& read_file = {});

}  // namespace weavefront::scene
