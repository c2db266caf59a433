#include "hash.hpp"

#include <fmt/format.h>

#include <cstdint>

namespace weavefront::scene {

std::string hash_of(std::string_view text) {
    std::uint64_t hash = 0xcbf29ce484222325;
    for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3;
    return fmt::format("{:016x}", hash);
}

}  // namespace weavefront::scene
