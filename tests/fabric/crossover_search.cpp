/// The bracketed Newton search over a million random, degenerate and extreme states, against plain bisection.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

#include "weavefront/fabric/crimp.hpp"
#include "weavefront/simd/pack.hpp"

namespace weavefront::fabric {
namespace {

constexpr double span = 0.909e-3;
constexpr double moduli[] = {96e9, 192e9};

struct Case {
    double half_thickness;
    MidBalance<double> mid;
    [[nodiscard]] EndBalance<double> end() const { return {mid.bars}; }
};

/// States as a run meets them and states as it should never: crimp gone, broken, compressed, nearly flat,
/// torn to twice the size.
class Cases {
  public:
    Case draw() {
        Case result{};
        const double thickness[] = {0.82e-3, 0.4e-3, 1e-4, 1e-6, 1e-9, 1e-13};
        const double half = 0.5 * thickness[pick(6)];
        const double spread[] = {1e-4, 0.02, 0.3, 0.95};
        const double change = spread[pick(4)];
        Bars<double>& bars = result.mid.bars;
        result.half_thickness = half;
        const double heights[] = {0, half, half / 2, half * uniform(0, 1), half * 1e-9, half * (1 - 1e-12)};
        bars.h_f = heights[pick(6)];
        bars.h_w = half - bars.h_f;
        const double before_f = 0.5 * span * (1 + uniform(-0.1, 0.3)),
                     before_w = 0.5 * span * (1 + uniform(-0.1, 0.3));
        bars.a_f = before_f * (1 + uniform(-change, change));
        bars.a_w = before_w * (1 + uniform(-change, change));
        result.mid.a_mid_f = 0.5 * (before_f + bars.a_f);
        result.mid.a_mid_w = 0.5 * (before_w + bars.a_w);
        const double length = std::hypot(span / 2, half / 2);
        result.mid.sigma_f = law(bars.law_f, bar_length(before_f, bars.h_f), length);
        result.mid.sigma_w = law(bars.law_w, bar_length(before_w, bars.h_w), length);
        return result;
    }

  private:
    std::mt19937_64 random_{7};
    double uniform(double a, double b) { return std::uniform_real_distribution<double>(a, b)(random_); }
    std::size_t pick(std::size_t n) { return std::uniform_int_distribution<std::size_t>(0, n - 1)(random_); }

    /// @return stress at the start of the step
    double law(AxialLaw<double>& law, double before, double length) {
        const double stress[] = {0, 1e3, uniform(0, 5e9), uniform(-5e9, 5e9), uniform(-1e8, 1e8)};
        const double sigma = stress[pick(5)];
        if (pick(8) == 0) {  // broken
            law = {0, 0, before};
            return 0;
        }
        law = {sigma * uniform(0.9, 1), moduli[pick(2)] / length, before};
        return sigma;
    }
};

double sign(double x) { return x > 0 ? 1 : x < 0 ? -1 : 0; }

/// The definition, by halving only.
template <class Balance>
double by_bisection(const Balance& balance, double lower, double upper) {
    const double start = sign(balance(0.0).force);
    if (start == 0) return 0;
    double near = 0, far = start > 0 ? lower : upper;
    if (sign(balance(far).force) != -start) return far;
    for (int i = 0; i < 200; ++i) {
        const double middle = 0.5 * (near + far);
        (sign(balance(middle).force) == start ? near : far) = middle;
    }
    return 0.5 * (near + far);
}

/// Whether delta balances, or is the bound towards which the imbalance pushes.
template <class Balance>
bool answers(const Balance& balance, double lower, double upper, double half_thickness, double delta) {
    const double start = sign(balance(0.0).force);
    if (start == 0) return delta == 0;
    const double bound = start > 0 ? lower : upper;
    if (delta == bound) return sign(balance(bound).force) != -start || bound == 0;
    if (delta < std::min(0.0, bound) || delta > std::max(0.0, bound)) return false;
    // a sign change nearby, as far away as a root of order three may still be when its Newton steps have
    // become 1e-8
    const double reach = 4 * newton_tolerance * half_thickness;
    const double left = sign(balance(std::max(lower, delta - reach)).force),
                 right = sign(balance(std::min(upper, delta + reach)).force);
    return left * right <= 0;
}

struct Tally {
    int evaluations = 0, most = 0, compared = 0;
};

template <class Balance>
void check(const Case& state, const Balance& balance, Tally& tally) {
    const Bars<double>& bars = state.mid.bars;
    const double lower = -bars.h_f, upper = bars.h_w;
    int evaluations = 0;
    const double delta = balance_crossover(balance, lower, upper, state.half_thickness, &evaluations);
    ASSERT_LE(evaluations, evaluation_limit);
    tally.evaluations += evaluations;
    tally.most = std::max(tally.most, evaluations);
    ASSERT_TRUE(std::isfinite(delta));
    ASSERT_TRUE(answers(balance, lower, upper, state.half_thickness, delta))
        << delta << " in " << lower << ' ' << upper << " forces " << balance(0.0).force << ' '
        << balance(delta).force << " a " << bars.a_f << ' ' << bars.a_w << " offsets " << bars.law_f.offset
        << ' ' << bars.law_w.offset;
    // with both yarns in tension all the way the root is unique and well conditioned: the same to a square of
    // the last Newton step
    const auto shortest = [](const AxialLaw<double>& law, double a) { return law.stress(a); };
    const bool tension = std::min(shortest(bars.law_f, bars.a_f), shortest(bars.law_w, bars.a_w)) > 1e7 &&
                         std::min(state.mid.sigma_f, state.mid.sigma_w) > 1e7;
    if (tension) {
        ++tally.compared;
        ASSERT_NEAR(delta, by_bisection(balance, lower, upper), 1e-12 * state.half_thickness);
    }
}

TEST(CrossoverSearch, AMillionStates) {
    Cases cases;
    Tally end, mid;
    const int states = 1000000;
    for (int i = 0; i < states; ++i) {
        const Case state = cases.draw();
        check(state, state.end(), end);
        if (HasFatalFailure()) return;
        check(state, state.mid, mid);
        if (HasFatalFailure()) return;
    }
    EXPECT_GT(end.compared, states / 50);
    EXPECT_LT(end.evaluations, 10 * states);
    EXPECT_LT(mid.evaluations, 10 * states);
    RecordProperty("mean_evaluations_end_x100", static_cast<int>(100.0 * end.evaluations / states));
    RecordProperty("mean_evaluations_mid_x100", static_cast<int>(100.0 * mid.evaluations / states));
    RecordProperty("most_evaluations_end", end.most);
    RecordProperty("most_evaluations_mid", mid.most);
}

/// The balance of eight states, one per lane.
EndBalance<Pack> packed(const std::array<EndBalance<double>, 8>& lanes) {
    EndBalance<Pack> result{};
    const auto fill = [&lanes](auto member) {
        Pack pack;
        for (int i = 0; i < 8; ++i) pack.set(i, member(lanes[static_cast<std::size_t>(i)].bars));
        return pack;
    };
    using B = const Bars<double>&;
    result.bars = {fill([](B b) { return b.a_f; }),
                   fill([](B b) { return b.a_w; }),
                   fill([](B b) { return b.h_f; }),
                   fill([](B b) { return b.h_w; }),
                   {fill([](B b) { return b.law_f.offset; }), fill([](B b) { return b.law_f.slope; }),
                    fill([](B b) { return b.law_f.reference; })},
                   {fill([](B b) { return b.law_w.offset; }), fill([](B b) { return b.law_w.slope; }),
                    fill([](B b) { return b.law_w.reference; })}};
    return result;
}

TEST(CrossoverSearch, LanesDoNotFeelEachOther) {
    Cases cases;
    for (int n = 0; n < 50000; ++n) {
        std::array<EndBalance<double>, 8> lanes{};
        for (auto& lane : lanes) lane = cases.draw().end();
        const EndBalance<Pack> balance = packed(lanes);
        const double half = 0.41e-3;  // the tolerance; the bounds are each lane's own
        const Pack delta = balance_crossover(balance, Pack(-balance.bars.h_f), balance.bars.h_w, half);
        for (int i = 0; i < 8; ++i) {
            const EndBalance<double>& lane = lanes[static_cast<std::size_t>(i)];
            ASSERT_EQ(delta.get(i), balance_crossover(lane, -lane.bars.h_f, lane.bars.h_w, half));
        }
    }
}

TEST(CrossoverSearch, EndsForWhatIsNotANumber) {
    EndBalance<double> balance = Cases().draw().end();
    balance.bars.a_f = NAN;
    EXPECT_EQ(balance_crossover(balance, -1e-4, 1e-4, 1e-4), 0.0);
}

}  // namespace
}  // namespace weavefront::fabric
