// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file anchor_lines_probe.h
/// Measures a run of scenes/anchor_lines.json in every step, for comparison with the properties
/// that the scene promises.

#include <hawser/hawser.h>
#include <hawser/scene.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace hawser::test {

class AnchorLinesProbe {
  public:
    explicit AnchorLinesProbe(scene::Scene& scene) : scene_(scene) {
        const World& world = scene.world;
        force_max_.assign(static_cast<std::size_t>(world.interaction_count()), 0.0);
        for (int i = 0; i < world.body_count(); ++i) {
            const BodyId id{i};
            const std::string& name = world.body_def(id).name;
            // Copies of the site have the prefix "k:".
            const std::string local = name.substr(name.find(':') + 1);
            if (local == "rig" || local == "ahts1/hull" || local == "ahts2/hull") {
                vessels_.emplace_back(id, world.pose(id));
            }
        }
    }

    /// Step once and measure. @return false if the world rejected the step.
    bool step() {
        World& world = scene_.world;
        if (world.step() != Status::ok) {
            return false;
        }
        violation_max = std::max(violation_max, world.stats().violation_max);
        momentum_residual_max = std::max(momentum_residual_max, world.stats().momentum_residual);
        watch_forces();
        watch_lines();
        watch_vessels();
        return true;
    }

    /// Return interactions whose force stayed below `threshold` [N or N m] in every row and step.
    [[nodiscard]] std::vector<std::string> idle(double threshold) const {
        std::vector<std::string> names;
        for (std::size_t i = 0; i < force_max_.size(); ++i) {
            if (force_max_[i] < threshold) {
                const InteractionId id{static_cast<std::int32_t>(i)};
                names.push_back(scene_.world.interaction_def(id).name);
            }
        }
        return names;
    }
    [[nodiscard]] double min_force() const {
        double least = std::numeric_limits<double>::infinity();
        for (const double f : force_max_) {
            least = std::min(least, f);
        }
        return least;
    }
    [[nodiscard]] std::size_t vessel_count() const { return vessels_.size(); }

    double violation_max = 0.0;          ///< [m]
    double momentum_residual_max = 0.0;  ///< Relative.
    double stretch_error_max = 0.0;      ///< |l − l₀(1 + T/EA)| / l₀, measured from the poses.
    double tension_min = 1e300;          ///< [N]
    double load_max = 0.0;               ///< Tension / breaking load.
    double drift_max = 0.0;              ///< Largest of the vessels [m].
    double turn_max = 0.0;               ///< Largest of the vessels [deg].

  private:
    void watch_forces() {
        for (std::size_t i = 0; i < force_max_.size(); ++i) {
            for (const double f : scene_.world.force({static_cast<std::int32_t>(i)})) {
                force_max_[i] = std::max(force_max_[i], std::abs(f));
            }
        }
    }

    void watch_lines() {
        const World& world = scene_.world;
        for (const scene::Cable& cable : scene_.cables) {
            for (const InteractionId id : cable.stretch) {
                const InteractionDef& def = world.interaction_def(id);
                const double tension = -world.force(id)[0];
                double rest = def.get("length");
                if (def.kind == InteractionKind::WinchStretch) {
                    rest += def.get("radius") * world.pose(def.body[2]).position.x();
                }
                const double length = (world.world_point(def.body[1], def.point[1]) -
                                       world.world_point(def.body[0], def.point[0]))
                                          .norm();
                const double wanted = rest * (1.0 + tension / def.get("EA"));
                stretch_error_max = std::max(stretch_error_max, std::abs(length - wanted) / rest);
                tension_min = std::min(tension_min, tension);
                load_max = std::max(load_max, tension / cable.breaking_load);
            }
        }
    }

    void watch_vessels() {
        for (const auto& [id, settled] : vessels_) {
            const Pose now = scene_.world.pose(id);
            drift_max = std::max(drift_max, (now.position - settled.position).norm());
            const double angle = now.orientation.angularDistance(settled.orientation);
            turn_max = std::max(turn_max, angle * 180.0 / 3.141592653589793);
        }
    }

    scene::Scene& scene_;
    std::vector<double> force_max_;
    std::vector<std::pair<BodyId, Pose>> vessels_;
};

}  // namespace hawser::test
