#pragma once
/// @file
/// Signals that ask the program to end, and those that would end it where it can speak for itself.

#include <string>

namespace weavefront::app {

/// From now on a write beyond a limit of file size, or to a reader that has gone, fails instead of ending the
/// program.
void ignore_failed_writes();

/// From now on SIGTERM, SIGINT, SIGUSR1 and SIGUSR2 are noted instead of ending the program; a second SIGINT
/// ends it at once.
void note_signals();

/// The first signal that was noted; 0: none.
int noted_signal();

/// SIGTERM, ...
std::string name_of_signal(int signal);

}  // namespace weavefront::app
