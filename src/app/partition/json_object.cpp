#include "json_object.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <utility>

#include "weavefront/scene/read.hpp"
#include "weavefront/scene/text.hpp"

namespace weavefront::app {

namespace {

using nlohmann::json;

/// Reads a text and tells how far.
class CountingIterator {
  public:
    using iterator_category = std::input_iterator_tag;
    using value_type = char;
    using difference_type = std::ptrdiff_t;
    using pointer = const char*;
    using reference = const char&;

    CountingIterator(const char* at, std::size_t& read) : at_(at), read_(&read) {}
    reference operator*() const { return *at_; }
    CountingIterator& operator++() {
        ++at_;
        ++*read_;
        return *this;
    }
    bool operator==(const CountingIterator& other) const { return at_ == other.at_; }
    bool operator!=(const CountingIterator& other) const { return at_ != other.at_; }

  private:
    const char* at_;
    std::size_t* read_;
};

/// Keeps the members of the outermost object.
class MemberBuilder : public nlohmann::json_sax<json> {
  public:
    MemberBuilder(const std::string& text, const std::string& name, const std::size_t& read)
        : text_(text), name_(name), read_(read) {}

    std::vector<JsonMember> members;
    bool is_object = false;

    bool null() override { return keep(nullptr); }
    bool boolean(bool value) override { return keep(value); }
    bool number_integer(number_integer_t value) override { return keep(value); }
    bool number_unsigned(number_unsigned_t value) override { return keep(value); }
    bool number_float(number_float_t value, const string_t&) override { return keep(value); }
    bool string(string_t& value) override { return keep(value); }
    bool binary(binary_t&) override { return false; }
    bool start_object(std::size_t) override {
        is_object = is_object || depth_ == 0;
        return open(json::object());
    }
    bool end_object() override { return close(); }
    bool start_array(std::size_t) override { return open(json::array()); }
    bool end_array() override { return close(); }
    bool key(string_t& value) override {
        // Read up to its closing quote.
        if (depth_ == 1)
            members.push_back({value, where(read_ - std::min(read_, value.size() + 2)), nullptr});
        return true;
    }
    bool parse_error(std::size_t byte, const std::string&,
                     const nlohmann::detail::exception& error) override {
        const std::string said = error.what();
        const auto words = said.find(": ");
        throw scene::InputError(
            {fmt::format("{}: not JSON: {}", where(byte == 0 ? 0 : byte - 1),
                         scene::printable(words == said.npos ? said : said.substr(words + 2), 200))});
    }

  private:
    [[nodiscard]] std::string where(std::size_t offset) const {
        return fmt::format("{}:{}", name_, scene::place_in(text_, offset));
    }
    bool keep(json value) {
        if (depth_ == 1 && !members.empty()) members.back().value = std::move(value);
        return true;
    }
    bool open(json value) {
        keep(std::move(value));
        ++depth_;
        return true;
    }
    bool close() {
        --depth_;
        return true;
    }

    const std::string &text_, &name_;
    const std::size_t& read_;
    int depth_ = 0;
};

}  // namespace

std::vector<JsonMember> parse_json_object(const std::string& text, const std::string& name) {
    std::size_t read = 0;
    MemberBuilder builder(text, name, read);
    json::sax_parse(CountingIterator(text.data(), read), CountingIterator(text.data() + text.size(), read),
                    &builder);
    if (!builder.is_object)
        throw scene::InputError({fmt::format("{}:1:1: found no object, allowed a JSON object", name)});
    return std::move(builder.members);
}

}  // namespace weavefront::app
