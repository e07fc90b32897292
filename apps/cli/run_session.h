// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file run_session.h
/// One run of a scene: commands in, steps, recordings and figures out.

#include "realtime.h"
#include "record/control.h"
#include "record/csv.h"
#include "record/recording.h"
#include "report/summary.h"
#include "scene_options.h"
#include "trace_output.h"
#include "verify/coupling.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace hawser::cli {

struct RunOptions {
    SceneOptions scene;
    std::optional<double> duration;  ///< Time at which the run ends [s].
    bool realtime = false, rt = false, quiet = false, verify = false;
    bool unchecked = false;  ///< Runs whatever check_start() finds.
    std::string control, record, csv, summary, restore, save_file;
    std::optional<double> save_time;  ///< [s]
    std::int32_t stride = 0;          ///< Steps from frame to frame; 0 = chosen by size.
    TraceOptions trace;
};

class RunSession {
  public:
    /// Reads the scene, restores the state, opens the outputs. @throws std::exception.
    explicit RunSession(const RunOptions& options);
    /// Steps until the end, a failure or a signal. @return the exit code.
    int run();

  private:
    void check_files() const;
    void choose_times();
    void check_start();
    void choose_stride();
    void apply_inputs();
    void after_step();
    void add_frame();
    void save_if_due();
    int finish(record::Ending ending, double wall_seconds);

    const RunOptions& options_;
    scene::Scene scene_;
    record::SceneInfo info_;
    double end_time_ = 0.0;
    std::int64_t steps_ = 0, done_ = 0;
    std::int64_t framed_ = 0;  ///< Steps taken at the last frame.
    std::int32_t stride_ = 1;
    std::vector<record::ControlChange> control_;
    std::size_t next_control_ = 0;
    std::unique_ptr<record::RecordingWriter> recording_;
    std::unique_ptr<record::CsvWriter> csv_;
    std::unique_ptr<report::SummaryCollector> collector_;
    std::unique_ptr<verify::Verifier> verifier_;
    std::unique_ptr<verify::CouplingObserver> coupling_;  ///< Where something is cut.
    std::string wrong_;                                   ///< What the verifier found.
    std::vector<std::string> warnings_;                   ///< Of the start.
    std::unique_ptr<Pacer> pacer_;
    bool saved_ = false;
    std::vector<std::string> written_;
};

}  // namespace hawser::cli
