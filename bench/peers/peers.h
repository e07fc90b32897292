// SPDX-License-Identifier: Apache-2.0
/// @file
/// Comparison of engines on the scenes of scenes.h. It runs one engine, searches the smallest
/// number of substeps that holds, and runs several engines alternated in blocks of frames.
///
/// The term *holds* (meter.h) means, over the whole run: gap <= 1 mm, tension error <= 2 % rms,
/// energy drift
/// <= 1 %. If the scene has a path to follow, also path error <= 0.1 m.
#pragma once

#include "meter.h"
#include "runner.h"

#include <functional>
#include <string>
#include <vector>

namespace hawser::bench {

/// An engine of the comparison.
struct Engine {
    std::string name;
    std::string description;
    bool ours = false;  ///< One step per frame, no search.
    std::function<std::unique_ptr<Runner>(const Scene&, int substeps)> make;  ///< Null: left out.
};

/// Return all engines of this build.
[[nodiscard]] std::vector<Engine> engines();

/// Return an engine by name; `name@2` uses the second tree layout of the scene for a
/// reduced-coordinate engine. Throws std::invalid_argument with the known names.
[[nodiscard]] Engine engine_by_name(const std::string& name);

/// Result of one engine on one scene.
struct PeerResult {
    std::string engine, scene, settings;
    int substeps = 0;  ///< Per frame of 1/60 s.
    bool holds = false;
    std::string reason_unusable;  ///< First broken limit; empty if it holds.
    std::string unchecked;        ///< Limits of *holds* that were not checked because no reference
                                  ///< exists.
    double simulated = 0.0;       ///< Simulated time [s].
    double ms_per_frame = 0.0;    ///< Median wall time of frames, the first 60 left out [ms].
    double ms_p99 = 0.0;          ///< 99th percentile wall time of frames, first 60 left out [ms].
    double cpu_ms = 0.0;          ///< Median CPU time of frames, the first 60 left out [ms].
    Measures measures;
    std::vector<double> frame_ms;               ///< Every frame, the first included [ms].
    std::vector<int> contacts;                  ///< Points at the end of every frame, or empty.
    std::vector<double> tension_times;          ///< Middle of every frame [s].
    std::vector<std::vector<double>> tensions;  ///< Per towed ship, mean of every frame [N].
};

/// One engine on one scene, advanced frame by frame.
class Trial {
  public:
    Trial(const Engine& engine, const Scene& scene, const Reference& reference, int substeps,
          double duration);

    /// Simulate and measure one frame. False once it has ended or is no longer finite.
    bool frame();

    /// True if the present measures hold; sets `why` to the first broken limit.
    [[nodiscard]] bool holds(std::string* why = nullptr) const;

    [[nodiscard]] bool is_over() const { return frames_ >= total_ || !meter_.measures().finite; }
    [[nodiscard]] PeerResult result() const;

  private:
    const Scene& scene_;
    const Reference& reference_;
    std::string engine_;
    std::unique_ptr<Runner> runner_;
    Meter meter_;
    std::vector<BodyState> before_, now_;
    std::vector<Load> loads_;
    std::vector<Vec3> tow_;
    std::vector<double> frame_ms_, frame_cpu_ms_;
    std::vector<int> contacts_;
    int frames_ = 0, total_ = 0;
};

/// Limits of a search.
struct SearchOptions {
    double duration = 0.0;  ///< Simulated time [s]; 0: the scene's.
    int max_substeps = 64;  ///< Largest number tried.
    double budget = 60.0;   ///< Wall time of one run, measuring included [s].
};

/// Make one run, stopped at the first broken limit if `early_out`, or at the budget.
[[nodiscard]] PeerResult run_peer(const Engine& engine, const Scene& scene, int substeps,
                                  const Reference& reference, const SearchOptions& options,
                                  bool early_out);

/// Find the smallest number of substeps of 1-8, 10, 12, 16, 20, 24, 32, ... that holds. Otherwise
/// returns the last attempt with the reason.
[[nodiscard]] PeerResult smallest_that_holds(const Engine& engine, const Scene& scene,
                                             const Reference& reference,
                                             const SearchOptions& options,
                                             const std::function<void(const PeerResult&)>& tell);

/// Run all trials to their end, `block` frames of each in turn, so that a disturbance of the
/// machine affects all of them.
void run_in_turns(std::vector<std::unique_ptr<Trial>>& trials, int block = 60);

}  // namespace hawser::bench
