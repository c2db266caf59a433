#pragma once
/// @file
/// Decisions taken from the bytes of an input, one after the other.

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>

namespace weavefront::fuzz {

/// Zeros follow after the last byte.
class Choices {
  public:
    explicit Choices(std::span<const std::uint8_t> bytes) : left_(bytes) {}

    [[nodiscard]] bool any() const { return !left_.empty(); }
    std::uint8_t byte() { return any() ? take(1)[0] : std::uint8_t{0}; }
    /// From 0 to `count` - 1.
    std::size_t below(std::size_t count) { return byte() % count; }
    /// Small numbers most of the time, and any other.
    std::int64_t number() {
        const auto small = static_cast<std::int8_t>(byte());
        if (small != -128) return small;
        std::int64_t value = 0;
        const auto bytes = take(sizeof(value));
        if (!bytes.empty()) std::memcpy(&value, bytes.data(), bytes.size());
        return value;
    }
    /// One of a list.
    template <class T, std::size_t N>
    const T& of(const std::array<T, N>& list) {
        return list[below(N)];
    }
    /// The next bytes, fewer where the input ends.
    std::span<const std::uint8_t> take(std::size_t count) {
        const auto taken = left_.first(std::min(count, left_.size()));
        left_ = left_.subspan(taken.size());
        return taken;
    }
    std::span<const std::uint8_t> rest() { return take(left_.size()); }

  private:
    std::span<const std::uint8_t> left_;
};

}  // namespace weavefront::fuzz
