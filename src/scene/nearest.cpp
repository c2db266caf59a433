#include "weavefront/scene/nearest.hpp"

#include <algorithm>
#include <cctype>
#include <vector>

namespace weavefront::scene {
namespace {

// Far longer than any name: the distance takes time and memory of the product of both lengths.
constexpr std::size_t longest_word = 100;

// Optimal string alignment distance.
std::size_t edit_distance(std::string_view a, std::string_view b) {
    std::vector<std::vector<std::size_t>> d(a.size() + 1, std::vector<std::size_t>(b.size() + 1));
    for (std::size_t i = 0; i <= a.size(); ++i) d[i][0] = i;
    for (std::size_t j = 0; j <= b.size(); ++j) d[0][j] = j;
    for (std::size_t i = 1; i <= a.size(); ++i) {
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const std::size_t substitution = a[i - 1] == b[j - 1] ? 0 : 1;
            d[i][j] = std::min({d[i - 1][j] + 1, d[i][j - 1] + 1, d[i - 1][j - 1] + substitution});
            const bool swapped = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
            if (swapped) d[i][j] = std::min(d[i][j], d[i - 2][j - 2] + 1);
        }
    }
    return d[a.size()][b.size()];
}

std::string in_lower_case(std::string_view word) {
    std::string lower(word);
    std::ranges::transform(lower, lower.begin(), [](unsigned char c) { return std::tolower(c); });
    return lower;
}

}  // namespace

std::string nearest(std::string_view word, std::span<const std::string> names) {
    std::string best;
    if (word.size() > longest_word) return best;
    std::size_t least = word.size() + 1;
    for (const std::string& name : names) {
        const std::size_t distance = edit_distance(in_lower_case(word), in_lower_case(name));
        const std::size_t near = std::max<std::size_t>(1, std::max(word.size(), name.size()) / 3);
        if (distance <= near && distance < std::min(least, name.size())) {
            least = distance;
            best = name;
        }
    }
    return best;
}

}  // namespace weavefront::scene
