#pragma once
/// @file
/// How a command ends early. scene::InputError ends with exit status 2, every other exception with 3.

#include <stdexcept>

namespace weavefront::app {

/// A run stopped by the physics or numerics guard, exit status 1.
class GuardStop : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

/// A run that was asked to stop, exit status 4.
class Interrupted : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

}  // namespace weavefront::app
