// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file exercise.h
/// Exercises for training. An exercise is a scene with stations (roles with controls), faults,
/// alarms, goals, penalties and a score. Part of hawser::session. File format: docs/exercises.md.
///
/// ```cpp
/// auto loaded = hawser::exercise::load_file("exercises/tow_out.json");
/// hawser::Session session(std::move(loaded.scene), {.record = "run.hwr"});
/// hawser::exercise::Run run(loaded.exercise, session);
/// while (!run.ended()) {
///     run.set_input("tug", "winch.speed", 0.5);     // throws Refused if the role may not set it
///     if (run.step() != hawser::Status::ok) break;
/// }
/// session.finish();
/// fmt::print("{} points\n", run.result().points);
/// ```
/// *Roles*. `instructor` may set every input and trigger faults; `watcher` may set nothing. Any
/// other role is a station and may set the inputs that the exercise assigns to it.
///
/// *Faults* act through the session only. They break lines, or change the value of a control before
/// it reaches the world. The recording contains these changes, so that a replay repeats them bit
/// for bit with any number of threads.
///
/// *Score*. Conditions compare outputs of the world after each step. Points follow from these
/// comparisons in a fixed order, so that equal runs have equal scores. A recording stores the data
/// that the motion does not determine: outputs and events of systems, and the actions of roles
/// (Session::note()). rescore() computes the rest from the replayed world.

#include <hawser/scene.h>
#include <hawser/session.h>

#include <cstdint>
#include <filesystem>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace hawser::exercise {

inline constexpr std::string_view kInstructor = "instructor";  ///< Role that may set everything.
inline constexpr std::string_view kWatcher = "watcher";        ///< Role that may set nothing.
/// Largest number of entries of each list of an exercise, and of conditions of one entry.
inline constexpr std::size_t kMostEntries = 256;

/// Exception if a role has no permission for its request. The message states the request and the
/// permitted roles. The request has no effect.
struct Refused : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// Condition above ≤ output ≤ below. It is false if the output is NaN.
struct Condition {
    std::string output{};  ///< Name of an output of the world.
    /// Lower limit, in the unit of the output.
    double above = -std::numeric_limits<double>::infinity();
    /// Upper limit, in the unit of the output.
    double below = std::numeric_limits<double>::infinity();
};

/// Trigger of an alarm, goal, penalty or end. It is true if all conditions have been true for the
/// time `hold` without interruption. If `conditions` is empty, it is true when an event of the kind
/// `event` occurs.
struct Trigger {
    std::vector<Condition> conditions{};      ///< Conditions that must all be true.
    double hold = 0.0;                        ///< Time for which they must be true [s].
    EventKind event = EventKind::line_break;  ///< Kind of event, if `conditions` is empty.
    std::string of{};  ///< Beginning of the name of the event's source; "": any source.
};

/// Station: a role with its controls.
struct Station {
    std::string name{};                 ///< Name of the role.
    std::string text{};                 ///< Description for users.
    std::string layout{};               ///< One of station_layouts(); "": chosen by its inputs.
    std::vector<std::string> inputs{};  ///< Names of the inputs that the role may set.
};

/// Return the layouts of stations on the page of `hawser view`: "bridge", "winch", "crane",
/// "engine_room".
[[nodiscard]] std::span<const char* const> station_layouts() noexcept;

/// Kind of a fault.
enum class FaultKind : std::uint8_t {
    line_parts,         ///< Breaks a line. Target: a wire, at `s`, or an element by name. Cannot be
                        ///< cleared.
    motor_loses_force,  ///< Winch: modes speed, tension and render act as free. Motor of the scene:
                        ///< force limits times `share`.
    brake_slips,        ///< Winch: `brake` input times `share`. Friction of the scene: bound times
                        ///< `share`.
    input_stuck,        ///< The input keeps its last value, or has `value`.
    input_late,         ///< The input takes effect after `delay`.
    output_frozen,      ///< Displays and alarms keep the last value; goals use the true value.
};
inline constexpr int kFaultKindCount = 6;
/// Return the name of a kind of fault, as in exercise files.
[[nodiscard]] const char* to_string(FaultKind kind) noexcept;

/// Fault of the equipment. It starts at a given time, or when the instructor triggers it.
struct Fault {
    std::string name{}, text{};              ///< Name, and description for users.
    FaultKind kind = FaultKind::line_parts;  ///< Kind of the fault.
    std::string target{};  ///< Name of a wire, element, winch, interaction, input or output.
    double s = kDefault;  ///< Material coordinate from the wire's first end [m]; default: middle of
                          ///< the wire.
    double share = 0.0;   ///< Fraction of the force or input that remains, 0 to 1.
    double value = kDefault;     ///< Value of a stuck input; default: its last value.
    double delay = 0.0;          ///< Delay of a late input [s].
    std::optional<double> at{};  ///< Time at which it starts by itself [s]; none: the instructor
                                 ///< triggers it.
    double lasts = std::numeric_limits<double>::infinity();  ///< Duration [s].
};

/// Alarm. It is active while its trigger is true.
struct Alarm {
    std::string name{}, text{};  ///< Name, and description for users.
    Trigger when{};              ///< Trigger.
};

/// Goal. It is reached, and adds points, when its trigger first becomes true.
struct Goal {
    std::string name{}, text{};  ///< Name, and description for users.
    Trigger when{};              ///< Trigger.
    double points = 0.0;         ///< Points that it adds.
    std::string after{};         ///< Name of the goal that must be reached before; "": none.
    std::optional<double> by{};  ///< Time after which it adds no points [s]; none: no limit.
};

/// Phase of the task, for displays and reports. It ends when its goal is reached.
struct Phase {
    std::string name{}, text{};  ///< Name, and description for users.
    std::string goal{};          ///< Name of the goal that ends the phase; "": it does not end.
};

/// Penalty. It subtracts points while its trigger is true.
struct Penalty {
    std::string name{}, text{};  ///< Name, and description for users.
    Trigger when{};              ///< Trigger.
    double points = 0.0;         ///< Points subtracted each time it starts.
    double per_second = 0.0;     ///< Points subtracted per second while it lasts [1/s].
    double most = std::numeric_limits<double>::infinity();  ///< Largest sum of these points.
};

/// End condition: the exercise ends when its trigger becomes true.
struct End {
    std::string name{}, text{};  ///< Name, and description for users.
    Trigger when{};              ///< Trigger.
    bool failed = false;         ///< True: the exercise is then failed at any score.
};

/// Definition of an exercise.
struct Exercise {
    std::string name{}, description{};  ///< Name and description.
    std::string file{};                 ///< File name for messages.
    std::string text{};                 ///< Document (JSON) for recordings.
    double duration = 600.0;            ///< Duration of the exercise [s].
    double pass = 0.0;                  ///< Points required to pass.
    bool until_done = true;  ///< True: the exercise also ends when all goals are reached.
    std::vector<Station> stations{};
    std::vector<Fault> faults{};
    std::vector<Alarm> alarms{};
    std::vector<Goal> goals{};
    std::vector<Phase> phases{};  ///< Phases in their order.
    std::vector<Penalty> penalties{};
    std::vector<End> ends{};
    std::vector<std::string> displays{};  ///< Outputs in the displays of stations and in plots of
                                          ///< reports.
    std::vector<scene::Operation> levers{};  ///< Operations `set` of the timelines by time. Run
                                             ///< executes them.
};

/// Exercise with its scene. The scene contains the inputs, outputs and timeline of the exercise.
struct Loaded {
    Exercise exercise;   ///< Exercise.
    scene::Scene scene;  ///< Scene.
};
/// Load an exercise with its scene.
/// @param options  Options of the scene.
/// @throws scene::SceneError with file, position and nearest name.
[[nodiscard]] Loaded load_file(const std::filesystem::path& file,
                               const scene::Options& options = {});
/// Load an exercise from memory.
/// @param name  Name for messages; its folder is searched for the scene.
/// @throws scene::SceneError.
[[nodiscard]] Loaded load_text(std::string_view text, const std::string& name,
                               const scene::Options& options = {});
/// Prepare an exercise for a session that starts from a saved state. Faults with an earlier time do
/// not start by themselves, and goals do not require an earlier goal (`after`).
/// @param time  Time of the saved state [s].
void start_at(Exercise& exercise, double time);
/// True if a file is an exercise instead of a scene: its document has the key "exercise".
[[nodiscard]] bool is_exercise(const std::filesystem::path& file) noexcept;
/// Return the format as a JSON Schema (draft 07): schema/exercise-1.json.
[[nodiscard]] std::string schema_text();

/// Kind of a log entry.
enum class EntryKind : std::uint8_t {
    goal,       ///< A goal was reached.
    penalty,    ///< A penalty started.
    alarm,      ///< An alarm started.
    alarm_end,  ///< An alarm ended.
    fault,      ///< A fault started.
    fault_end,  ///< A fault ended.
    restored,   ///< The run was restored to a mark; the time is that of the mark.
    end,        ///< The exercise ended.
};
/// Return the name of a kind of log entry, as in JSON results.
[[nodiscard]] const char* to_string(EntryKind kind) noexcept;

/// Log entry of an exercise.
struct Entry {
    double time = 0.0;  ///< Time [s].
    EntryKind kind = EntryKind::goal;
    std::string name;     ///< Name of the goal, penalty, ….
    std::string text;     ///< Description.
    std::string by;       ///< Role that triggered a fault; "": the exercise.
    double points = 0.0;  ///< Change of the score, without penalties that are still active.
};

/// Outcome of an exercise.
enum class Outcome : std::uint8_t { running, passed, failed };
/// Return the name of an outcome, as in its enumerator.
[[nodiscard]] const char* to_string(Outcome outcome) noexcept;

/// Totals of a goal, penalty or alarm.
struct Tally {
    std::string name, text;
    bool reached = false;    ///< Goals: true if reached.
    double time = 0.0;       ///< Time at which it was reached, or first started [s].
    std::int32_t times = 0;  ///< Penalties and alarms: number of starts.
    double seconds = 0.0;    ///< Penalties and alarms: total duration [s].
    double points = 0.0;     ///< Points added; < 0: subtracted.
    double possible = 0.0;   ///< Goals: largest possible points.
    bool active = false;     ///< Penalties and alarms: true if active now.
};

/// Score and log of an exercise.
struct Result {
    std::string exercise;
    Outcome outcome = Outcome::running;
    std::string end;                    ///< Reason of the ending; "" while it runs.
    double time = 0.0;                  ///< Time [s].
    double points = 0.0;                ///< Points of goals minus those of penalties.
    double possible = 0.0, pass = 0.0;  ///< Largest possible points; points required to pass.
    std::vector<Tally> goals, penalties, alarms;  ///< Totals in the order of Exercise.
    std::vector<Entry> entries;                   ///< Log entries in order of occurrence.
};
/// Displays over time, thinned to at most a few thousand samples.
struct Curves {
    std::vector<double> time;                 ///< Times [s].
    std::vector<std::vector<double>> values;  ///< Samples of each of Exercise::displays.
};
/// Return the result as JSON with numbers of 17 digits, so that equal texts mean equal scores.
[[nodiscard]] std::string to_json(const Result& result);

/// Exercise that runs in a session. Use it from the thread of the session.
class Run {
  public:
    /// Start an exercise.
    /// @param exercise, session  Must outlive the run. The session's scene is that of load_file().
    /// @throws DefError if the session's world lacks a name that the exercise uses.
    Run(const Exercise& exercise, Session& session);
    ~Run();
    Run(const Run&) = delete;
    Run& operator=(const Run&) = delete;

    // --- Permissions -----------------------------------------------------------------------------
    /// True if the role is the instructor, the watcher or a station.
    [[nodiscard]] bool is_role(std::string_view role) const noexcept;
    /// True if the role may set the input.
    [[nodiscard]] bool may_set(std::string_view role, std::string_view input) const noexcept;

    // --- Controls and faults ---------------------------------------------------------------------
    /// Set an input from the next step on, unless a fault prevents it. Session::set_input() would
    /// bypass faults.
    /// @throws Refused if the role has no permission
    /// @throws DefError as Session::set_input()
    void set_input(std::string_view role, std::string_view input, double value);
    /// Return the value of an input that a role has requested last; NaN: none.
    [[nodiscard]] double asked(std::string_view input) const noexcept;
    /// Start a fault.
    /// @throws Refused if the role is not the instructor
    /// @throws DefError if the fault does not exist or is not possible
    void trigger(std::string_view role, std::string_view fault);
    /// End a fault. Exceptions as trigger().
    void clear(std::string_view role, std::string_view fault);
    /// True if the fault is active.
    [[nodiscard]] bool active(std::string_view fault) const noexcept;
    /// Return the value of an output that displays show; a fault may freeze it.
    /// @throws DefError if the output does not exist.
    [[nodiscard]] double shown(std::string_view output) const;

    // --- Stepping --------------------------------------------------------------------------------
    /// Apply controls, faults and timeline operations that are due.
    /// @throws DefError if a fault is not possible.
    void before_step();
    /// Update alarms, goals, penalties and ends. Call it after a completed step.
    void after_step();
    /// Call before_step(), Session::step() and after_step().
    Status step();
    /// True if the exercise has ended. Score and entries are then constant; the session may
    /// continue.
    [[nodiscard]] bool ended() const noexcept;
    /// End the exercise now, for instance after a failed step.
    /// @param why  Description of the reason.
    void end(const std::string& why, bool failed);
    /// Return score and log up to now.
    [[nodiscard]] const Result& result() const noexcept;
    /// Return the displays over time up to now.
    [[nodiscard]] const Curves& curves() const noexcept;

    // --- Restoring -------------------------------------------------------------------------------
    /// Save controls, faults and score in the run. Return a mark to restore them; store it together
    /// with WorldState::save().
    [[nodiscard]] int mark();
    /// Restore the controls, faults and score of a mark. Call it after Session::restore() to the
    /// state of the mark. Adds an entry to the log.
    /// @throws DefError if the mark does not exist.
    void back_to(int mark);

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

/// Request of a role to set an input.
struct ControlRequest {
    double time = 0.0;        ///< Time [s].
    std::string role, input;  ///< Role, and name of the input.
    double value = 0.0;       ///< Value in the unit of the input.
};

/// Score of a recorded exercise, from a replay of its motion.
struct Rescored {
    Exercise exercise;                     ///< Exercise of the recording.
    Result result;                         ///< Score and log.
    Curves curves;                         ///< Displays over time.
    std::vector<ControlRequest> requests;  ///< Requests of all branches, in order of occurrence.
    bool same = true;        ///< True if every frame of the replay has the recorded hash.
    std::string difference;  ///< Description of the first frame with another hash; "": none.
};
/// True if the recording is of an exercise.
[[nodiscard]] bool is_recorded(const record::Recording& recording) noexcept;
/// Compute the score of a recording by a replay of its motion.
/// @param threads  Worker threads of the replaying world.
/// @throws record::RecordingError if it is not a recording of an exercise
/// @throws DefError or scene::SceneError if its content is invalid
[[nodiscard]] Rescored rescore(const record::Recording& recording, int threads = 1);

}  // namespace hawser::exercise
