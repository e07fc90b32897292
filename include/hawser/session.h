// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file session.h
/// Session: runs a scene with its inputs and timeline, and writes recordings and tables.
///
/// ```cpp
/// hawser::Session session({.scene = "scenes/anchor_lines.json", .record = "run.hwr"});
/// while (session.time() < 10.0) {
///     session.set_input("ahts1/tow_winch", 0.5);
///     if (session.step() != hawser::Status::ok) break;
/// }
/// session.finish();
/// ```
/// A recording contains all changes to the world between steps. The command `hawser replay`
/// therefore repeats the run bit for bit without the program that made them (docs/recording.md).
/// Functions that write files throw on failure; the world then has the state after the last step.
/// One thread at a time may use a session. Part of hawser::session.

#include <hawser/observer.h>
#include <hawser/recording.h>
#include <hawser/scene.h>
#include <hawser/structure.h>
#include <hawser/world.h>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace hawser {

/// Definition of a session: its scene, start state and output files. An empty file name disables
/// the file.
struct SessionDef {
    std::string scene{};       ///< Scene file; empty: `scene_text` is used.
    std::string scene_text{};  ///< Scene as JSON text, if `scene` is empty.
    scene::Options options{};  ///< Changes to the scene, threads, budget.
    std::string restore{};  ///< File with a saved state of Session::save(); empty: `state` is used.
    /// State of WorldState::save(), if `restore` is empty. Its world must have the wires and nodes
    /// of the scene; after edits use Session::save() and `restore`. If both are empty, the session
    /// starts in the initial state of the scene.
    std::vector<std::byte> state{};
    std::string control{};   ///< File with input values over time (CSV, docs/cli.md).
    std::string record{};    ///< Recording file.
    std::string csv{};       ///< CSV file of tensions and motions.
    std::int32_t every = 1;  ///< Steps between frames and between rows, 1 to 10⁶.
    bool verify = false;     ///< True: the verifier checks each step; requires exact coupling.
};

/// Run of a scene or world.
class Session {
  public:
    /// Read the scene of a definition, and open the output files.
    /// @throws scene::SceneError if the scene is invalid
    /// @throws DefError if the definition is invalid or the state does not belong to the scene
    /// @throws record::RecordingError and other std::runtime_error if a file cannot be read or
    /// written
    explicit Session(const SessionDef& def);
    /// Run a loaded scene.
    /// @param def  Its scene, scene_text and options are not used.
    explicit Session(scene::Scene scene, const SessionDef& def = {});
    /// Run a world that the caller has built. Its recording can be drawn but not replayed, since it
    /// contains no scene.
    explicit Session(World world, const SessionDef& def = {});
    /// Close the files without an end mark, as after a crash; see finish().
    ~Session();
    Session(Session&&) noexcept;
    Session& operator=(Session&&) noexcept;
    Session(const Session&) = delete;
    Session& operator=(const Session&) = delete;

    // --- Reading ------------------------------------------------------------------------------
    /// Return the scene.
    [[nodiscard]] const scene::Scene& scene() const noexcept;
    /// Return the world for reading.
    [[nodiscard]] const World& world() const noexcept;
    /// Return the simulation time [s].
    [[nodiscard]] double time() const noexcept;
    /// Return the numbers in which the scene differs from that of the saved state
    /// SessionDef::restore, with path and both values.
    [[nodiscard]] std::span<const std::string> differences() const noexcept;
    /// Return the events of the last completed step.
    [[nodiscard]] std::span<const Event> events() const noexcept;
    /// Return the timeline operations that were executed before the last completed step.
    [[nodiscard]] std::span<const scene::Operation> operations() const noexcept;

    // --- Changes ------------------------------------------------------------------------------
    /// Return the world for changes between steps. A recording stores these changes (changes.h).
    [[nodiscard]] World& world() noexcept;
    /// Set an input from the next step on.
    /// @throws DefError with the nearest name if the input does not exist, or the value is not
    /// finite. Nothing is then changed or recorded.
    void set_input(std::string_view name, double value);
    /// Restore an earlier or later state of this session. Timeline and control file continue from
    /// its time. The recording continues with a new branch, which a replay repeats.
    /// @param made_of  WorldStateView::structure() at the time of the state.
    /// @param state  WorldStateView::save() at this time.
    /// @throws DefError if the state does not belong to the session; nothing is then changed.
    void restore(const Structure& made_of, std::span<const std::byte> state);

    // --- Outputs ------------------------------------------------------------------------------
    /// Start a recording in the present state. It replaces an open recording. A recording uses the
    /// world's only change listener.
    /// @param every  Number of steps between frames.
    /// @throws record::RecordingError if the file cannot be written.
    void record(const std::filesystem::path& file, std::int32_t every = 1);
    /// Write a table (CSV) of tensions and motions over time from now on.
    /// @param every  Number of steps between rows.
    /// @throws std::runtime_error if the file cannot be written.
    void write_csv(const std::filesystem::path& file, std::int32_t every = 1);
    /// Add a note with data of the caller to the recording, before the next step. Without a
    /// recording this has no effect. Notes do not influence a replay.
    /// @param kind  Owner of the note, up to 32 bytes.
    /// @param bytes  Data, which only its owner reads.
    /// @throws record::RecordingError, DefError.
    void note(std::string_view kind, std::span<const std::byte> bytes);
    /// Add an observer, which is called before and after each step from now on.
    /// @param observer  It must outlive the session.
    void observe(Observer& observer);
    /// Save the present state to a file, which only this scene can restore (docs/recording.md).
    /// @throws std::runtime_error if the file cannot be written.
    void save(const std::filesystem::path& file) const;

    // --- Stepping -------------------------------------------------------------------------------
    /// Execute due timeline operations, apply due values of the control file, perform one step, and
    /// write due output.
    /// @return the status of World::step(), or Status::diverged if an observer or the verifier
    /// rejects the step. The world then keeps the state after the step; see objection().
    /// @throws DefError if a timeline operation is not possible; operations before it remain in
    /// effect.
    Status step();
    /// Return the CPU time of World::step() in the thread of the last step() [s].
    [[nodiscard]] double step_cpu_seconds() const noexcept;
    /// Cancel the running step, or else the next one, with Status::cancelled; see World::cancel().
    void cancel() noexcept;
    /// Return the fault that an observer or the verifier has found; "": none.
    [[nodiscard]] const std::string& objection() const noexcept;
    /// Check the last state, and close the files with a last frame and the ending of the run.
    /// @param interrupted  True: the caller has interrupted the run.
    /// @return `interrupted` if the run was cancelled or interrupted; `failed` if the last step
    /// failed or was rejected, or if the monitors failed with settings.on_diverged `stop`;
    /// otherwise `finished`.
    record::Ending finish(bool interrupted = false);

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace hawser
