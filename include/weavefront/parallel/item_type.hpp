#pragma once
/// @file
/// An MPI datatype for items of any size.

#include <cstddef>

#include "weavefront/parallel/communicator.hpp"

namespace weavefront::parallel {

/// An item as one MPI element. Counts and displacements are then in items, far below the range of int.
class ItemType {
  public:
    explicit ItemType(std::size_t bytes) {
        check(MPI_Type_contiguous(static_cast<int>(bytes), MPI_BYTE, &type_));
        check(MPI_Type_commit(&type_));
    }
    ~ItemType() { MPI_Type_free(&type_); }
    ItemType(const ItemType&) = delete;
    ItemType& operator=(const ItemType&) = delete;

    [[nodiscard]] MPI_Datatype get() const { return type_; }

  private:
    MPI_Datatype type_ = MPI_DATATYPE_NULL;
};

}  // namespace weavefront::parallel
