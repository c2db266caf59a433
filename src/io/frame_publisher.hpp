#pragma once
/// @file
/// The step that makes a frame count.

#include <cstdint>
#include <string>

#include "hdf5_handle.hpp"

namespace weavefront::io {

/// Makes frames of a results file count. One process does it, with the file opened for itself, so that both
/// changes of a frame come from one process in their order and nothing lies between them, while the ranks
/// that write the data together never change metadata.
class FramePublisher {
  public:
    /// @param path of the file @throws FileError
    explicit FramePublisher(const std::string& path);

    /// Adds the time of frame `frame` and raises NSteps to `frame` + 1, one after the other, each a change of
    /// eight bytes in place. To be called when the data of the frame are with the operating system.
    /// @param time  simulated time of the frame, s
    /// @throws FileError
    void publish(std::int64_t frame, double time);

    /// Leaves only the first frames. @throws FileError
    void cut(std::int64_t frames);

    /// Waits until the file is on the disk. @throws FileError
    void sync() const;

    /// @throws FileError when `path` does not lead to the file
    void require_in_place(const std::string& path) const;

  private:
    void flush() const;
    [[nodiscard]] int descriptor() const;

    std::string doing_;
    H5File file_;
    H5Dataset times_;
    H5Group steps_;
    H5Attribute count_;
};

}  // namespace weavefront::io
