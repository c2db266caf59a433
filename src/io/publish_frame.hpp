#pragma once
/// @file
/// The step that makes a frame count.

#include <cstdint>
#include <string>

namespace weavefront::io {

/// Adds the time of frame `frame` to a results file and raises its NSteps to `frame` + 1, one after the other, each a change of eight
/// bytes in place. Called on one process when the data of the frame are on disk; it opens the file for itself, so that both changes come
/// from one process in this order and nothing lies between them, while the ranks that write the data together never change metadata.
/// @param path  of the file
/// @param time  simulated time of the frame, s
/// @throws FileError
void publish_frame(const std::string& path, std::int64_t frame, double time);

}  // namespace weavefront::io
