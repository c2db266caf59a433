#pragma once
/// @file
/// Values that repeat from ply to ply.

#include <cstddef>
#include <vector>

namespace weavefront::mesh {

/// Values of the elements or nodes of a part that are equal in every ply. Only those of one ply are stored.
template <class T>
struct Repeated {
    std::vector<T> one_ply;

    [[nodiscard]] const T& operator[](std::size_t index) const { return one_ply[index % one_ply.size()]; }
};

}  // namespace weavefront::mesh
