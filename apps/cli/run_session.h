// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file run_session.h
/// `hawser run`: a session with signals, progress, pace and a report.

#include <hawser/session.h>

#include "realtime.h"
#include "report/summary.h"
#include "scene_options.h"
#include "trace_output.h"
#include "verify/certificate.h"
#include "verify/coupling.h"
#include "verify/sampled.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace hawser::cli {

class Progress;

struct RunOptions {
    SceneOptions scene;
    std::optional<double> duration;  ///< Time at which the run ends [s].
    bool realtime = false, rt = false, quiet = false, verify = false;
    bool verbose = false;    ///< Report figures of the solver as well.
    bool unchecked = false;  ///< Run even if check_start() finds mistakes.
    std::string record, csv, summary, restore, save_file;
    std::optional<double> save_time;  ///< Time of the state to save [s]
    std::int32_t stride = 0;          ///< Steps between frames; 0 = chosen by size.
    TraceOptions trace;
};

/// Steps a Session and prints its results.
class RunSession {
  public:
    /// Read the scene, restore the state, open the outputs. @throws std::exception.
    explicit RunSession(const RunOptions& options);
    /// Step until the end, a failure or a signal. @return the exit code.
    int run();

  private:
    [[nodiscard]] Session open();
    void check_files(const scene::Scene& scene) const;
    void check_start(const scene::Scene& scene);
    void choose_times();
    [[nodiscard]] std::int32_t stride() const;
    void open_outputs();
    void add_observers();
    [[nodiscard]] Status run_step(Progress& progress);
    void save_if_due();
    int finish(bool interrupted, double wall_seconds);

    const RunOptions& options_;
    std::vector<std::string> warnings_;           ///< Warnings about the start.
    std::unique_ptr<verify::Verifier> verifier_;  ///< Verifier, created at the start of the scene.
    std::unique_ptr<verify::SampledVerifier> sampled_;  ///< Verifier without --verify.
    Session session_;
    record::SceneInfo info_;
    double end_time_ = 0.0;
    std::int64_t steps_ = 0;
    std::unique_ptr<report::SummaryCollector> collector_;
    std::unique_ptr<verify::CouplingObserver>
        coupling_;  ///< Observer of the coupling; null if there are no cuts.
    std::unique_ptr<Pacer> pacer_;
    bool saved_ = false;
    std::vector<std::string> written_;
};

}  // namespace hawser::cli
