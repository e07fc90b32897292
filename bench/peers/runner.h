// SPDX-License-Identifier: Apache-2.0
/// @file
/// Interface of every simulator in the comparison, including ours.
///
/// The comparison controls the clock, the loads and all measurements. A runner only builds a scene,
/// advances it by one substep and returns the poses of bodies. Gap, tension, energy and path are
/// computed from these states by one code (meter.h), independent of the engine.
#pragma once

#include "scenes.h"

#include <time.h>

#include <chrono>
#include <memory>
#include <string>
#include <vector>

namespace hawser::bench {

/// Time of a call.
struct Spent {
    double wall = 0.0;  ///< [s]
    /// Processor time of the calling thread [s]: the wall time on an idle machine.
    double cpu = 0.0;
};

/// A simulator with one scene loaded.
class Runner {
  public:
    virtual ~Runner() = default;
    Runner() = default;
    Runner(const Runner&) = delete;
    Runner& operator=(const Runner&) = delete;

    /// Substeps per frame of kFrame.
    [[nodiscard]] virtual int substeps() const = 0;

    /// Settings that a reader needs to repeat the run, in a few words.
    [[nodiscard]] virtual std::string settings() const = 0;

    /// Advance by kFrame / substeps().
    ///
    /// `loads` has one entry per body, evaluated at the present state (external_loads). A simulator
    /// with its own load models ignores it. Loads may be passed before the returned time starts.
    /// @returns time of the simulator.
    virtual Spent substep(const std::vector<Load>& loads) = 0;

    /// Poses and velocities of all bodies, in scene order.
    virtual void read(std::vector<BodyState>& out) const = 0;

    /// @return true if velocities belong half a substep before the poses. The energy is then
    ///        computed at the mean of the last two poses.
    [[nodiscard]] virtual bool staggered() const { return false; }

    /// Force of the tow line on every ship of Scene::towed, mean over the last substep [N].
    /// Without it the force follows from the momentum balance of the ship.
    virtual bool tow_force(std::vector<Vec3>& /*out*/) const { return false; }

    /// Return the contact points of the last substep; -1 if the simulator does not return them.
    [[nodiscard]] virtual int contacts() const { return -1; }
};

/// CPU time of this thread so far [s].
inline double cpu_of_thread() {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// Time of one call.
template <class F>
Spent spent(F&& f) {
    const auto t0 = std::chrono::steady_clock::now();
    const double cpu = cpu_of_thread();
    f();
    return {std::chrono::duration<double>(std::chrono::steady_clock::now() - t0).count(),
            cpu_of_thread() - cpu};
}

std::unique_ptr<Runner> make_ode(const Scene& scene, int substeps, bool quick);
std::unique_ptr<Runner> make_bullet_impulse(const Scene& scene, int substeps);
std::unique_ptr<Runner> make_bullet_featherstone(const Scene& scene, int substeps,
                                                 const TreeLayout& layout);
std::unique_ptr<Runner> make_simbody(const Scene& scene, int substeps, const TreeLayout& layout);

/// Our own engine; more than one substep serves to make references alone, and solves contacts to
/// 1e-10.
std::unique_ptr<Runner> make_ours(const Scene& scene, int substeps);

}  // namespace hawser::bench
