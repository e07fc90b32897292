// SPDX-License-Identifier: Apache-2.0
// Effects of added and removed nodes on momentum, energy and tension of wires.
#include "validate/tools.h"
#include "validate/wires.h"

#include <hawser/catenary.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace hawser::validate {
namespace {

constexpr double kLineMass = 23.0, kLineEA = 2.33e8;  // kg/m, N

/// Numbers in [0, 1), the same on every machine.
class Dice {
  public:
    explicit Dice(std::uint64_t seed) : state_(seed) {}
    double next() {
        state_ = state_ * 6364136223846793005u + 1442695040888963407u;
        return static_cast<double>(state_ >> 11) * 0x1p-53;
    }
    std::size_t random_below(std::size_t n) {
        return static_cast<std::size_t>(next() * static_cast<double>(n));
    }

  private:
    std::uint64_t state_;
};

/// Integrals over the straight elements of a wire, half a step before the poses.
struct Possession {
    double mass = 0.0, energy = 0.0;
    Vec3 linear{0, 0, 0}, angular{0, 0, 0};
};

Possession possession(const World& w, WireId wire) {
    Possession sum;
    const double half = 0.5 * w.settings().step;
    for (const BodyId id : w.wires().nodes(wire)) sum.mass += w.body_def(id).mass;
    for (const InteractionId id : w.wires().elements(wire)) {
        const InteractionDef& d = w.interaction_def(id);
        Vec3 x[2], v[2];
        for (std::size_t b = 0; b < 2; ++b) {
            v[b] = w.velocity(d.body[b]).linear;
            x[b] = w.pose(d.body[b]).position - half * v[b];
        }
        const double m = d.get("mass"), rest = d.get("length");
        sum.linear += 0.5 * m * (v[0] + v[1]);
        sum.angular +=
            m / 6.0 *
            (2.0 * x[0].cross(v[0]) + x[0].cross(v[1]) + x[1].cross(v[0]) + 2.0 * x[1].cross(v[1]));
        sum.energy += m / 6.0 * (v[0].squaredNorm() + v[0].dot(v[1]) + v[1].squaredNorm());
        const double longer = std::max(0.0, (x[1] - x[0]).norm() - rest);
        sum.energy += 0.5 * d.get("EA") / rest * longer * longer;
    }
    return sum;
}

/// 200 m of free wire: it rotates about z, translates, and has two waves of 1 m along it.
struct FreeWire {
    World w{{.gravity = Vec3::Zero()}};
    WireId wire;
    /// Build the wire. @param spin  Angular velocity [rad/s]
    FreeWire(int elements, double spin) {
        constexpr double kLength = 200.0;  // m
        const double l = kLength / elements;
        const auto place = [&](int i) {
            const double s = l * i - 0.5 * kLength;
            return Vec3(s, 0.0, std::sin(4.0 * kPi * s / kLength));
        };
        std::vector<BodyId> lumps;
        for (int i = 0; i <= elements; ++i) {
            BodyDef b{.kind = BodyKind::lump, .position = place(i)};
            b.mass = kLineMass * l * (i == 0 || i == elements ? 0.5 : 1.0);
            b.velocity = Vec3(0, 0, spin).cross(b.position) + Vec3(1.0, 2.0, 0.5);
            lumps.push_back(w.add_body(b));
        }
        std::vector<InteractionId> made;
        for (std::size_t i = 0; i + 1 < lumps.size(); ++i) {
            InteractionDef d;
            d.kind = InteractionKind::Stretch;
            d.body = {lumps[i], lumps[i + 1]};
            // Tension of steady rotation: T = ρω²(L²/4 − s²)/2.
            const double s = l * (static_cast<double>(i) + 0.5) - 0.5 * kLength;
            const double pull = 0.5 * kLineMass * spin * spin * (0.25 * kLength * kLength - s * s);
            const double separation =
                (w.pose(lumps[i + 1]).position - w.pose(lumps[i]).position).norm();
            d.set("length", separation / (1.0 + pull / kLineEA))
                .set("EA", kLineEA)
                .set("mass", kLineMass * l);
            made.push_back(w.add_interaction(d));
        }
        wire = w.wires().adopt("free", made);
    }
};

/// Effects of the edits.
struct Edits {
    long in = 0, out = 0, later = 0;
    double created = 0.0, lost = 0.0;  ///< Energy created and lost [J].
    Vec3 angular{0, 0, 0};             ///< Change of angular momentum [N m s].
};

/// Add or remove a node at a random position.
void edit(FreeWire& f, Dice& dice, Edits& sum) {
    constexpr std::size_t kMinimum = 20, kMaximum = 96;
    constexpr double kShortest = 2.0;  // m
    const auto elements = f.w.wires().elements(f.wire);
    const std::size_t n = elements.size(), k = 1 + dice.random_below(n - 2);
    const bool in = dice.next() < 0.5;
    const double share = 0.3 + 0.4 * dice.next();
    const Possession before = possession(f.w, f.wire);
    if (in) {
        if (f.w.interaction_def(elements[k]).get("length") < kShortest || n >= kMaximum) return;
        (void)f.w.wires().insert_node(elements[k], share);
        ++sum.in;
    } else if (n > kMinimum) {
        ++(f.w.wires().remove_node(f.w.wires().nodes(f.wire)[k]) ? sum.out : sum.later);
    }
    const Possession after = possession(f.w, f.wire);
    const double change = after.energy - before.energy;
    (change > 0.0 ? sum.created : sum.lost) += std::abs(change);
    sum.angular += after.angular - before.angular;
}

/// Check momentum, angular momentum and energy of a free wire while nodes are inserted and removed.
/// @param steps_too  True: also check that the steps between the edits conserve angular momentum.
void check_free_wire(Report& report, double spin, bool steps_too) {
    constexpr long kEditCount = 10'000;
    FreeWire f(40, spin);
    advance(f.w, 60);
    Dice dice(7);
    Edits sum;
    const Possession before = possession(f.w, f.wire);
    while (sum.in + sum.out < kEditCount) {
        edit(f, dice, sum);
        advance(f.w, 1);
    }
    const Possession after = possession(f.w, f.wire);
    const auto what = [&](const char* quantity) {
        return fmt::format("{}, {} rad/s", quantity, spin);
    };
    const std::string done =
        fmt::format("{} came, {} went, {} were to stay", sum.in, sum.out, sum.later);
    report.compare(what("mass [kg]"), {before.mass}, {after.mass}, 1e-12, done);
    report.compare(what("momentum [kg m/s]"), list(before.linear), list(after.linear), 1e-12,
                   "round-off");
    report.compare(what("angular momentum by edits [kg m2/s]"), list(Vec3::Zero()),
                   list(sum.angular), 1e-12, "round-off", before.angular.norm());
    if (steps_too)
        report.compare(what("angular momentum [kg m2/s]"), list(before.angular),
                       list(after.angular), 3e-4, "second order in the step");
    report.compare(what("energy made [J]"), {0.0}, {sum.created}, 1e-9, "none", before.energy);
    report.compare(what("energy lost [J]"), {0.0}, {sum.lost}, 5e-3,
                   "what no motion there can take", before.energy);
    report.compare(what("worst grade"), {static_cast<double>(Grade::good)},
                   {static_cast<double>(f.w.verdict().grade)}, 0.0, "judged good", 1.0);
}

/// A wire at rest between two ends with a tension at the upper one.
struct Resting {
    World w{WorldDef{}};
    WireId wire;
    Resting(double pull, double element) {
        CatenaryDef shape;
        shape.from = Vec3(0, 0, 0);
        shape.to = Vec3(190, 0, 50);
        const int n = static_cast<int>(std::lround(200.0 / element));
        double low = 150.0, high = 400.0;  // m; the longer, the less it pulls
        Catenary c;
        for (int i = 0; i < 60; ++i) {
            const double length = 0.5 * (low + high);
            shape.sections = {
                {.length = length, .weight = kLineMass * kGravity, .EA = kLineEA, .elements = n}};
            c = catenary(shape);
            const bool less = c.tension.back() < pull;
            (less ? high : low) = length;
        }
        WireDef def;
        def.name = "wire";
        def.from = w.add_body({.name = "from", .kind = BodyKind::fixed, .position = shape.from});
        def.to = w.add_body({.name = "to", .kind = BodyKind::fixed, .position = shape.to});
        def.elements = n;
        def.length = shape.sections[0].length;
        def.EA = kLineEA;
        def.mass_per_length = kLineMass;
        def.consistent_mass = true;
        def.path.assign(c.nodes.begin() + 1, c.nodes.end() - 1);
        wire = w.wires().add(def);
    }
    [[nodiscard]] double tension_at_end() const {
        return tension(w, w.wires().elements(wire).back());
    }
    /// Return the largest change of that tension in half a second [N].
    double largest_change() {
        const double before = tension_at_end();
        double most = 0.0;
        for (int i = 0; i < 30; ++i) {
            advance(w, 1);
            most = std::max(most, std::abs(tension_at_end() - before));
        }
        return most;
    }
};

/// Check a wire at rest. Add a node in the middle of each element and remove it again. Then remove
/// one of the wire's own nodes.
void check_resting(Report& report, double pull, double element) {
    Resting r(pull, element);
    advance(r.w, 60);
    const double allowed = std::max(0.003 * r.tension_at_end(), 50.0);
    double worst[3] = {0.0, 0.0, 0.0};
    long stayed = 0;
    const std::size_t n = r.w.wires().elements(r.wire).size();
    for (std::size_t k = 1; k + 2 < n; k += std::max<std::size_t>(1, n / 5)) {
        const BodyId node = r.w.wires().insert_node(r.w.wires().elements(r.wire)[k], 0.5);
        worst[0] = std::max(worst[0], r.largest_change());
        if (!r.w.wires().remove_node(node, kPi)) ++stayed;
        worst[1] = std::max(worst[1], r.largest_change());
        if (!r.w.wires().remove_node(r.w.wires().nodes(r.wire)[k + 1], kPi)) ++stayed;
        worst[2] = std::max(worst[2], r.largest_change());
        (void)r.w.wires().insert_node(r.w.wires().elements(r.wire)[k], 0.5);
        worst[0] = std::max(worst[0], r.largest_change());
    }
    const std::string what = fmt::format("{:.0f} kN, elements of {} m", pull / 1e3, element);
    const char* names[3] = {"a node comes", "it goes", "another one goes"};
    for (std::size_t k = 0; k < 3; ++k)
        report.compare(fmt::format("change of tension, {}, {} [N]", names[k], what), {0.0},
                       {worst[k]}, 1.0, "max(0.3 %, 50 N)", allowed);
    report.compare(fmt::format("nodes that stayed, {}", what), {0.0}, {static_cast<double>(stayed)},
                   0.0, "all go", 1.0);
}

}  // namespace

void case_wire_events(Report& report) {
    check_free_wire(report, 0.1, true);
    // At a hundred times the tension short elements are fast, and the guard over such wires keeps
    // no angular momentum (docs/theory/wires.md).
    check_free_wire(report, 0.5, false);
    for (const double pull : {41e3, 198e3, 999e3})
        for (const double element : {2.5, 5.0, 10.0, 20.0}) check_resting(report, pull, element);
}

}  // namespace hawser::validate
