#pragma once
/// @file
/// Output times.

#include <cmath>
#include <string>

namespace weavefront::app {

/// Times 0, interval, 2 interval, ...: each is due at the first step at or after it.
class OutputSchedule {
  public:
    explicit OutputSchedule(double interval) : interval_(interval) {}

    /// True once for every time passed.
    bool due(double time) {
        if (time < next_ * interval_ || next_ < 0) return false;
        next_ = after(time);
        return true;
    }

    /// @param asked last time for which `due` was asked, s: where the interval is another one than that of
    /// what is read, times follow it
    template <class Archive>
    void state(Archive& archive, const std::string& name, double asked) {
        double interval = interval_, next = next_;
        archive(name + ".interval", interval);
        archive(name + ".next", next);
        next_ = interval == interval_ ? next : after(asked);
    }

  private:
    [[nodiscard]] double after(double time) const {
        return interval_ > 0 ? std::floor(time / interval_) + 1 : -1;
    }
    double interval_, next_ = 0;
};

}  // namespace weavefront::app
