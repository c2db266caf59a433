#pragma once
/// @file
/// Which state of the sources this program was built from.

namespace weavefront::app {

/// What `git describe` said of the sources when the build was configured; "unknown" outside of a repository.
extern const char* const revision;

}  // namespace weavefront::app
