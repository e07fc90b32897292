// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file recording_writer.h
/// Writes recordings (docs/recording.md).

#include <hawser/hawser.h>
#include <hawser/recording.h>

#include "record/bytes.h"
#include "record/changes.h"
#include "record/recording_lines.h"
#include "record/recording_outputs.h"
#include "record/recording_wires.h"
#include "record/scene_info.h"

#include <cstdio>
#include <filesystem>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

namespace hawser::record {

/// Loads of systems in a recording.
enum class LoadStorage : std::uint8_t {
    needed,  ///< Loads that a replay cannot compute again.
    all,     ///< Loads of all bodies, in the format of earlier versions.
};

/// Writes a recording. Functions throw RecordingError when the disk is full.
class RecordingWriter {
  public:
    /// Start the file with the scene, the settings, the layout and the state of the world.
    RecordingWriter(const std::filesystem::path& file, const SceneInfo& scene, const World& world,
                    const RecordingSettings& settings, LoadStorage loads = LoadStorage::needed);
    void add_frame(const World& world);
    void add_inputs(std::span<const RecordedInput> changes);
    /// Check that no change is missing. @throws RecordingError if memory was insufficient for one.
    void check_complete(const ChangeBytes& changes) const;
    /// Write changes of the world since the last call (changes.h), before the next step.
    void add_changes(std::int64_t step, std::span<const std::byte> changes, bool bodies_changed);
    /// Write the loads of systems in the last step that a replay needs, if any.
    void add_loads(const World& world);
    void add_note(std::int64_t step, std::string_view kind, std::span<const std::byte> bytes);
    void add_cut(const RecordedCut& cut);
    void add_event(const World& world, const Event& event);
    /// Write that the world has restored one of its earlier states. The last change must be this
    /// restore.
    void add_branch(std::int64_t from, std::int64_t to);
    void finish(const World& world, Ending ending);

  private:
    struct CloseFile {
        void operator()(std::FILE* f) const { std::fclose(f); }
    };
    void write_chunk(const char* kind);
    [[noreturn]] void fail() const;

    std::filesystem::path file_;
    std::unique_ptr<std::FILE, CloseFile> out_;
    ByteWriter payload_;
    struct FramedBody {
        BodyId id;
        BodyKind kind;
        Pose start;
    };
    void add_all_loads(const World& world);
    void follow_sea(const World& world);
    void follow_bodies(const World& world);
    void follow_wires(const World& world);
    void follow_lines(const World& world);
    void follow_water(const World& world);
    void follow_outputs(const World& world);
    [[nodiscard]] std::vector<BodyId> bodies_of_frame() const;

    LoadStorage loads_;
    std::shared_ptr<const LineSea> sea_;  ///< Sea of the last LSEA chunk.
    std::int32_t seas_ = 0;               ///< Number of LSEA chunks.
    std::vector<InteractionId> elements_;
    std::vector<FramedBody> bodies_;  ///< Bodies of a frame, in its order.
    WireFollower wires_;
    LineFollower lines_;
    OutputFollower outputs_;
    double water_ = 0.0;          ///< z of still water in the frame before [m].
    bool wires_changed_ = false;  ///< Than those of the start: frames have their tensions.
    /// True if lines were added or removed: frames then have their tensions.
    bool lines_changed_ = false;
    bool bodies_changed_ = false;  ///< Than bodies_: they are written before the next frame.
};

/// Return the number of bytes of one frame in the file.
[[nodiscard]] std::size_t frame_bytes(const World& world, const SceneInfo& scene);
/// Return the number of bytes of the loads that the sea adds to one step of the file. Loads of
/// other systems are not counted.
[[nodiscard]] std::size_t sea_load_bytes(const World& world);

}  // namespace hawser::record
