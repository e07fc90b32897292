// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file session.h
/// A run: a scene, what is done to it while it runs, and what is kept of it.
///
/// ```cpp
/// hawser::Session session({.scene = "scenes/anchor_lines.json", .record = "run.hwr"});
/// while (session.time() < 10.0) {
///     session.set_input("ahts1/tow_winch", 0.5);
///     if (session.step() != hawser::Status::ok) break;
/// }
/// session.finish();
/// ```
/// What is done to its world between steps is part of the recording, so that `hawser replay`
/// repeats the run bit for bit without the code that did it (docs/recording.md). Everything that
/// writes files throws where that fails; the world is then as it was after the last step. One
/// thread at a time uses a session. Part of hawser::session.

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

/// How a session starts and what it writes. File names that are empty: none.
struct SessionDef {
    std::string scene{};             ///< Scene file …
    std::string scene_text{};        ///< … or, where that is empty, the scene itself (JSON).
    scene::Options options{};        ///< Changes to the scene, threads, budget.
    std::string restore{};           ///< Saved state to start with, of Session::save() …
    std::vector<std::byte> state{};  ///< … or that of World::save(); both empty: the start.
    std::string control{};           ///< Input values over time (CSV, docs/cli.md).
    std::string record{};            ///< Recording to write.
    std::string csv{};               ///< Table of tensions and motions to write.
    std::int32_t every = 1;          ///< Steps from one frame and row to the next, 1 to 10⁶.
    bool verify = false;             ///< Judge each step by the verifier; exact coupling alone.
};

class Session {
  public:
    /// Reads the scene. @throws scene::SceneError; DefError where the definition makes no sense or
    /// the state does not fit; record::RecordingError and other std::runtime_error where a file
    /// cannot be read or written.
    explicit Session(const SessionDef& def);
    /// Runs a scene that has been loaded. @param def  Its scene, scene_text and options are unused.
    explicit Session(scene::Scene scene, const SessionDef& def = {});
    /// Runs a world that the caller has built. A recording of it can be drawn, not replayed: it
    /// holds no scene to build the world from.
    explicit Session(World world, const SessionDef& def = {});
    /// What is open stays without its end, as after a crash: see finish().
    ~Session();
    Session(Session&&) noexcept;
    Session& operator=(Session&&) noexcept;
    Session(const Session&) = delete;
    Session& operator=(const Session&) = delete;

    // --- Reading ------------------------------------------------------------------------------
    [[nodiscard]] const scene::Scene& scene() const noexcept;
    [[nodiscard]] const World& world() const noexcept;
    [[nodiscard]] double time() const noexcept;  ///< [s]
    /// Numbers of the scene that differ from the scene of SessionDef::restore, with their paths.
    [[nodiscard]] std::span<const std::string> differences() const noexcept;
    /// Events of the last step that was taken.
    [[nodiscard]] std::span<const Event> events() const noexcept;
    /// What the scene's timeline had done before the step that was taken last.
    [[nodiscard]] std::span<const scene::Operation> operations() const noexcept;

    // --- Changes ------------------------------------------------------------------------------
    /// For all that may be done to a world between steps; a recording hears of it (changes.h).
    [[nodiscard]] World& world() noexcept;
    /// From the next step on. @throws DefError with the nearest name where there is no such input,
    /// or the value is not finite; nothing is then changed or recorded.
    void set_input(std::string_view name, double value);
    /// Go back, or on, to a state of this session: World::restore(), and the timeline and the
    /// control file go on from its time. A recording goes on from there, and so does its replay.
    /// @param made_of, state  World::structure() and World::save() of that time. @throws DefError;
    /// nothing has changed then.
    void restore(const Structure& made_of, std::span<const std::byte> state);

    // --- Outputs ------------------------------------------------------------------------------
    /// Record from the present state on, in place of a recording that there is. World has one
    /// listener of changes, which a recording needs. @param every  Steps from one frame to the
    /// next.
    /// @throws record::RecordingError.
    void record(const std::filesystem::path& file, std::int32_t every = 1);
    /// Write tensions and motions over time. @throws std::runtime_error.
    void write_csv(const std::filesystem::path& file, std::int32_t every = 1);
    /// Bytes of the caller's for the recording, before the step that comes next; without a
    /// recording nothing. They change nothing of a replay. @param kind  Whose they are, up to 32
    /// bytes. @throws record::RecordingError, DefError.
    void note(std::string_view kind, std::span<const std::byte> bytes);
    /// Call `observer` before and after each step from now on. It must outlive the session.
    void observe(Observer& observer);
    /// The present state in a file that only this scene restores (docs/recording.md).
    /// @throws std::runtime_error.
    void save(const std::filesystem::path& file) const;

    // --- Stepping -------------------------------------------------------------------------------
    /// Do what the scene's timeline has for this time, take over the values that the control file
    /// has for it, take one step, and write what is due. @throws DefError where an operation of the
    /// timeline cannot be done; those before it have been. @return the status of World::step();
    /// Status::diverged where an observer or the verifier objects to a step, which is then taken
    /// all the same: see objection().
    Status step();
    /// CPU time of the thread that called step(), in World::step() of the last one [s].
    [[nodiscard]] double step_cpu_seconds() const noexcept;
    /// End the step under way, or else the next one, with Status::cancelled. See World::cancel().
    void cancel() noexcept;
    /// What an observer or the verifier found wrong; "": nothing.
    [[nodiscard]] const std::string& objection() const noexcept;
    /// Judge the last state and close what is open with a last frame and how the run ended:
    /// `failed` where the last step failed, was objected to, or the verdict on the run is wrong
    /// while settings.on_diverged is `stop`; `interrupted` where it was cancelled or the caller
    /// says so.
    record::Ending finish(bool interrupted = false);

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace hawser
