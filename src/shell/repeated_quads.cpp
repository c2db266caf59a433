#include "weavefront/shell/repeated_quads.hpp"

#include <cstring>

namespace weavefront::shell {

namespace {

bool same(const Quad<double>& one, const Quad<double>& other) {
    // Bits are compared. NOLINTNEXTLINE(bugprone-suspicious-memory-comparison)
    return std::memcmp(&one, &other, sizeof one) == 0;
}

/// The shortest repeat, from the length of the longest border of every beginning (Knuth, Morris and Pratt
/// 1977).
std::size_t period_of(std::span<const Quad<double>> quads) {
    std::vector<std::int32_t> border(quads.size(), 0);
    for (std::size_t i = 1; i < quads.size(); ++i) {
        auto length = static_cast<std::size_t>(border[i - 1]);
        while (length > 0 && !same(quads[i], quads[length]))
            length = static_cast<std::size_t>(border[length - 1]);
        border[i] = static_cast<std::int32_t>(same(quads[i], quads[length]) ? length + 1 : length);
    }
    return quads.size() - static_cast<std::size_t>(border.back());
}

}  // namespace

RepeatedQuads::RepeatedQuads(std::span<const Quad<double>> quads)
    : repeat_length_(static_cast<std::int32_t>(period_of(quads))),
      length_(static_cast<std::size_t>(repeat_length_ + simd::pack_width - 1)) {
    fields_.reserve(length_ * quad_size);
    const auto add = [&](double Quad<double>::*field) {
        for (std::size_t i = 0; i < length_; ++i)
            fields_.push_back(quads[i % static_cast<std::size_t>(repeat_length_)].*field);
    };
    using Q = Quad<double>;
    for (const auto field : {&Q::Bf1, &Q::Bf2, &Q::Bw1, &Q::Bw2, &Q::e1, &Q::e2, &Q::area, &Q::shape})
        add(field);
}

}  // namespace weavefront::shell
