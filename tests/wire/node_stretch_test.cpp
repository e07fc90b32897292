// SPDX-License-Identifier: Apache-2.0
/// Nodes next to a drum: insertion and removal keep the force of the last step, and store no energy
/// that the elements did not store (edit/node_stretch.h).
#include "edit/node_stretch.h"

#include <hawser/hawser.h>

#include "support/random.h"
#include "support/tier.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace hawser::test {
namespace {

constexpr double kDrumEA = 1e8, kDrumLine = 23.0, kDrumElement = 2.5;

TEST(NodeStretch, RestLengthStoresTheEnergy) {
    Random random(3);
    for (int i = 0; i < 1000; ++i) {
        const double length = std::exp(random.uniform(-3.0, 5.0));
        const double stiffness = std::exp(random.uniform(5.0, 25.0));
        const double energy = stiffness * length * std::exp(random.uniform(-40.0, 3.0));
        const double rest = edit::rest_length_for_energy(length, stiffness, energy);
        ASSERT_GT(rest, 0.0);
        ASSERT_LE(rest, length);
        const double strain = (length - rest) / rest;
        // The strain is a difference of lengths: rounding 1e-16 over the strain.
        EXPECT_NEAR(0.5 * stiffness * rest * strain * strain, energy,
                    (1e-12 + 1e-14 / strain) * energy);
    }
    EXPECT_EQ(edit::rest_length_for_energy(2.0, 1e6, 0.0), 2.0);
}

TEST(NodeStretch, NearerToZero) {
    EXPECT_EQ(edit::nearer_to_zero(2.0, 3.0), 2.0);
    EXPECT_EQ(edit::nearer_to_zero(-2.0, -3.0), -2.0);
    EXPECT_EQ(edit::nearer_to_zero(2.0, -3.0), 0.0);
    EXPECT_EQ(edit::nearer_to_zero(0.0, 3.0), 0.0);
}

/// A hanging wire whose first element belongs to a heavy drum.
struct DrumWire {
    World w;
    WireId wire{};
    InteractionId line{};
    explicit DrumWire(double step) : w(WorldDef{.step = step, .on_diverged = OnDiverged::warn}) {
        const BodyId deck = w.add_body({.name = "deck", .kind = BodyKind::fixed});
        const BodyId drum =
            w.add_body({.name = "drum", .kind = BodyKind::scalar, .mass = 1e9, .gravity = false});
        BodyDef load{
            .name = "load", .kind = BodyKind::lump, .position = Vec3(0, 0, -6.0 * kDrumElement)};
        load.mass = 2000.0;
        const BodyId end = w.add_body(load);
        wire = w.wires().add({.name = "wire",
                              .from = deck,
                              .to = end,
                              .elements = 6,
                              .EA = kDrumEA,
                              .mass_per_length = kDrumLine,
                              .consistent_mass = true});
        line = w.wires().spool(wire, 0, drum, 0.5);
    }
    void swing(Random& random, double speed) {
        for (const BodyId id : w.wires().nodes(wire))
            if (w.body_def(id).kind == BodyKind::lump)
                w.set_velocity(id, {random.vector(speed), Vec3::Zero()});
    }
    [[nodiscard]] BodyId first_node() const { return w.wires().nodes(wire)[1]; }
    /// Return the force by which an edit may shorten an element [N].
    [[nodiscard]] double force_to_keep(InteractionId id) const {
        const double length = rest(id);
        const double by_length = kDrumEA * w.violation(id)[0] / length;
        return edit::nearer_to_zero(std::max(0.0, by_length), std::max(0.0, -w.force(id)[0]));
    }
    [[nodiscard]] double rest(InteractionId id) const {
        const InteractionDef& d = w.interaction_def(id);
        if (id != line) return d.get("length");
        return d.get("length") + d.get("radius") * (w.pose(d.body[2]).position.x());
    }
};

/// The tension of the merged element is the mean of both by rest lengths: the lesser of the one by
/// length and the one of the last step.
TEST(NodeStretch, RemovalKeepsTheForceOfTheLastStep) {
    int checked = 0;
    for (const std::uint32_t seed : seeds(1, 10, 100, 1000)) {
        Random random(seed);
        DrumWire d(1.0 / 60.0);
        d.swing(random, 0.2);
        for (int k = 0; k < 30; ++k) ASSERT_EQ(d.w.step(), Status::ok);
        const InteractionId next = d.w.wires().elements(d.wire)[1];
        const double whole = d.rest(d.line) + d.rest(next);
        const double mean =
            (d.rest(d.line) * d.force_to_keep(d.line) + d.rest(next) * d.force_to_keep(next)) /
            whole;
        if (!(mean > 0.0) || !d.w.wires().remove_node(d.first_node(), 3.2)) continue;
        ++checked;
        // The bound of the energy may lower the force, never raise it.
        EXPECT_LE(-d.w.force(d.line)[0], mean * (1.0 + 1e-9));
        EXPECT_GE(-d.w.force(d.line)[0], 0.5 * mean);
    }
    EXPECT_GT(checked, 5);
}

/// Neither removal nor insertion at a drum adds elastic energy to a wire that swings too fast for
/// the step.
TEST(NodeStretch, EditsAtADrumStoreNoEnergy) {
    int removed = 0, inserted = 0;
    for (const std::uint32_t seed : seeds(1, 40, 400, 4000)) {
        Random random(seed);
        DrumWire d(0.05);
        d.swing(random, random.uniform(2.0, 20.0));
        const int steps = 2 + static_cast<int>(random.uniform(0.0, 6.0));
        for (int k = 0; k < steps; ++k) ASSERT_EQ(d.w.step(), Status::ok);
        const double before = d.w.energy().elastic;
        if (seed % 2 == 0) {
            if (!d.w.wires().remove_node(d.first_node(), 3.2)) continue;
            ++removed;
            EXPECT_LE(d.w.energy().elastic, before * (1.0 + 1e-6)) << "seed " << seed;
        } else {
            const double force = std::max(0.0, -d.w.force(d.line)[0]);
            const double by_force = 0.5 * force * force * d.rest(d.line) / kDrumEA;
            const double mass = kDrumLine * d.rest(d.line);
            if (!d.w.wires().insert_node(d.line, 0.5, mass).valid()) continue;
            ++inserted;
            EXPECT_LE(d.w.energy().elastic, (before + by_force) * (1.0 + 1e-6)) << "seed " << seed;
        }
    }
    EXPECT_GT(removed, 5);
    EXPECT_GT(inserted, 5);
}

}  // namespace
}  // namespace hawser::test
