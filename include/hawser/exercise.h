// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file exercise.h
/// Exercises: a scene with stations, faults, alarms, goals, penalties and a score. Part of
/// hawser::session; docs/exercises.md describes the file.
///
/// ```cpp
/// auto loaded = hawser::exercise::load_file("exercises/tow_out.json");
/// hawser::Session session(std::move(loaded.scene), {.record = "run.hwr"});
/// hawser::exercise::Run run(loaded.exercise, session);
/// while (!run.ended()) {
///     run.set_input("tug", "winch.speed", 0.5);     // may the role do that? else Refused
///     if (run.step() != hawser::Status::ok) break;
/// }
/// session.finish();
/// fmt::print("{} points\n", run.result().points);
/// ```
/// **Roles.** `instructor` sets every input and triggers faults, `watcher` sets nothing, any other
/// role is a station and sets the inputs that the exercise gives it.
///
/// **Faults** act through the session alone: they part lines, and change what a lever sets before
/// it reaches the world. What they do is therefore in the recording as any other change, and a
/// replay repeats it bit for bit, with any number of threads.
///
/// **Score.** Conditions compare outputs of the world after each step; points follow from these
/// comparisons in a fixed order, so that two runs of the same bits have the same score. A recording
/// keeps what cannot be computed again from the motion: outputs of systems, events of systems, and
/// who did what (Session::note()); rescore() computes everything else anew from the replayed world.

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

inline constexpr std::string_view kInstructor = "instructor";
inline constexpr std::string_view kWatcher = "watcher";
/// Entries that each list of an exercise may have, and conditions of one entry.
inline constexpr std::size_t kMostEntries = 256;

/// A role asked for what it may not do; what() says what, and who may. Nothing was changed.
struct Refused : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// Holds while the output is at least `above` and at most `below`; not where it is NaN.
struct Condition {
    std::string output{};  ///< Of the world, by name.
    double above = -std::numeric_limits<double>::infinity();
    double below = std::numeric_limits<double>::infinity();
};

/// When something counts: all conditions have held for `hold` without a break; or where
/// `conditions` is empty an event of this kind happened.
struct Trigger {
    std::vector<Condition> conditions{};
    double hold = 0.0;                        ///< [s]
    EventKind event = EventKind::line_break;  ///< Where there are no conditions …
    std::string of{};                         ///< … of what has a name that begins so; "": any.
};

struct Station {
    std::string name{};  ///< Of the role.
    std::string text{};
    std::vector<std::string> inputs{};
};

enum class FaultKind : std::uint8_t {
    line_parts,         ///< Target: a wire, at `s`, or an element by name. Cannot be cleared.
    motor_loses_force,  ///< Of a winch: modes speed, tension and render act as free. Of a motor of
                        ///< the scene: its forces times `share`.
    brake_slips,        ///< Of a winch: its brake holds `share` of what is asked for. Of a friction
                        ///< of the scene: its force times `share`.
    input_stuck,        ///< Keeps the value it had, or `value`.
    input_late,         ///< Takes effect `delay` later.
    output_frozen,      ///< Displays and alarms keep the value it had; goals see the truth.
};
inline constexpr int kFaultKindCount = 6;
[[nodiscard]] const char* to_string(FaultKind kind) noexcept;

struct Fault {
    std::string name{}, text{};
    FaultKind kind = FaultKind::line_parts;
    std::string target{};        ///< Wire, element, winch, interaction, input or output.
    double s = kDefault;         ///< From the wire's first end [m]; NaN: its middle.
    double share = 0.0;          ///< 0 to 1.
    double value = kDefault;     ///< NaN: the value it has.
    double delay = 0.0;          ///< [s]
    std::optional<double> at{};  ///< Comes by itself at this time [s]; else the instructor's.
    double lasts = std::numeric_limits<double>::infinity();  ///< [s]
};

struct Alarm {
    std::string name{}, text{};
    Trigger when{};
};

struct Goal {
    std::string name{}, text{};
    Trigger when{};
    double points = 0.0;
    std::string after{};         ///< Goal that must have been reached before; "": none.
    std::optional<double> by{};  ///< Later it gives nothing [s].
};

struct Penalty {
    std::string name{}, text{};
    Trigger when{};
    double points = 0.0;                                    ///< Each time it begins.
    double per_second = 0.0;                                ///< And while it lasts.
    double most = std::numeric_limits<double>::infinity();  ///< Points in all.
};

struct End {
    std::string name{}, text{};
    Trigger when{};
    bool failed = false;  ///< The exercise has then failed, whatever the points.
};

struct Exercise {
    std::string name{}, description{};
    std::string file{};       ///< For messages.
    std::string text{};       ///< Document (JSON), goes into recordings.
    double duration = 600.0;  ///< It ends then [s].
    double pass = 0.0;        ///< Points needed.
    bool until_done = true;   ///< It also ends when all goals have been reached.
    std::vector<Station> stations{};
    std::vector<Fault> faults{};
    std::vector<Alarm> alarms{};
    std::vector<Goal> goals{};
    std::vector<Penalty> penalties{};
    std::vector<End> ends{};
    std::vector<std::string> displays{};     ///< Outputs that stations see and reports plot.
    std::vector<scene::Operation> levers{};  ///< `set` of timelines: Run does them, by time.
};

/// An exercise with its scene, to which it has added its inputs, outputs and timeline.
struct Loaded {
    Exercise exercise;
    scene::Scene scene;
};
/// @param options  Of the scene. @throws scene::SceneError with file, place and nearest name.
[[nodiscard]] Loaded load_file(const std::filesystem::path& file,
                               const scene::Options& options = {});
/// @param name  For messages; its folder is where the scene is looked for.
[[nodiscard]] Loaded load_text(std::string_view text, const std::string& name,
                               const scene::Options& options = {});
/// Whether a document is an exercise rather than a scene: it has the key "exercise".
[[nodiscard]] bool is_exercise(const std::filesystem::path& file) noexcept;
/// The format as a JSON Schema (draft 07): schema/exercise-1.json.
[[nodiscard]] std::string schema_text();

enum class EntryKind : std::uint8_t {
    goal,       ///< Reached.
    penalty,    ///< Began.
    alarm,      ///< Sounded …
    alarm_end,  ///< … and stopped.
    fault,      ///< Set in …
    fault_end,  ///< … and ended.
    restored,   ///< Went back to a mark; the time is that of the mark.
    end,        ///< Of the exercise.
};
[[nodiscard]] const char* to_string(EntryKind kind) noexcept;

/// Something that happened.
struct Entry {
    double time = 0.0;  ///< [s]
    EntryKind kind = EntryKind::goal;
    std::string name;     ///< Of the goal, penalty, …
    std::string text;     ///< In words.
    std::string by;       ///< Role of faults; "": the exercise.
    double points = 0.0;  ///< What it changed, but for penalties that go on.
};

enum class Outcome : std::uint8_t { running, passed, failed };
[[nodiscard]] const char* to_string(Outcome outcome) noexcept;

struct Tally {
    std::string name, text;
    bool reached = false;    ///< Of a goal.
    double time = 0.0;       ///< When it was reached, or first began [s].
    std::int32_t times = 0;  ///< Of penalties and alarms.
    double seconds = 0.0;    ///< Of penalties and alarms, in all.
    double points = 0.0;     ///< That it gave or took.
    double possible = 0.0;   ///< Of a goal.
    bool active = false;     ///< Of alarms and penalties, now.
};

struct Result {
    std::string exercise;
    Outcome outcome = Outcome::running;
    std::string end;      ///< Why it ended; "" while it runs.
    double time = 0.0;    ///< [s]
    double points = 0.0;  ///< Goals less penalties.
    double possible = 0.0, pass = 0.0;
    std::vector<Tally> goals, penalties, alarms;
    std::vector<Entry> entries;  ///< In the order in which they happened.
};
/// Displays over time, thinned so that there are at most some thousand.
struct Curves {
    std::vector<double> time;                 ///< [s]
    std::vector<std::vector<double>> values;  ///< Of each of Exercise::displays.
};
/// With all numbers to 17 digits: equal texts are equal scores.
[[nodiscard]] std::string to_json(const Result& result);

/// An exercise as it runs in a session. One thread at a time, that of the session.
class Run {
  public:
    /// @param exercise, session  Have to outlive it; the session's scene is that of load_file().
    /// @throws DefError where the session's world lacks what the exercise names.
    Run(const Exercise& exercise, Session& session);
    ~Run();
    Run(const Run&) = delete;
    Run& operator=(const Run&) = delete;

    // --- Who may do what ------------------------------------------------------------------------
    /// Instructor, watcher, or a station.
    [[nodiscard]] bool is_role(std::string_view role) const noexcept;
    [[nodiscard]] bool may_set(std::string_view role, std::string_view input) const noexcept;

    // --- Levers and faults
    // ------------------------------------------------------------------------
    /// From the next step on, unless a fault keeps it back. Instead of Session::set_input(), which
    /// would pass faults by. @throws Refused; DefError as Session::set_input().
    void set_input(std::string_view role, std::string_view input, double value);
    /// What was asked for last; NaN where nobody has.
    [[nodiscard]] double asked(std::string_view input) const noexcept;
    /// @throws Refused unless the role is the instructor's; DefError where there is no such fault,
    /// or it cannot be done.
    void trigger(std::string_view role, std::string_view fault);
    void clear(std::string_view role, std::string_view fault);
    [[nodiscard]] bool active(std::string_view fault) const noexcept;
    /// An output as displays show it, which a fault may have frozen. @throws DefError.
    [[nodiscard]] double shown(std::string_view output) const;

    // --- Stepping
    // ---------------------------------------------------------------------------------
    /// Levers, faults and timeline that are due. @throws DefError where a fault cannot be done.
    void before_step();
    /// Alarms, goals, penalties, ends: after a step that went well.
    void after_step();
    /// The two around Session::step().
    Status step();
    /// Of the exercise: score and entries stay from then on, the session may go on.
    [[nodiscard]] bool ended() const noexcept;
    /// Ends it now, for instance where a step failed. @param why  In words.
    void end(const std::string& why, bool failed);
    [[nodiscard]] const Result& result() const noexcept;
    [[nodiscard]] const Curves& curves() const noexcept;

    // --- Going back
    // -------------------------------------------------------------------------------
    /// What a state that is saved now (World::save()) needs beside; a small number.
    [[nodiscard]] int mark();
    /// After the state of that time has been restored: levers, faults and score are those of the
    /// mark, and an entry says so. @throws DefError where there is no such mark.
    void back_to(int mark);

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

/// Score of a recording of an exercise, from a replay of its motion.
struct Rescored {
    Exercise exercise;
    Result result;
    Curves curves;
    bool same = true;  ///< Every frame had the recorded hash; else `difference` says more.
    std::string difference;
};
/// @param threads  Of the world that repeats it. @throws record::RecordingError where it is no
/// recording of an exercise, DefError or scene::SceneError where what it holds makes no sense.
[[nodiscard]] Rescored rescore(const record::Recording& recording, int threads = 1);

}  // namespace hawser::exercise
