// SPDX-License-Identifier: Apache-2.0
/// Wires whose resolution follows tension, curvature and contact: limits, hysteresis, accounts,
/// threads, restored states, rejected definitions. Tensions at edits are checked by `hawser
/// validate wire_resolution`.
#include <hawser/catenary.h>
#include <hawser/hawser.h>

#include "support/sanitizer.h"
#include "support/tier.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <vector>

namespace hawser::test::resolution {
namespace {

constexpr double kPerMetre = 23.0, kEA = 2.33e8;  // kg/m, N

/// A wire at rest between two ends of one height.
struct Hung {
    World w;
    WireId wire{};
    BodyId end{};

    Hung(double length, int elements, double pull, int threads = 1, double drag = 20.0)
        : w(WorldDef{.step = 1.0 / 60.0, .threads = threads}) {
        const double weight = kPerMetre * 9.81, sag = weight * length / pull;
        CatenaryDef shape;
        shape.to = Vec3(length * (1.0 + pull / kEA - sag * sag / 24.0), 0, 0);
        shape.sections = {{length, weight, kEA, elements}};
        const Catenary start = catenary(shape);
        WireDef def;
        def.name = "wire";
        def.from = w.add_body({.name = "from", .kind = BodyKind::fixed});
        def.to = end =
            w.add_body({.name = "to", .kind = BodyKind::kinematic, .position = shape.to});
        def.elements = elements;
        def.length = length;
        def.EA = kEA;
        def.mass_per_length = kPerMetre;
        def.drag = drag;
        def.consistent_mass = true;
        def.path.assign(start.nodes.begin() + 1, start.nodes.end() - 1);
        wire = w.wires().add(def);
    }
    Hung& with(ResolutionDef def) {
        def.name = "nodes";
        def.wire = wire;
        w.add(def);
        return *this;
    }
    void run(double seconds) {
        for (long i = std::lround(60.0 * seconds); i > 0; --i) ASSERT_EQ(w.step(), Status::ok);
    }
    [[nodiscard]] double get(const char* signal) const {
        return w.system_signal(std::string("nodes.") + signal);
    }
    [[nodiscard]] double edits() const { return get("inserted") + get("removed"); }
    /// Return the lengths of elements, from their mass [m].
    [[nodiscard]] std::vector<double> lengths() const {
        std::vector<double> out;
        for (const InteractionId id : w.wires().elements(wire))
            out.push_back(w.interaction_def(id).get("mass") / kPerMetre);
        return out;
    }
    /// Return the mass of nodes and of half elements at the ends [kg].
    [[nodiscard]] double mass() const {
        double sum = 0.5 * kPerMetre * (lengths().front() + lengths().back());
        for (const BodyId id : w.wires().nodes(wire))
            if (w.body_def(id).kind == BodyKind::lump) sum += w.body_def(id).mass;
        return sum;
    }
};

double longest(const Hung& h) {
    const auto all = h.lengths();
    return *std::max_element(all.begin(), all.end());
}
double shortest(const Hung& h) {
    const auto all = h.lengths();
    return *std::min_element(all.begin(), all.end());
}

TEST(WireResolution, DividesLongElements) {
    Hung h(400.0, 5, 999e3);
    h.with({.min_length = 2.5, .max_length = 20.0});
    h.run(10.0);
    EXPECT_LE(longest(h), 20.0);
    EXPECT_EQ(h.lengths().size(), 20U) << "80 m by halves";
    EXPECT_EQ(h.get("inserted"), 15.0);
    EXPECT_EQ(h.get("nodes"), 21.0);
    EXPECT_NEAR(h.get("material"), 400.0, 1e-10) << "an account";
    EXPECT_NEAR(h.mass(), 400.0 * kPerMetre, 1e-8);
}

TEST(WireResolution, MakesShortElementsOne) {
    Hung h(400.0, 160, 999e3);
    h.with({.min_length = 2.5, .max_length = 20.0});
    h.run(60.0);
    EXPECT_GE(shortest(h), 10.0);
    EXPECT_LE(longest(h), 20.0);
    EXPECT_NEAR(h.get("material"), 400.0, 1e-10);
    EXPECT_NEAR(h.mass(), 400.0 * kPerMetre, 1e-8);
    EXPECT_EQ(h.get("removed"), 161.0 - h.get("nodes"));
}

/// Bounds of sag, angle and waves, each alone, on a wire with known curvature w/H and tension.
TEST(WireResolution, KeepsToEachBound) {
    constexpr double kPull = 41e3, kCurvature = kPerMetre * 9.81 / kPull;
    const double sag = std::sqrt(8.0 * 0.05 / kCurvature), angle = 0.06 / kCurvature,
                 wave = 1.5 * std::sqrt(kPull / kPerMetre) / 8.0;
    struct Row {
        ResolutionDef def;
        double bound;
    };
    const ResolutionDef none{.min_length = 0.5,
                             .max_length = 100.0,
                             .sag_error = 0.0,
                             .max_angle = 0.0,
                             .wave_period = 0.0};
    std::vector<Row> rows(3, Row{none, 0.0});
    rows[0].def.sag_error = 0.05, rows[0].bound = sag;
    rows[1].def.max_angle = 0.06, rows[1].bound = angle;
    rows[2].def.wave_period = 1.5, rows[2].bound = wave;
    for (const Row& row : rows)
        for (const int elements : {3, 200}) {
            Hung h(200.0, elements, kPull);
            h.with(row.def);
            h.run(60.0);
            // Tension and curvature differ along the wire: T = H + w z, 16 % here. Coarsening stops
            // within the bound; refinement stops at a node that would exceed the bound over the
            // hysteresis.
            EXPECT_LE(longest(h), 1.1 * row.bound) << elements;
            const auto all = h.lengths();
            for (std::size_t i = 0; i + 1 < all.size(); ++i)
                EXPECT_GE(all[i] + all[i + 1], row.bound / 1.5 / 1.35) << elements << ", " << i;
        }
}

TEST(WireResolution, DoesNotChatter) {
    for (const double pull : {41e3, 198e3, 999e3})
        for (const int elements : {8, 60}) {
            Hung h(150.0, elements, pull);
            h.with({});
            h.run(40.0);
            const double settled = h.edits();
            h.run(60.0);
            EXPECT_EQ(h.edits(), settled) << pull << ", " << elements;
        }
}

/// Return a resolution for an oscillating end, so that bounds by waves and by sag apply in turn.
ResolutionDef lively() {
    return {.min_length = 1.5,
            .max_length = 12.0,
            .wave_period = 1.0,
            .averaging = 0.3,
            .hysteresis = 1.05,
            .patience = 0.1,
            .interval = 3};
}
void swing(Hung& h, int step) {
    Twist t;
    t.linear = Vec3(0.27 * std::cos(0.012 * step), 0.8 * std::sin(0.05 * step), 0);
    h.w.set_velocity(h.end, t);
    ASSERT_EQ(h.w.step(), Status::ok);
}

TEST(WireResolution, IsTheSameOnAnyThreads) {
    std::uint64_t hash = 0;
    for (const int threads : {1, 2, 4, 8}) {
        Hung h(120.0, 30, 90e3, threads);
        h.with(lively());
        for (int i = 0; i < 1000; ++i) swing(h, i);
        EXPECT_GT(h.get("inserted"), 20.0);
        EXPECT_GT(h.get("removed"), 20.0);
        EXPECT_NEAR(h.get("material"), 120.0, 1e-9);
        if (threads == 1) hash = h.w.state().hash();
        EXPECT_EQ(h.w.state().hash(), hash) << threads;
    }
}

/// From random steps, and from those before and after an edit, in a twin made at that step.
TEST(WireResolution, GoesOnAfterRestore) {
    constexpr int kSteps = test::kSanitized ? 400 : 1000;
    std::mt19937 random(first_seed(7));
    const int restores = by_tier(3, 8, 100);
    const int every = by_tier(14, 7, 1);  // of the steps with edits
    std::vector<int> at;
    for (int i = 0; i < restores; ++i)
        at.push_back(std::uniform_int_distribution(1, kSteps - 1)(random));
    Hung h(120.0, 30, 90e3);
    h.with(lively());
    struct Saved {
        int step;
        World twin;
        std::vector<std::byte> state;
    };
    std::vector<Saved> saved;
    double edits = 0.0;
    int of_edits = 0;
    for (int i = 0; i < kSteps; ++i) {
        World before = h.w.twin();
        auto state = h.w.state().save();
        swing(h, i);
        const bool edited = h.edits() != edits;
        edits = h.edits();
        if (std::find(at.begin(), at.end(), i) != at.end() || (edited && i % every == 0)) {
            saved.push_back({i, std::move(before), std::move(state)});
            of_edits += edited ? 1 : 0;
        }
    }
    ASSERT_GT(of_edits, 1);
    for (Saved& s : saved) {
        Hung& again = h;
        std::swap(again.w, s.twin);
        again.w.state().restore(s.state);
        for (int i = s.step; i < kSteps; ++i) swing(again, i);
        EXPECT_EQ(again.w.state().hash(), s.twin.state().hash()) << "from step " << s.step;
        std::swap(again.w, s.twin);
    }
}

TEST(WireResolution, TellsWhereNodesRunOut) {
    Hung h(400.0, 5, 999e3);
    h.with({.min_length = 2.5, .max_length = 20.0, .max_nodes = 12});
    h.run(10.0);
    EXPECT_EQ(h.get("nodes"), 12.0);
    const EventExtremes events = h.w.events().extremes(EventKind::node_limit);
    EXPECT_EQ(events.count, 1) << "once";
    EXPECT_EQ(events.first.value, 12.0);
    EXPECT_TRUE(h.w.alive(events.first.body));
}

TEST(WireResolution, LeavesAloneWhatSomethingHolds) {
    Hung h(400.0, 40, 999e3);
    const BodyId held = h.w.wires().nodes(h.wire)[17];
    const BodyId weight = h.w.add_body(
        {.kind = BodyKind::lump, .position = h.w.pose(held).position - Vec3(0, 0, 1), .mass = 5.0});
    h.w.add(DistanceDef{.a = held, .b = weight});
    h.with({.sag_error = 0.0, .max_angle = 0.0});
    h.run(40.0);
    EXPECT_LE(h.get("nodes"), 24.0);
    EXPECT_TRUE(h.w.alive(held));
    const auto nodes = h.w.wires().nodes(h.wire);
    EXPECT_NE(std::find(nodes.begin(), nodes.end(), held), nodes.end());
}

TEST(WireResolution, IsCoarserByOrder) {
    double nodes[2];
    for (const int level : {0, 2}) {
        Hung h(400.0, 80, 198e3);
        h.with({});
        for (int i = 0; i < 1800; ++i) {
            h.w.solver().degrade_next_step({.wires = level});
            EXPECT_EQ(h.w.solver().coarsening(), level);
            ASSERT_EQ(h.w.step(), Status::ok);
            EXPECT_EQ(h.w.stats().degradation.wires, level);
        }
        nodes[level / 2] = h.get("nodes");
        h.run(30.0);
        EXPECT_GE(h.get("nodes"), nodes[0]) << "finer again";
    }
    EXPECT_LT(nodes[1], 0.6 * nodes[0]);
}

TEST(WireResolution, RefusesWhatCannotBe) {
    Hung h(100.0, 10, 2e5);
    const auto refused = [&](const ResolutionDef& changes, const char* part) {
        ResolutionDef def = changes;
        def.name = "nodes";
        def.wire = h.wire;
        try {
            h.w.add(def);
        } catch (const DefError& error) {
            EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
            return;
        }
        ADD_FAILURE() << "taken: " << part;
    };
    refused({.min_length = 2.5, .max_length = 4.0}, "twice min_length");
    refused({.min_length = 0.0}, "min_length = 0");
    refused({.max_nodes = 2}, "max_nodes");
    refused({.sag_error = -1.0}, "sag_error");
    refused({.sag_error = std::nan("")}, "sag_error");
    refused({.max_angle = 4.0}, "max_angle");
    refused({.contact_length = 1.0}, "contact_length");
    refused({.drum_length = 50.0}, "drum_length");
    refused({.points_per_wave = 1.0}, "points_per_wave");
    refused({.hysteresis = 0.9}, "hysteresis");
    refused({.interval = 0}, "interval");
    refused({.mass_per_length = -1.0}, "mass_per_length");
    EXPECT_EQ(h.w.system_count(), 0);
    h.with({});
    EXPECT_THROW(h.with({}), DefError) << "the name";
    EXPECT_THROW(h.w.add(ResolutionDef{.name = "other", .wire = h.wire}), DefError);
    EXPECT_THROW(h.w.add(ResolutionDef{.name = "none"}), DefError);
    World plain;
    const BodyId top = plain.add_body({.kind = BodyKind::fixed});
    const WireId lumps = plain.wires().add({.name = "lumps",
                                            .from = top,
                                            .elements = 5,
                                            .length = 10,
                                            .EA = 1e6,
                                            .mass_per_length = 1});
    EXPECT_THROW(plain.add(ResolutionDef{.name = "nodes", .wire = lumps}), DefError);
}

}  // namespace
}  // namespace hawser::test::resolution
