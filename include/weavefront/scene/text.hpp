#pragma once
/// @file
/// Texts that users write: read within bounds, refused where they are no text, shown safely in messages.

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace weavefront::scene {

/// Bytes of a scene, a study or a machine file: four times what a scene with 10000 listed plies takes.
inline constexpr std::size_t most_of_document = 4'000'000;
/// Bytes of a table: a row of history.csv takes about 450.
inline constexpr std::size_t most_of_table = 1'000'000'000;

/// The bytes of a regular file.
/// @param most bytes of the file
/// @throws InputError naming file and reason when it cannot be read or is longer than `most`
std::string read_bytes(const std::filesystem::path& path, std::size_t most);

/// The text of a regular file, in UTF-8, without a byte order mark.
/// @param most bytes of the file
/// @throws InputError naming file and reason when it cannot be read, is longer than `most` or no text
std::string read_text(const std::filesystem::path& path, std::size_t most = most_of_document);

/// Refuses bytes that are not UTF-8, and control characters other than tab and line ends.
/// @param name of the file, for messages
/// @throws InputError `name:line:column: found ...` of the first one
void require_text(std::string_view text, const std::string& name);

/// What `require_text` objects to, without its place. @param at receives the offset of the first bad byte
/// @return empty: nothing
std::string fault_of_text(std::string_view text, std::size_t& at);

/// `line:column` of an offset, both from 1, the column in characters.
std::string place_in(std::string_view text, std::size_t offset);

/// A text for a message: at most `most` characters, bytes that are not UTF-8 as <0xDF>, what cannot be seen
/// (control characters, spaces other than the usual one) as <U+00A0>.
std::string printable(std::string_view text, std::size_t most = 60);

/// Bytes of the blank that `text` begins with: space, tab, line ends and every space of Unicode that has a
/// width; 0: it begins with none.
std::size_t blank_at_start(std::string_view text);

/// A decimal number and nothing else but blanks around it; none: it is no number, or not finite.
std::optional<double> finite_number(std::string_view text);

/// Without blanks at both ends.
std::string_view trimmed(std::string_view text);

}  // namespace weavefront::scene
