// SPDX-License-Identifier: Apache-2.0
#pragma once
/// Three equal cables on a hull, for tests of the effects of forces and velocities on the choice of
/// cuts.
#include "support/recipe.h"

#include <hawser/experimental/splits.h>
#include <hawser/inspect.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <vector>

namespace hawser::test::regrouping {

inline constexpr int kNodes = 40;
inline constexpr double kSeparation = 1.0;  // m
inline constexpr int kEvery = 20;           // steps

/// A hull with three equal cables that extend in a plane, without gravity: they differ only in
/// motion and pull.
struct Cables {
    explicit Cables(int parts, int every = kEvery, int threads = 1) {
        recipe.world.gravity = Vec3::Zero();
        recipe.world.coupling = Coupling::compliant;
        recipe.world.parts = parts;
        recipe.world.regroup_every = every;
        recipe.world.threads = threads;
        hull = recipe.rigid({0, 0, 0}, Quat::Identity(), 1e6, {1e7, 1e7, 1e7});
        for (std::size_t c = 0; c < 3; ++c) add_cable(c);
    }

    [[nodiscard]] static Vec3 direction(std::size_t c) {
        const double turn = 2.0 * 3.14159265358979 * static_cast<double>(c) / 3.0;
        return {std::cos(turn), std::sin(turn), 0.0};
    }

    void add_cable(std::size_t c) {
        std::vector<BodyId> row{hull};
        for (int i = 1; i <= kNodes; ++i)
            row.push_back(recipe.lump(direction(c) * (kSeparation * i), 10.0));
        for (std::size_t i = 0; i + 1 < row.size(); ++i) {
            InteractionDef d = between(InteractionKind::Distance, {row[i], row[i + 1]});
            d.compliance[0] = 1e-7;
            d.damping_time[0] = 0.1;
            recipe.add(d.set("length", kSeparation));
        }
        cable[c].assign(row.begin() + 1, row.end());
    }

    /// Rotate it about the hull, so that every node is pulled inwards.
    void turn(World& w, std::size_t c) const {
        const Vec3 across = Vec3(0, 0, 1).cross(direction(c));
        for (int i = 0; i < kNodes; ++i)
            w.set_velocity(cable[c][static_cast<std::size_t>(i)],
                           {across * (1.0 * kSeparation * (i + 1)), Vec3::Zero()});
    }
    /// Pull its end, so that tension is constant along it.
    void pull(World& w, std::size_t c) const {
        w.set_force(cable[c].back(), direction(c) * 5e3, Vec3::Zero());
    }

    /// Return the cables with a cut in force.
    [[nodiscard]] std::set<std::size_t> cut_cables(const World& w) const {
        return cables_of(w, w.splits().cuts());
    }
    /// Return the cables that a partition cuts.
    [[nodiscard]] std::set<std::size_t> cut_cables(const World& w,
                                                   const PartitionView& view) const {
        return cables_of(w, view.cuts);
    }

    Recipe recipe;
    BodyId hull{};
    std::array<std::vector<BodyId>, 3> cable;

  private:
    template <class Cuts>
    [[nodiscard]] std::set<std::size_t> cables_of(const World& w, const Cuts& cuts) const {
        std::set<std::size_t> result;
        for (const auto& cut : cuts)
            for (std::size_t c = 0; c < 3; ++c)
                for (const BodyId b : w.interaction_def(cut.interaction).body)
                    if (std::find(cable[c].begin(), cable[c].end(), b) != cable[c].end())
                        result.insert(c);
        return result;
    }
};

inline void run(World& w, int steps) {
    for (int i = 0; i < steps; ++i) ASSERT_EQ(w.step(), Status::ok) << "step " << i;
}

}  // namespace hawser::test::regrouping
