#include "weavefront/scene/text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstring>
#include <fstream>
#include <system_error>
#include <vector>

#include "utf8.hpp"
#include "weavefront/scene/read.hpp"

namespace weavefront::scene {
namespace {

// Characters of a path in messages.
constexpr std::size_t most_of_path = 300;

constexpr std::string_view byte_order_mark = "\xef\xbb\xbf";

[[noreturn]] void refuse(const std::filesystem::path& path, const std::string& reason) {
    throw InputError({fmt::format("{}: cannot be read: {}", printable(path.string(), most_of_path), reason)});
}

// A pipe or a device may have no end, or make the program wait for ever.
void require_regular(const std::filesystem::path& path) {
    std::error_code failure;
    const auto status = std::filesystem::status(path, failure);
    if (failure) refuse(path, failure.message());
    if (std::filesystem::is_directory(status)) refuse(path, std::strerror(EISDIR));
    if (!std::filesystem::is_regular_file(status))
        refuse(path, "it is a pipe, a socket or a device, allowed is a regular file");
}

/// The character that a byte is in Latin-1, where it is one that can be seen: the likely meaning.
std::string in_latin1(unsigned char byte) {
    if (byte <= 0xA0) return "";
    return fmt::format(" ('{}{}' in Latin-1)", static_cast<char>(0xC0 | byte >> 6),
                       static_cast<char>(0x80 | (byte & 0x3F)));
}

}  // namespace

std::string read_bytes(const std::filesystem::path& path, std::size_t most) {
    require_regular(path);
    std::ifstream file(path, std::ios::binary);
    if (!file) refuse(path, std::strerror(errno));
    std::string text;
    std::vector<char> part(1 << 16);
    do {
        file.read(part.data(), std::ssize(part));
        text.append(part.data(), static_cast<std::size_t>(file.gcount()));
        if (text.size() > most)
            throw InputError({fmt::format("{0}: found a file of more than {1} bytes, allowed at most {1}",
                                          printable(path.string(), most_of_path), most)});
    } while (file);
    if (file.bad()) refuse(path, std::strerror(errno));
    return text;
}

std::string read_text(const std::filesystem::path& path, std::size_t most) {
    std::string text = read_bytes(path, most);
    if (text.starts_with(byte_order_mark)) text.erase(0, byte_order_mark.size());
    require_text(text, printable(path.string(), most_of_path));
    return text;
}

std::string fault_of_text(std::string_view text, std::size_t& at) {
    at = 0;
    if (text.starts_with("\xff\xfe") || text.starts_with("\xfe\xff"))
        return "text in UTF-16, allowed text in UTF-8";
    for (; at < text.size();) {
        const auto [code, bytes] = first_character(text.substr(at));
        const auto byte = static_cast<unsigned char>(text[at]);
        if (bytes == 0)
            return fmt::format("the byte 0x{:02X}{}, allowed text in UTF-8", byte, in_latin1(byte));
        if (code == 0) return "a NUL byte, allowed text in UTF-8";
        if (code < 0x20 && code != '\t' && code != '\n' && code != '\r')
            return fmt::format("the control character 0x{:02X}, allowed text in UTF-8", byte);
        at += bytes;
    }
    return {};
}

void require_text(std::string_view text, const std::string& name) {
    std::size_t at = 0;
    const std::string fault = fault_of_text(text, at);
    if (!fault.empty()) throw InputError({fmt::format("{}:{}: found {}", name, place_in(text, at), fault)});
}

std::string place_in(std::string_view text, std::size_t offset) {
    text = text.substr(0, offset);
    const auto line = 1 + std::ranges::count(text, '\n');
    const auto start = text.rfind('\n') == text.npos ? 0 : text.rfind('\n') + 1;
    return fmt::format("{}:{}", line, 1 + characters_in(text.substr(start)));
}

std::string printable(std::string_view text, std::size_t most) {
    std::string shown;
    std::size_t characters = 0;
    for (std::size_t at = 0; at < text.size(); ++characters) {
        if (characters == most) return fmt::format("{}... ({} bytes)", shown, text.size());
        const auto [code, bytes] = first_character(text.substr(at));
        if (bytes == 0)
            shown += fmt::format("<0x{:02X}>", static_cast<unsigned char>(text[at]));
        else if (is_invisible(code))
            shown += fmt::format("<U+{:04X}>", static_cast<std::uint32_t>(code));
        else
            shown += text.substr(at, bytes);
        at += std::max<std::size_t>(bytes, 1);
    }
    return shown;
}

std::size_t blank_at_start(std::string_view text) {
    if (text.empty()) return 0;
    if (text[0] == ' ' || text[0] == '\t' || text[0] == '\n' || text[0] == '\r') return 1;
    const auto [code, bytes] = first_character(text);
    return is_other_space(code) ? bytes : 0;
}

std::optional<double> finite_number(std::string_view text) {
    text = trimmed(text);
    if (text.starts_with('+')) text.remove_prefix(1);
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value))
        return std::nullopt;
    return value;
}

std::string_view trimmed(std::string_view text) {
    while (const std::size_t blank = blank_at_start(text)) text.remove_prefix(blank);
    std::size_t end = 0;
    for (std::size_t at = 0; at < text.size();) {
        if (const std::size_t blank = blank_at_start(text.substr(at))) {
            at += blank;
        } else {
            at += std::max<std::size_t>(first_character(text.substr(at)).bytes, 1);
            end = at;
        }
    }
    return text.substr(0, end);
}

}  // namespace weavefront::scene
