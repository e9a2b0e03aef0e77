// One sitting, put together from its streams of chance.
#include "protocols/schedule.h"

#include "protocols/digest.h"
#include "protocols/main_order.h"
#include "protocols/practice.h"
#include "protocols/seeds.h"
#include "protocols/sides.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

namespace protocols {

namespace {

/// A warm-up must not give away one of this many trials that follow it.
constexpr int unseen_main_trials = 3;

/// How often an order is drawn again because an earlier session had it; a study that needs more has
/// hardly any orders.
constexpr int retries = 100;

struct SeededOrder {
    MainOrder order;
    Seed seed{};
    bool new_to_observer = true;
};

/// The order of one session, other than those of the sessions before it.
SeededOrder draw_order(const Study& study,
                       const ObserverId& observer,
                       int session,
                       std::span<const Question> questions,
                       std::span<const SeededOrder> earlier) {
    SeededOrder drawn;
    for (int retry = 0; retry <= retries; ++retry) {
        drawn.seed = stream_seed(study, observer, session, Purpose::Order, retry);
        Rng rng(drawn.seed);
        drawn.order = draw_main_order(questions, study.plan.repetitions, rng);
        drawn.new_to_observer =
            std::none_of(earlier.begin(), earlier.end(), [&](const auto& other) {
                return other.order.questions == drawn.order.questions;
            });
        if (drawn.new_to_observer)
            break;
    }
    return drawn;
}

Side opposite(Side side) {
    return side == Side::Left ? Side::Right : Side::Left;
}

void mirror(std::vector<Side>& sides) {
    std::transform(sides.begin(), sides.end(), sides.begin(), opposite);
}

/// Sides of every question's first condition, [repetition][question]: a repetition mirrors the one
/// before it, and the third is drawn anew.
std::vector<std::vector<Side>>
draw_all_sides(std::span<const Question> questions, int repetitions, Rng& rng) {
    std::vector<Comparison> comparisons;
    for (const auto& question : questions)
        comparisons.push_back({question.scene, question.first, question.second});
    std::vector<std::vector<Side>> sides;
    for (int repetition = 0; repetition < repetitions; ++repetition) {
        if (repetition % 2 == 0) {
            sides.push_back(draw_sides(comparisons, rng));
        } else {
            sides.push_back(sides.back());
            mirror(sides.back());
        }
    }
    return sides;
}

/// Places of the training for the easy and the hard pair, where the study names them and there is
/// room; the easy one comes first where there is room for one only.
Wanted draw_wanted(const Study& study, Rng& rng) {
    std::vector<int> places(static_cast<std::size_t>(study.plan.training));
    std::iota(places.begin(), places.end(), 0);
    Wanted wanted;
    for (const auto& pair : {study.plan.easy_pair, study.plan.hard_pair}) {
        if (!pair || places.empty())
            continue;
        const auto chosen =
            places.begin() + static_cast<std::ptrdiff_t>(draw_below(rng, places.size()));
        wanted[*chosen] = [&study, pair](const Question& question) {
            const auto named = [&](int condition) {
                return std::count(pair->begin(), pair->end(),
                                  study.conditions[static_cast<std::size_t>(condition)].id) > 0;
            };
            return named(question.first) && named(question.second);
        };
        places.erase(chosen);
    }
    return wanted;
}

struct WarmUps {
    std::vector<std::size_t> questions;
    bool gives_main_trials_away = false;
};

WarmUps draw_warm_ups(std::span<const Question> questions,
                      const std::vector<std::size_t>& main,
                      int count,
                      Rng& rng) {
    std::vector<std::size_t> pool(questions.size());
    std::iota(pool.begin(), pool.end(), std::size_t{0});
    // The nearest main trials are kept out first, and as many as leave enough to draw from.
    for (std::size_t i = 0; i < std::min<std::size_t>(main.size(), unseen_main_trials); ++i)
        if (static_cast<int>(pool.size()) > count)
            std::erase(pool, main[i]);
    const auto next_scene = questions[main.front()].scene;
    WarmUps warm_ups{draw_practice(questions, pool, count, next_scene, rng)};
    for (std::size_t i = 0; i < std::min<std::size_t>(main.size(), unseen_main_trials); ++i)
        warm_ups.gives_main_trials_away |=
            std::count(warm_ups.questions.begin(), warm_ups.questions.end(), main[i]) > 0;
    return warm_ups;
}

/// All pairs give every scene equally many questions, so only a single scene follows itself.
std::string describe_scene_rule(const Study& study, const MainOrder& order) {
    if (order.equal_neighbours == 0)
        return "no two neighbours share a scene";
    return fmt::format("all {} main trials show the only scene '{}'", order.questions.size(),
                       study.scenes.front().id.value);
}

std::string describe_rules(const Study& study, const SeededOrder& drawn, const WarmUps& warm_ups) {
    auto words = describe_scene_rule(study, drawn.order);
    if (drawn.order.close_repeats > 0)
        words += fmt::format("; {} questions return within {} trials, too few others lie between",
                             drawn.order.close_repeats, repeat_gap);
    if (warm_ups.gives_main_trials_away)
        words += fmt::format("; a warm-up returns among the first {} main trials, the study has "
                             "too few questions to avoid it",
                             unseen_main_trials);
    if (!drawn.new_to_observer)
        words += "; the order is that of an earlier session, the study has too few orders";
    return words;
}

void append(Schedule& schedule, Phase phase, Trial trial) {
    schedule.trials.push_back(
        {static_cast<int>(schedule.trials.size()) + 1, phase, std::move(trial)});
}

Side draw_side(Rng& rng) {
    return draw_coin(rng) ? Side::Left : Side::Right;
}

} // namespace

Expected<Schedule> make_schedule(const Study& study,
                                 const ObserverId& observer,
                                 int session,
                                 const std::optional<ObserverId>& partner) {
    const auto& plan = study.plan;
    if (session < 1 || session > plan.sessions)
        return tl::unexpected(fmt::format("study '{}' has no session {}, expected 1 to {}",
                                          study.id, session, plan.sessions));
    if (observer.value.empty())
        return tl::unexpected(
            std::string("the observer has no name, expected a pseudonym such as 'P7K2M'"));
    const auto questions = all_questions(study);
    if (questions.empty() || plan.repetitions < 1)
        return tl::unexpected(fmt::format(
            "study '{}' asks nothing: {} scenes, {} conditions and {} repetitions, expected at "
            "least 1, 2 and 1",
            study.id, study.scenes.size(), study.conditions.size(), plan.repetitions));

    std::vector<SeededOrder> orders;
    for (int number = 1; number <= session; ++number)
        orders.push_back(draw_order(study, observer, number, questions, orders));
    const auto& main = orders.back().order.questions;

    const bool is_even = session % 2 == 0; // it mirrors the session before
    const auto sides_seed = stream_seed(study, partner.value_or(observer),
                                        is_even ? session - 1 : session, Purpose::Sides);
    Rng sides_rng(sides_seed);
    auto sides = draw_all_sides(questions, plan.repetitions, sides_rng);
    if (is_even != partner.has_value())
        std::for_each(sides.begin(), sides.end(), mirror);

    Rng warm_up_rng(stream_seed(study, observer, session, Purpose::WarmUp));
    const auto warm_ups = draw_warm_ups(questions, main, plan.warm_ups, warm_up_rng);

    Rng training_rng(stream_seed(study, observer, session, Purpose::Training));
    std::vector<std::size_t> all(questions.size());
    std::iota(all.begin(), all.end(), std::size_t{0});

    Schedule schedule;
    const auto wanted = draw_wanted(study, training_rng);
    for (const auto i : draw_practice(questions, all, plan.training, {}, training_rng, wanted))
        append(schedule, Phase::Training, trial(study, questions[i], draw_side(training_rng)));
    for (const auto i : warm_ups.questions)
        append(schedule, Phase::WarmUp, trial(study, questions[i], draw_side(warm_up_rng)));
    std::vector<std::size_t> asked(questions.size()); // how often so far
    for (const auto i : main)
        append(schedule, Phase::Main, trial(study, questions[i], sides[asked[i]++][i]));

    schedule.generator = Rng::name;
    schedule.order_seed = hexadecimal(orders.back().seed);
    schedule.sides_seed = hexadecimal(sides_seed);
    schedule.equal_neighbours = orders.back().order.equal_neighbours;
    schedule.scene_rule = describe_rules(study, orders.back(), warm_ups);
    return schedule;
}

} // namespace protocols
