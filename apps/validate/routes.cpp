// SPDX-License-Identifier: Apache-2.0
// Lines that run over posts and sheaves: Euler's ratio and tackles.
#include "validate/cases.h"
#include "validate/tools.h"

#include <hawser/route.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace hawser::validate {
namespace {

constexpr double kStep = 1.0 / 60.0, kEA = 2.33e8, kRub = 0.3;
constexpr double kHalfWide = 0.5, kHang = 5.0;

/// Two weights on a line over a post with `places` turning points, which moves or not. The second
/// weight is `share` of the limit of the friction.
class Post {
  public:
    World w{WorldDef{.step = kStep}};
    Route line;
    double ratio, light;
    int factorisations = 0;

    Post(int places, double turns, double light_in, double share, bool moves, double damping)
        : ratio(std::exp(kRub * 2.0 * kPi * turns)), light(light_in) {
        // The damping of the weights refers to the post's velocity, so that results do not depend
        // on its motion.
        const Vec3 speed = moves ? Vec3(0.5, 0.3, 0.2) : Vec3::Zero();
        const BodyId post = w.add_body({.name = "post",
                                        .kind = moves ? BodyKind::kinematic : BodyKind::fixed,
                                        .velocity = speed});
        const auto weight = [&](double x, double mass) {
            return w.add_body({.kind = BodyKind::lump,
                               .position = {x, 0, -kHang},
                               .velocity = speed,
                               .mass = mass,
                               .force = damping * mass * speed,
                               .linear_damping = Vec3::Constant(damping * mass)});
        };
        first_ = weight(-kHalfWide, light);
        second_ = weight(kHalfWide, light * share * ratio);
        RouteDef def{.EA = kEA,
                     .first = {.body = first_},
                     .last = {.body = second_},
                     .tension = light * kGravity,
                     .damping_time = 0.3};
        for (int i = 0; i < places; ++i) {
            const double s = places == 1 ? 0.5 : static_cast<double>(i) / (places - 1);
            const double top = places == 1 ? 0.0 : 0.3 * std::sin(kPi * s);
            RoutePlace p{.body = post,
                         .point = {(2.0 * s - 1.0) * kHalfWide, 0, top},
                         .friction = kRub,
                         .angle = 2.0 * kPi * turns / places};
            // A single turning point is the post as a cylinder: its legs hang vertically.
            if (places == 1) {
                p.radius = kHalfWide;
                p.turns = static_cast<int>(std::floor(turns));
            }
            def.places.push_back(p);
        }
        line = w.add(def);
    }
    void run(double seconds) {
        for (long i = std::lround(seconds / kStep); i > 0; --i) {
            advance(w, 1);
            factorisations = std::max(factorisations, w.stats().factorisations);
        }
    }
    [[nodiscard]] double slide_distance() const { return w.pose(line.slides.front()).position.x(); }
    /// Return the length of line that has run through each turning point [m].
    [[nodiscard]] std::vector<double> slides() const {
        std::vector<double> out;
        for (const BodyId id : line.slides) out.push_back(w.pose(id).position.x());
        return out;
    }
    [[nodiscard]] double falls() const { return -w.velocity(second_).linear.z(); }
    [[nodiscard]] double tensions() const {
        return w.force(line.parts.back())[0] / w.force(line.parts.front())[0];
    }

  private:
    BodyId first_, second_;
};

struct Kind {
    int places;
    double turns, light;
    bool moves;
    [[nodiscard]] std::string name() const {
        return fmt::format("{} places, {:g} turns, {:g} kg, {}", places, turns, light,
                           moves ? "moving" : "fixed");
    }
};

std::vector<Kind> kinds() {
    std::vector<Kind> out;
    for (const bool moves : {false, true})
        for (const int places : {1, 2, 8, 64})
            for (const double turns : {0.5, 1.5, 3.0})
                for (const double light : {5.0, 200.0})
                    out.push_back({places, turns, light, moves});
    return out;
}

}  // namespace

void check_posts(Report& report) {
    constexpr double kNear = 1e-5;
    double begins = 0.0, slides = 0.0, falls = 0.0, drift = 0.0;
    int most = 0;
    for (const Kind& k : kinds()) {
        Post below(k.places, k.turns, k.light, 1.0 - kNear, k.moves, 0.3),
            above(k.places, k.turns, k.light, 1.0 + kNear, k.moves, 0.3);
        for (Post* p : {&below, &above}) p->run(60.0);
        const double held = below.slide_distance(), ran = above.slide_distance();
        for (Post* p : {&below, &above}) p->run(5.0);
        // It would move at the speed at which the weights' damping balances the excess load.
        const double too_much = kNear * kGravity * above.ratio;
        const double speed = too_much / (0.3 * 2.0 * above.ratio);
        if (std::abs(below.slide_distance() - held) > 1e-9) begins = 1.0;
        if (!(std::abs(above.slide_distance() - ran) > 0.5 * speed * 5.0)) begins = 1.0;
        Post beyond(k.places, k.turns, k.light, 1.1, k.moves, 0.0);
        beyond.run(3.0);  // the lighter one has not reached the post
        slides = std::max(slides, std::abs(beyond.tensions() / beyond.ratio - 1.0));
        const double before = beyond.falls();
        beyond.run(1.0);
        const double expected = kGravity * 0.1 / 2.1;
        falls = std::max(falls, std::abs((beyond.falls() - before) / expected - 1.0));
        Post near(k.places, k.turns, k.light, 0.99, k.moves, 0.3);
        near.run(20.0);
        const std::vector<double> start = near.slides();
        near.run(100.0);
        const std::vector<double> end = near.slides();
        for (std::size_t i = 0; i < end.size(); ++i)
            drift = std::max(drift, std::abs(end[i] - start[i]));
        for (const Post* p : {&below, &above, &beyond, &near})
            most = std::max(most, p->factorisations);
    }
    report.compare("posts: holds at 1 - 1e-5, slides at 1 + 1e-5 of e^(mu theta) [1: it does not]",
                   {0.0}, {begins}, 1e-12,
                   "1, 2, 8, 64 places, half, 1.5, 3 turns, 5 and 200 kg, fixed and moving", 1.0);
    report.compare("posts: tensions where it slides, over e^(mu theta)", {1.0}, {1.0 + slides},
                   1e-5, "largest; slides have a millionth of the lightest mass");
    report.compare("posts: acceleration at 1.1 of it", {1.0}, {1.0 + falls}, 1e-3, "largest");
    report.compare("posts: drift at 0.99 of it in 100 s [m]", {0.0}, {drift}, 1e-9,
                   "largest of all places", 1.0);
    // The limit is exact: a count has no rounding.
    report.compare("posts: most factorisations in a step", {8.0}, {std::max(8.0, 1.0 * most)}, 1e-9,
                   fmt::format("at most {}, absolute", most), 1.0);
}

namespace {

constexpr double kDeep = 20.0, kLead = 10.0, kLoad = 20e3;

/// A load on so many parts of a line, hauled at a speed from a lead block at the top.
class Tackle {
  public:
    World w{WorldDef{.step = kStep}};
    Route line;
    BodyId load;

    Tackle(int parts, double efficiency, double mass, double speed, double damping_time) {
        const BodyId top = w.add_body({.name = "top", .kind = BodyKind::fixed});
        load = w.add_body(
            {.name = "load", .kind = BodyKind::lump, .position = {0, 0, -kDeep}, .mass = mass});
        const BodyId hand = w.add_body({.name = "hand",
                                        .kind = BodyKind::kinematic,
                                        .position = {kLead, 0, 0},
                                        .velocity = {speed, 0, 0}});
        RouteDef def{.EA = kEA, .last = {.body = hand}, .damping_time = damping_time};
        def.first.body = parts % 2 == 0 ? top : load;
        for (int i = 0; i < parts; ++i) {
            const bool above = (parts - 1 - i) % 2 == 0;
            def.places.push_back({.body = above ? top : load, .efficiency = efficiency});
        }
        double sum = 0.0;
        for (int i = 0; i < parts; ++i) sum += std::pow(efficiency, i);
        def.tension = mass * kGravity / sum;
        line = w.add(def);
    }
    [[nodiscard]] double pull() const { return -w.force(line.parts.back())[0]; }
    [[nodiscard]] double height() const { return w.pose(load).position.z(); }
};

}  // namespace

void case_tackle(Report& report) {
    double lead = 0.0, speed = 0.0, bounce = 0.0;
    for (int n = 2; n <= 16; ++n) {
        for (const double eta : {0.98, 0.962, 0.917})
            for (const double v : {0.4, -0.4}) {
                Tackle t(n, eta, kLoad, v, 0.1);
                advance(t.w, std::lround(8.0 / kStep));
                const double from = t.height();
                double sum = 0.0;
                const long steps = std::lround(4.0 / kStep);
                for (long i = 0; i < steps; ++i) {
                    advance(t.w, 1);
                    sum += t.pull();
                }
                const double whole = std::pow(eta, n), weight = kLoad * kGravity;
                const double expected = v > 0.0 ? weight * (1.0 - eta) / (eta * (1.0 - whole))
                                                : weight * whole * (1.0 - eta) / (1.0 - whole);
                lead = std::max(lead, std::abs(sum / static_cast<double>(steps) / expected - 1.0));
                speed = std::max(speed, std::abs((t.height() - from) / 4.0 / (v / n) - 1.0));
            }
        // Without friction the whole line is one spring.
        const double mass = 100.0 * kLoad;
        const double length = (n * kDeep + kLead) / (1.0 + mass * kGravity / (n * kEA));
        Tackle t(n, 1.0, mass, 0.0, 0.0);
        const Twist push{Vec3(0, 0, -0.01), Vec3::Zero()};
        t.w.set_velocity(t.load, push);
        std::vector<double> z;
        const double rest = t.height();
        for (long i = std::lround(30.0 / kStep); i > 0; --i) {
            z.push_back(t.height() - rest);
            advance(t.w, 1);
        }
        const std::vector<double> zeros = upward_zeros(z, kStep);
        const double period =
            (zeros.back() - zeros.front()) / static_cast<double>(zeros.size() - 1);
        const double expected = n * std::sqrt(kEA / (length * mass)) / (2.0 * kPi);
        bounce = std::max(bounce, std::abs(1.0 / period / expected - 1.0));
    }
    report.compare(
        "tackle: pull of the lead line over its closed form", {1.0}, {1.0 + lead}, 1e-4,
        "largest; 2 to 16 parts, 0.98, 0.962, 0.917, raising and lowering, means of 4 s");
    report.compare("tackle: speed of the load times parts over that of the line", {1.0},
                   {1.0 + speed}, 1e-4, "largest; means of 4 s");
    report.compare("tackle: frequency of the load on its parts", {1.0}, {1.0 + bounce}, 5e-3,
                   "largest; n sqrt(EA/(L m))/(2 pi); second order in the step");
}

}  // namespace hawser::validate
