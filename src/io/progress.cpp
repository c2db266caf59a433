#include "weavefront/io/progress.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <utility>

namespace weavefront::io {

namespace {

constexpr double redraw_interval = 0.2;  // s
constexpr double rounding = 1e-9;        // so that 0.1 + 0.2 of 0.3 is all of it

double steady_seconds() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

std::string bar(double fraction) {
    constexpr int width = 20;
    const auto full = static_cast<int>(std::floor(fraction * width));
    return fmt::format("[{:#<{}}{:.<{}}]", "", full, "", width - full);
}

}  // namespace

void RemainingTime::add(double time, double wall) {
    samples_.push_back({time, wall});
    while (samples_.size() > 2 && samples_[1].wall <= wall - window_) samples_.pop_front();
}

std::optional<double> RemainingTime::left() const {
    if (samples_.size() < 2) return std::nullopt;
    const auto& from = samples_.front();
    const auto& to = samples_.back();
    if (!(to.time > from.time && to.wall > from.wall)) return std::nullopt;
    return std::max(0.0, end_ - to.time) * (to.wall - from.wall) / (to.time - from.time);
}

Progress::Progress(Log& log, double end, Clock clock)
    : log_(log),
      end_(end),
      clock_(clock ? std::move(clock) : Clock(steady_seconds)),
      remaining_(end),
      drawn_at_(-std::numeric_limits<double>::infinity()) {}

void Progress::update(double time, std::int64_t step, std::string_view projectile) {
    const double now = clock_();
    const int tenths = static_cast<int>(std::floor(10 * fraction(time)));
    const bool milestone = tenths > tenths_;
    if (!milestone && now - drawn_at_ < redraw_interval) return;
    remaining_.add(time, now);
    drawn_at_ = now;
    tenths_ = std::max(tenths, tenths_);
    const std::string text = line(time, step, projectile);
    if (log_.interactive()) log_.draw(bar(fraction(time)) + text);
    if (!milestone) return;
    if (log_.interactive())
        log_.record(text);
    else
        log_.info(text);
}

double Progress::fraction(double time) const { return std::min(1.0, time / end_ + rounding); }

void Progress::finish() { log_.end_drawing(); }

std::string Progress::line(double time, std::int64_t step, std::string_view projectile) const {
    std::string text = fmt::format("{:4.0f} %  {:.2f} of {:.2f} us  step {}",
                                   std::floor(100 * fraction(time)), time * 1e6, end_ * 1e6, step);
    if (!projectile.empty()) text += fmt::format("  {}", projectile);
    if (const auto left = remaining_.left(); left && fraction(time) < 1)
        text += fmt::format("  {} left", duration_text(*left));
    return text;
}

std::string duration_text(double seconds) {
    const auto whole = static_cast<std::int64_t>(std::llround(seconds));
    if (whole < 60) return fmt::format("{} s", whole);
    if (whole < 3600) return fmt::format("{} min {:02} s", whole / 60, whole % 60);
    return fmt::format("{} h {:02} min", whole / 3600, whole % 3600 / 60);
}

}  // namespace weavefront::io
