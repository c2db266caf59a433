#pragma once
/// @file
/// What can go wrong between a run and its files.

#include <stdexcept>

namespace weavefront::io {

/// A file or directory could not be created, read or written; the text names it. Thrown with the same text on
/// all ranks.
class FileError : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

/// A value on its way to a file is infinite or not a number; the text names the file and the quantity. Thrown
/// with the same text on all ranks, before anything of the row or frame is written.
class NotFinite : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

}  // namespace weavefront::io
