// SPDX-License-Identifier: Apache-2.0
// A wire that breaks near crossing wires. Its recoiling and falling pieces pass through none of
// them, and no energy is created.
#include "validate/tools.h"
#include "validate/wires.h"

#include <hawser/hawser.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

namespace hawser::validate {
namespace {

constexpr double kTowMass = 23.0, kTowEA = 2.33e8, kTowHalf = 0.038;     // kg/m, N, m
constexpr long kPressed = 60, kSettled = 120, kFalls = 180, kMean = 30;  // steps of 1/60 s

/// A straight piece of a wire, from end to end [m].
using Piece = std::array<Vec3, 2>;

/// Return six times the volume of the tetrahedron of two pieces; 0 if they lie in a plane.
double crossing_volume(const Piece& a, const Piece& b) {
    return (a[1] - a[0]).cross(b[1] - b[0]).dot(b[0] - a[0]);
}

/// True if two pieces in a plane cross within both.
bool crosses(const Piece& a, const Piece& b) {
    const Vec3 u = a[1] - a[0], v = b[1] - b[0], n = u.cross(v), from = b[0] - a[0];
    const double s = from.cross(v).dot(n), t = from.cross(u).dot(n), all = n.squaredNorm();
    return s > 0.0 && s < all && t > 0.0 && t < all;
}

Piece pose_between(const std::array<Piece, 2>& x, double t) {
    return {x[0][0] + t * (x[1][0] - x[0][0]), x[0][1] + t * (x[1][1] - x[0][1])};
}

/// True if two pieces passed through each other from one pose to the next. Bisection finds the
/// moments at which they lie in a plane; they must cross at such a moment.
bool wires_passed(const std::array<Piece, 2>& a, const std::array<Piece, 2>& b) {
    constexpr int kParts = 32, kHalvings = 40;
    const auto volume = [&](double t) {
        return crossing_volume(pose_between(a, t), pose_between(b, t));
    };
    double last = volume(0.0);
    for (int k = 1; k <= kParts; ++k) {
        double low = static_cast<double>(k - 1) / kParts, high = static_cast<double>(k) / kParts;
        const double next = volume(high);
        if ((last > 0.0) != (next > 0.0)) {
            for (int i = 0; i < kHalvings; ++i) {
                const double middle = 0.5 * (low + high);
                ((volume(middle) > 0.0) == (last > 0.0) ? low : high) = middle;
            }
            if (crosses(pose_between(a, low), pose_between(b, low))) return true;
        }
        last = next;
    }
    return false;
}

/// True if the boxes around the motions of two pieces are separate.
bool boxes_separate(const std::array<Piece, 2>& a, const std::array<Piece, 2>& b) {
    const auto least = [](const std::array<Piece, 2>& x) {
        return x[0][0].cwiseMin(x[0][1]).cwiseMin(x[1][0].cwiseMin(x[1][1])).eval();
    };
    const auto most = [](const std::array<Piece, 2>& x) {
        return x[0][0].cwiseMax(x[0][1]).cwiseMax(x[1][0].cwiseMax(x[1][1])).eval();
    };
    return (least(a).array() > most(b).array()).any() || (least(b).array() > most(a).array()).any();
}

/// A taut wire along x, and up to three crossing wires that move to it from above or below and
/// press on it.
struct Crossed {
    // Loose ends whip: in a step they move farther than their previous speed predicts.
    World w{WorldDef{.step = 1.0 / 60.0, .contact_margin = 0.5}};
    std::vector<WireId> wires;  ///< Wires, first those of the broken one.
    std::vector<std::pair<BodyId, double>>
        ends;  ///< Ends of the other wires, and their speeds of approach [m/s].

    explicit Crossed(Chance& chance) {
        const double length = chance.between(40.0, 60.0);
        wires.push_back(add(length, chance.between(2.0, 4.0), pull(chance), Vec3::Zero(), 0.0));
        const int others = 1 + static_cast<int>(3.0 * chance.next());
        for (int k = 0; k < others; ++k) {
            const double along = (chance.between(0.2, 0.35) + 0.3 * k - 0.5) * length;
            const double turn = chance.between(0.17, 0.83) * kPi;
            const double side = chance.next() < 0.5 ? -1.0 : 1.0, gap = 0.02;
            const Vec3 middle(along, chance.between(-4.0, 4.0), side * (2.0 * kTowHalf + gap));
            const std::size_t before = ends.size();
            wires.push_back(add(chance.between(20.0, 40.0), chance.between(2.0, 4.0), pull(chance),
                                middle, turn));
            const double press = gap + chance.between(0.0, 0.4);
            for (std::size_t i = before; i < ends.size(); ++i)
                ends[i].second = -side * press / (kPressed * w.settings().step);
        }
    }
    static double pull(Chance& chance) {
        return std::exp(chance.between(10.8, 13.8));
    }  // 49-985 kN

    /// Add a straight wire through `middle` in the plane of x and y.
    WireId add(double length, double element, double tension, const Vec3& middle, double turn) {
        const Vec3 half = 0.5 * length * Vec3(std::cos(turn), std::sin(turn), 0.0);
        WireDef def;
        def.elements = static_cast<int>(std::lround(length / element));
        def.name = "wire" + std::to_string(wires.size());
        for (const double way : {-1.0, 1.0}) {
            const BodyId end =
                w.add_body({.kind = BodyKind::kinematic, .position = middle + way * half});
            (way < 0.0 ? def.from : def.to) = end;
            if (turn != 0.0) ends.emplace_back(end, 0.0);
        }
        def.length = length / (1.0 + tension / kTowEA);
        def.EA = kTowEA;
        def.mass_per_length = kTowMass;
        def.drag = 20.0;
        def.consistent_mass = true;
        def.radius = kTowHalf;
        return w.wires().add(def);
    }
    /// Move the other wires until they press on the wire, and let it settle.
    void settle() {
        for (const auto& [end, speed] : ends)
            w.set_velocity(end, {.linear = Vec3(0, 0, speed), .angular = Vec3::Zero()});
        advance(w, kPressed);
        for (const auto& end : ends) w.set_velocity(end.first, {});
        advance(w, kSettled);
    }
    /// Break the wire directly or by a cut, at a random position between its second and its last
    /// but one element.
    void break_wire(Chance& chance) {
        const auto elements = w.wires().elements(wires[0]);
        const double share = chance.between(1.5, static_cast<double>(elements.size()) - 1.5);
        if (chance.next() < 0.5)
            w.wires().part(elements[static_cast<std::size_t>(share)]);
        else
            wires.push_back(w.wires().cut(wires[0], w.wires().length(wires[0]) * share /
                                                        static_cast<double>(elements.size())));
    }
};

/// An element with a capsule: nodes at both ends.
struct Segment {
    InteractionId element;
    std::size_t wire = 0;    ///< Index of the wire; 0: the broken one.
    std::array<Piece, 2> x;  ///< Ends at both poses.
};

void sample(const Crossed& c, std::size_t pose, std::vector<Segment>& out) {
    if (pose == 0) out.clear();
    for (std::size_t k = 0, i = 0; k < c.wires.size(); ++k)
        for (const InteractionId id : c.w.wires().elements(c.wires[k])) {
            const InteractionDef& d = c.w.interaction_def(id);
            if (!c.w.intact(id) || c.w.body_def(d.body[0]).kind != BodyKind::lump ||
                c.w.body_def(d.body[1]).kind != BodyKind::lump)
                continue;
            const bool parted =
                k == 0 || c.w.wires().name(c.wires[k]).find('/') != std::string::npos;
            const Piece now{c.w.pose(d.body[0]).position, c.w.pose(d.body[1]).position};
            if (pose == 0) out.push_back({id, parted ? 0 : k, {now, now}});
            out[i++].x[pose] = now;
        }
}

/// Return the energy of wires from the forces that they exert [J]. A piece that rotates fast is
/// longer at a pose than its tension implies (docs/limits.md).
double elastic_energy_from_forces(const Crossed& c) {
    double sum = 0.0;
    for (const WireId wire : c.wires)
        for (const InteractionId id : c.w.wires().elements(wire)) {
            const double pull = c.w.intact(id) ? c.w.force(id)[0] : 0.0;
            sum += 0.5 * pull * pull * c.w.interaction_def(id).get("length") / kTowEA;
        }
    return sum;
}

struct Outcome {
    int through = 0;         ///< Number of pairs of segments that passed through each other.
    bool touched = false;    ///< True if they touched before the wire breaks.
    double made = 0.0;       ///< Created energy as a mean over half a second [J].
    double exchanged = 0.0;  ///< Largest kinetic and elastic energy of the wires [J].
    Grade grade = Grade::good;
};

Outcome run_crossed(Chance& chance) {
    Crossed c(chance);
    c.settle();
    Outcome out;
    for (const ContactView& contact : c.w.contacts())
        out.touched = out.touched || contact.force.norm() > 0.0;
    c.break_wire(chance);
    std::vector<Segment> segments;
    std::optional<double> least;
    double mean = 0.0;
    std::array<double, kMean> past{};
    for (long i = 0; i < kFalls; ++i) {
        sample(c, 0, segments);
        advance(c.w, 1);
        sample(c, 1, segments);
        for (std::size_t a = 0; a < segments.size(); ++a)
            for (std::size_t b = a + 1; b < segments.size(); ++b)
                if (segments[a].wire != segments[b].wire &&
                    !boxes_separate(segments[a].x, segments[b].x))
                    out.through += wires_passed(segments[a].x, segments[b].x) ? 1 : 0;
        const Energy e = c.w.energy();
        const double by_force = elastic_energy_from_forces(c),
                     now = e.kinetic + e.gravity + by_force;
        // In single steps forces oscillate when a loose end becomes taut.
        mean += (now - (i < kMean ? mean : past[static_cast<std::size_t>(i % kMean)])) /
                static_cast<double>(i < kMean ? i + 1 : kMean);
        past[static_cast<std::size_t>(i % kMean)] = now;
        least = std::min(least.value_or(mean), mean);
        out.made = std::max(out.made, mean - *least);
        out.exchanged = std::max(out.exchanged, e.kinetic + by_force);
    }
    out.grade = c.w.verdict().grade;
    return out;
}

}  // namespace

void case_wire_cross_parting(Report& report) {
    constexpr int kCases = 100;
    Chance chance(9);
    int through = 0, touched = 0, doubtful = 0, wrong = 0;
    double made = 0.0;
    for (int i = 0; i < kCases; ++i) {
        const Outcome one = run_crossed(chance);
        through += one.through > 0 ? 1 : 0;
        touched += one.touched ? 1 : 0;
        doubtful += one.grade == Grade::doubtful ? 1 : 0;
        wrong += one.grade == Grade::wrong ? 1 : 0;
        made = std::max(made, one.made / one.exchanged);
    }
    const auto count = [&](const char* what, double expected, int found, double limit,
                           const char* reason) {
        report.compare(fmt::format("{}, of {}", what, kCases), {expected},
                       {static_cast<double>(found)}, limit, reason, kCases);
    };
    count("wires went through each other", 0.0, through, 0.0, "capsules bear");
    count("touched by another before it parts", kCases, touched, 0.15,
          "under slack wires those above hang free");
    count("judged wrong", 0.0, wrong, 0.0, "none");
    count("judged doubtful", 0.0, doubtful, 0.02, "loose ends that crack like whips");
    report.compare("energy made, the most of all, of what wires held", {0.0}, {made}, 0.009,
                   "as of judges; mean over 0.5 s", 1.0);
}

}  // namespace hawser::validate
