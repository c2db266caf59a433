#include "weavefront/state/values.hpp"

#include <algorithm>
#include <array>

namespace weavefront::state {

namespace {

void require_length(std::string_view name, std::size_t found, std::size_t needed) {
    if (found != needed)
        throw Mismatch("it holds " + std::to_string(found) + " values of " + std::string(name) + ", " +
                       std::to_string(needed) + " are needed");
}

}  // namespace

void ValueWriter::sum(std::string_view name, std::int64_t& part) {
    std::array<std::int64_t, 1> whole{part};
    comm_->sum(whole);
    add(name, std::vector{whole[0]});
}

void ValueWriter::least(std::string_view name, std::span<double> list) {
    std::vector<double> least;
    for (const double value : list) least.push_back(comm_->min(value));
    add(name, least);
}

template <class Content>
const Content& ValueReader::get(std::string_view name) const {
    const auto found = std::ranges::find(*values_, name, &Value::name);
    const auto* content = found == values_->end() ? nullptr : std::get_if<Content>(&found->content);
    if (!content) throw Mismatch("it holds no " + std::string(name));
    return *content;
}

template <class Number>
Number ValueReader::one(std::string_view name) const {
    const auto& list = get<std::vector<Number>>(name);
    require_length(name, list.size(), 1);
    return list[0];
}

void ValueReader::operator()(std::string_view name, std::span<double> list) {
    const auto& found = get<std::vector<double>>(name);
    require_length(name, found.size(), list.size());
    std::ranges::copy(found, list.begin());
}

void ValueReader::operator()(std::string_view name, std::optional<double>& value) {
    const auto& list = get<std::vector<double>>(name);
    value = list.empty() ? std::nullopt : std::optional(list[0]);
}

template const std::vector<double>& ValueReader::get(std::string_view) const;
template const std::vector<std::int64_t>& ValueReader::get(std::string_view) const;
template const std::string& ValueReader::get(std::string_view) const;
template double ValueReader::one(std::string_view) const;
template std::int64_t ValueReader::one(std::string_view) const;

}  // namespace weavefront::state
