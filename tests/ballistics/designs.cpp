#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "weavefront/ballistics/fit.hpp"
#include "weavefront/ballistics/limit_search.hpp"
#include "weavefront/ballistics/neyer_design.hpp"
#include "weavefront/ballistics/scatter.hpp"

namespace weavefront::ballistics {
namespace {

struct Searched {
    std::vector<Trial> trials;
    int rounds = 0;
    std::string failure;
};

/// A search against a target that answers each speed.
Searched search(const SearchPlan& plan, const std::function<Result(double)>& answer) {
    Searched found;
    for (;;) {
        const auto round = next_round(plan, found.trials);
        found.failure = round.failure;
        if (round.speeds.empty()) return found;
        EXPECT_LE(static_cast<int>(round.speeds.size()), std::max(plan.side_by_side, 1));
        for (const double speed : round.speeds) found.trials.push_back({speed, answer(speed)});
        if (++found.rounds > 60) ADD_FAILURE() << "does not end";
        if (found.rounds > 60) return found;
    }
}

std::function<Result(double)> target_of(double limit) {
    return [limit](double speed) { return speed > limit ? Result::complete : Result::partial; };
}

SearchPlan between(double from, double to, double width, int side_by_side = 1) {
    return {.from = from, .to = to, .width = width, .side_by_side = side_by_side};
}

void expect_bracket(const Searched& found, double limit, double width) {
    EXPECT_EQ(found.failure, "");
    const auto bracket = bracket_of(found.trials);
    ASSERT_TRUE(bracket.low && bracket.high);
    EXPECT_LE(*bracket.low, limit);
    EXPECT_GT(*bracket.high, limit);
    EXPECT_LE(*bracket.high - *bracket.low, width + 2 * speed_grain);
}

TEST(LimitSearch, BisectsBetweenItsEnds) {
    const auto found = search(between(200, 800, 5), target_of(431));
    expect_bracket(found, 431, 5);
    EXPECT_EQ(found.trials.front().speed, 500);
    EXPECT_EQ(found.trials.size(), 7U);  // 600 / 2^7 < 5
}

TEST(LimitSearch, CutsTheBracketByOnePartMoreThanThereAreGroups) {
    for (const int groups : {2, 3, 7}) {
        const auto found = search(between(200, 800, 5, groups), target_of(431));
        expect_bracket(found, 431, 5);
        EXPECT_EQ(found.rounds, static_cast<int>(std::ceil(std::log(120) / std::log(groups + 1))));
    }
}

TEST(LimitSearch, LooksForTheBracketFromItsStart) {
    for (const double limit : {3.0, 200.0, 359.0, 428.5, 700.0, 2000.0})
        for (const int groups : {1, 2, 5})
            expect_bracket(
                search({.start = 428, .step = 86, .width = 5, .side_by_side = groups}, target_of(limit)),
                limit, 5);
}

TEST(LimitSearch, ShootsAnEndThatTheLimitMayLieBeyond) {
    const auto below = search(between(200, 800, 5), target_of(150));
    EXPECT_EQ(below.failure, "the limit lies below 200.00 m/s, the lowest speed allowed");
    EXPECT_EQ(below.trials.size(), 3U);
    const auto above = search(between(200, 800, 5, 3), target_of(900));
    EXPECT_EQ(above.failure, "the limit lies above 800.00 m/s, the highest speed allowed");
    EXPECT_EQ(above.rounds, 3);
}

TEST(LimitSearch, DoublesItsStepsOutwards) {
    const SearchPlan plan{.start = 400, .step = 50, .width = 5, .side_by_side = 2};
    const std::vector<Trial> first{{375, Result::partial}, {425, Result::partial}};
    EXPECT_EQ(next_round(plan, {}).speeds, (std::vector<double>{375, 425}));
    EXPECT_EQ(next_round(plan, first).speeds, (std::vector<double>{475, 575}));
    auto second = first;
    second.push_back({475, Result::partial});
    second.push_back({575, Result::partial});
    EXPECT_EQ(next_round(plan, second).speeds, (std::vector<double>{675, 875}));
}

TEST(LimitSearch, EndsWhereNoSpeedPerforates) {
    const auto found = search({.start = 400, .step = 80, .width = 5}, target_of(1e9));
    EXPECT_EQ(found.failure, "no complete penetration up to 10000 m/s");
}

TEST(LimitSearch, GoesAroundASpeedWithoutResult) {
    expect_bracket(search(between(200, 800, 5),
                          [](double speed) { return speed == 500 ? Result::none : target_of(431)(speed); }),
                   431, 5);
}

TEST(LimitSearch, GivesUpAfterThreeShotsWithoutResultInTheBracket) {
    const auto found = search(between(200, 800, 5), [](double speed) {
        return speed > 300 && speed < 600 ? Result::none : target_of(431)(speed);
    });
    EXPECT_EQ(found.failure, "3 shots inside the bracket gave no result");
}

TEST(LimitSearch, CountsTheRoundsThatAreLeft) {
    EXPECT_EQ(rounds_left(between(200, 800, 5), {}), 7);
    const std::vector<Trial> trials{{500, Result::complete}, {350, Result::partial}};
    EXPECT_EQ(rounds_left(between(200, 800, 5), trials), 5);
}

/// A target of normal scatter whose draws are given.
std::vector<Shot> fire(const NeyerPlan& plan, double v50, double sigma, int count, int together = 1) {
    std::vector<Shot> shots;
    while (static_cast<int>(shots.size()) < count)
        for (const double speed : next_speeds(plan, shots, together)) {
            const ScatterLaw law{.path = "limit", .first = v50, .second = sigma};
            const auto text = drawn_setting(law, 7, static_cast<std::int64_t>(shots.size()));
            shots.push_back({speed, speed > std::stod(text.substr(text.find('=') + 1))});
        }
    return shots;
}

TEST(NeyerDesign, BeginsInTheMiddleAndHalvesTheGap) {
    const NeyerPlan plan{200, 600, 10};
    EXPECT_EQ(next_speeds(plan, {}, 1).front(), 400);
    const std::vector<Shot> one{{400, true}};
    EXPECT_EQ(next_speeds(plan, one, 1).front(), 300);
    const std::vector<Shot> both{{400, true}, {300, false}};
    EXPECT_EQ(next_speeds(plan, both, 1).front(), 350);
    EXPECT_EQ(next_speeds(plan, both, 3), (std::vector<double>{325, 350, 375}));
}

TEST(NeyerDesign, GoesBeyondAGuessThatIsWrong) {
    const std::vector<Shot> near{{400, false}};
    EXPECT_EQ(next_speeds({200, 410, 10}, near, 1).front(), 420);  // two deviations farther
    const NeyerPlan plan{200, 600, 10};
    std::vector<Shot> shots;
    for (int i = 0; i < 10; ++i) shots.push_back({next_speeds(plan, shots, 1).front(), false});
    EXPECT_GT(shots.back().speed, 800);
    EXPECT_LE(shots.back().speed, most_speed);
}

/// The D-optimal pair lies at 1.138 deviations on both sides of the median of a normal S-curve (Neyer 1994).
TEST(NeyerDesign, BalancesShotsAroundTheMedian) {
    // As many shots at +1.138 and at -1.138 as make this the most likely curve.
    const double z = 1.138, share = 0.5 * std::erfc(-z / std::sqrt(2.0));
    std::vector<Shot> shots;
    const int each = 1000;
    for (int i = 0; i < each; ++i) {
        shots.push_back({400 + 10 * z, i < share * each});
        shots.push_back({400 - 10 * z, i >= share * each});
    }
    const auto next = next_speeds({200, 600, 10}, shots, 2);
    EXPECT_NEAR(std::abs(next[0] - 400), 11.38,
                0.15);  // the grid of a hundredth and the rounding of the shares
    EXPECT_NEAR(next[0] + next[1], 800, 0.3);
}

TEST(NeyerDesign, FindsMedianAndDeviation) {
    for (const int together : {1, 4}) {
        const auto shots = fire({300, 520, 5}, 431, 12, 200, together);
        const auto found = std::get<Fit>(fit(shots, Distribution::normal, std::vector<double>{0.5}, 0.95));
        // Three deviations of D-optimal estimates from n shots: 1.48 sigma / sqrt(n) and 1.30 sigma /
        // sqrt(n).
        EXPECT_NEAR(found.response.v50, 431, 3 * 1.48 * 12 / std::sqrt(200));
        EXPECT_NEAR(found.response.sigma, 12, 3 * 1.30 * 12 / std::sqrt(200));
    }
}

TEST(Scatter, IsTheSameForTheSameSeedAndShot) {
    const auto law = std::get<ScatterLaw>(scatter_law_of("a.b=normal(3.3 %, 0.1 %)"));
    EXPECT_EQ(drawn_setting(law, 1, 1), drawn_setting(law, 1, 1));
    EXPECT_NE(drawn_setting(law, 1, 1), drawn_setting(law, 1, 2));
    EXPECT_NE(drawn_setting(law, 1, 1), drawn_setting(law, 2, 1));
    EXPECT_TRUE(drawn_setting(law, 1, 1).ends_with(" %"));
    EXPECT_EQ(drawn_setting(std::get<ScatterLaw>(scatter_law_of("a.seed=seed")), 100, 3), "a.seed=103");
}

TEST(Scatter, HasMomentsOfItsLaw) {
    constexpr int draws = 20'000;
    const auto normal = std::get<ScatterLaw>(scatter_law_of("a=normal(5 mm, 2 mm)"));
    const auto uniform = std::get<ScatterLaw>(scatter_law_of("a=uniform(-1, 3)"));
    double sum = 0, square = 0, flat = 0;
    for (int i = 0; i < draws; ++i) {
        const double x = std::stod(drawn_setting(normal, 3, i).substr(2));
        sum += x / draws;
        square += (x - 5) * (x - 5) / draws;
        const double u = std::stod(drawn_setting(uniform, 3, i).substr(2));
        EXPECT_TRUE(u > -1 && u < 3);
        flat += u / draws;
    }
    // Four standard errors: 2, 4 sqrt(2) and 4/sqrt(12), over the root of the draws.
    EXPECT_NEAR(sum, 5, 4 * 2 / std::sqrt(draws));
    EXPECT_NEAR(square, 4, 4 * 4 * std::sqrt(2.0) / std::sqrt(draws));
    EXPECT_NEAR(flat, 1, 4 * 4 / std::sqrt(12.0 * draws));
}

TEST(Scatter, RefusesALawThatIsNone) {
    for (const char* text : {"a", "=seed", "a=normal(1)", "a=normal(1 mm, 2 m)", "a=normal(1, 0)",
                             "a=uniform(2, 1)", "a=weibull(1, 2)", "a=normal(x, 1)", "a=normal(1, 2", "a="})
        EXPECT_TRUE(std::holds_alternative<std::string>(scatter_law_of(text))) << text;
}

}  // namespace
}  // namespace weavefront::ballistics
