// SPDX-License-Identifier: Apache-2.0
/// @file
/// Interface of every compared simulator, including Hawser.
///
/// The comparison owns the clock, the loads and all measurements: a runner only builds a scene,
/// advances it by one substep and reports the states of bodies. Gap, tension, energy and path are
/// computed from those states by the same code (meter.h) for all engines.
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
    double cpu = 0.0;   ///< Time of the calling thread [s]: equal to wall time on an idle machine.
};

/// A simulator with one scene loaded.
class Runner {
  public:
    virtual ~Runner() = default;
    Runner() = default;
    Runner(const Runner&) = delete;
    Runner& operator=(const Runner&) = delete;

    /// Return the substeps per frame of kFrame.
    [[nodiscard]] virtual int substeps() const = 0;

    /// Return the settings that are needed to repeat the run, in a few words.
    [[nodiscard]] virtual std::string settings() const = 0;

    /// Advance by kFrame / substeps().
    ///
    /// `loads` has one entry per body, evaluated at the present state (external_loads). A simulator
    /// with load models of its own ignores it. Transfer of loads may precede the returned time.
    /// @returns time of the simulator.
    virtual Spent substep(const std::vector<Load>& loads) = 0;

    /// Read poses and velocities of all bodies, in scene order.
    virtual void read(std::vector<BodyState>& out) const = 0;

    /// True if velocities belong to half a substep before the poses: the energy is then that of the
    /// mean of the last two poses.
    [[nodiscard]] virtual bool staggered() const { return false; }

    /// Return the force of the tow line on every ship of Scene::towed, mean over the last substep
    /// [N]. Without it the force follows from the momentum balance of the ship.
    virtual bool tow_force(std::vector<Vec3>& /*out*/) const { return false; }

    /// Return the contact points of the last substep; -1 if the simulator has none or does not
    /// report them.
    [[nodiscard]] virtual int contacts() const { return -1; }
};

/// Return the CPU time of this thread [s].
inline double cpu_of_thread() {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// Measure the time of one call.
template <class F>
Spent measure_time(F&& f) {
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

/// Make Hawser's runner. More than one substep serves only to make references, and solves contacts
/// to 1e-10.
std::unique_ptr<Runner> make_ours(const Scene& scene, int substeps);

}  // namespace hawser::bench
