#pragma once
/// @file
/// Standard output closed for a while to a library that prints into it.

namespace weavefront::partition {

/// While it lives, what is written to standard output goes nowhere: METIS prints complaints of its own there
/// when it bisects a few columns ("Cannot bisect a graph with 0 vertices!"), which no option turns off, and
/// which are none: empty parts are filled afterwards.
class SilentOutput {
  public:
    SilentOutput();
    ~SilentOutput();
    SilentOutput(const SilentOutput&) = delete;
    SilentOutput& operator=(const SilentOutput&) = delete;

  private:
    int kept_ = -1;  // the file that standard output was; -1: left as it is
};

}  // namespace weavefront::partition
