// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file recording.h
/// Recordings: a scene, where it started, what was commanded and where everything went.
///
/// The format is described in docs/recording.md. A recording is written chunk by chunk while
/// the simulation runs. After a crash everything up to the last complete chunk can be read. Part of
/// hawser::session, which writes them (session.h).

#include <hawser/def.h>
#include <hawser/math.h>
#include <hawser/stats.h>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace hawser {
class World;
}

namespace hawser::record {

class ByteReader;  // src/record/bytes.h

/// A recording that cannot be written or read; what() begins with the file.
struct RecordingError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// How and on what a recording was made.
struct RecordingSettings {
    double step = 0.0;  ///< Time step [s].
    Form form = Form::automatic;
    std::int32_t threads = 1;
    std::int32_t stride = 1;  ///< Steps from one frame to the next.
    std::string instruction_set, version, processor;
};

struct RecordedBody {
    std::string name;
    BodyKind kind = BodyKind::rigid;
    Vec3 half_size{0.0, 0.0, 0.0};  ///< [m]
    Pose start;                     ///< At the first frame.
};

struct RecordedCable {
    std::string name, line_type;
    double EA = 0.0, breaking_load = 0.0, length = 0.0;  ///< [N], [N], [m]
    std::vector<std::int32_t> nodes;                     ///< Indices of bodies.
    /// Where the cable holds its first and its last body, in their frames [m].
    Vec3 end[2] = {Vec3::Zero(), Vec3::Zero()};
    std::int32_t elements = 0;
    std::int32_t first_element = 0;  ///< In Frame::tensions.
};

/// An element of a wire between points in the frames of two bodies.
struct RecordedPiece {
    std::int32_t body[2] = {-1, -1};
    Vec3 point[2] = {Vec3::Zero(), Vec3::Zero()};  ///< [m]
};

/// A wire of which nodes have come or gone: in place of the cable of its name, from a frame on.
struct RecordedWire {
    std::string name;
    std::vector<RecordedPiece> pieces;  ///< From end to end.
    std::size_t first_piece = 0;        ///< In Frame::pulls.
};

/// A joint or rod, for pictures: it joins a point of one body to a point of another.
struct RecordedJoint {
    std::int32_t body[2] = {-1, -1};
    Vec3 point[2] = {Vec3::Zero(), Vec3::Zero()};  ///< In the bodies' frames [m].
};

enum class OutlineKind : std::uint8_t {
    solid,  ///< The convex hull of the points, each with a ball of the radius around it.
    plane,  ///< Through the first point; the second one is the direction out of the solid.
    lines,  ///< Lines through `row` points each.
};

/// A shape that touches, for pictures.
struct RecordedOutline {
    std::int32_t body = -1;
    OutlineKind kind = OutlineKind::solid;
    double radius = 0.0;       ///< [m]
    std::int32_t row = 0;      ///< Points of one line.
    std::vector<Vec3> points;  ///< In the body's frame [m].
};

struct RecordedInput {
    std::int64_t step = 0;  ///< Set when this many steps had been taken.
    std::int32_t input = 0;
    double value = 0.0;
};

/// What else was done to the world between two steps: added, removed, moved … (changes.h).
struct RecordedChanges {
    std::int64_t step = 0;             ///< Done when this many steps had been taken, …
    std::size_t inputs_before = 0;     ///< … behind this many of Recording::inputs.
    std::span<const std::byte> bytes;  ///< For apply_changes().
};

/// What a program kept beside the motion (Session::note()).
struct RecordedNote {
    std::int64_t step = 0;             ///< When this many steps had been taken.
    std::string kind;                  ///< Whose it is.
    std::span<const std::byte> bytes;  ///< For whose it is.
};

/// What systems loaded bodies with in one step (system.h).
struct RecordedLoads {
    std::int64_t step = 0;             ///< Taken when this many steps had been taken.
    std::span<const std::byte> bytes;  ///< For Repeater.
};

/// Where a run went back, or on, to another state of its own (World::restore()): what follows is
/// another take, whose steps begin anew. The first take has no entry.
struct RecordedTake {
    std::int64_t from = 0;  ///< Steps taken when it did so, …
    std::int64_t to = 0;    ///< … and those of the state it went to.
    /// Entries of the recording that belong to takes before it.
    std::size_t frames = 0, inputs = 0, changes = 0, loads = 0, cuts = 0;
};

/// A step that left something out to keep to its budget.
struct RecordedCut {
    std::int64_t step = 0;  ///< Taken when this many steps had been taken.
    Degradation left_out;
    DegradedBy cause = DegradedBy::nothing;
    double foreseen = 0.0;  ///< StepStats::foreseen_seconds [s].
};

struct RecordedEvent {
    double time = 0.0;  ///< [s]
    EventKind kind = EventKind::warning;
    double value = 0.0;
    std::string where;  ///< Name of the interaction.
};

/// State of the scene at one time, in the precision of pictures.
struct Frame {
    std::int64_t step = 0;
    double time = 0.0;               ///< [s]
    std::uint64_t hash = 0;          ///< World::motion_hash().
    double violation_max = 0.0;      ///< [m]
    double momentum_residual = 0.0;  ///< Relative.
    double energy = 0.0;             ///< Mechanical [J].
    double water = 0.0;              ///< z of still water of a sea [m].
    std::vector<Pose> poses;         ///< Of every body; that of the start where it is not there.
    std::vector<bool> there;         ///< By body: it had come, and had not gone.
    std::vector<float> tensions;     ///< Of every element of every cable [N].
    /// What wires are made of, where that is no longer what cables say; the recording's own.
    const std::vector<RecordedWire>* wires = nullptr;
    std::vector<float> pulls;  ///< Tension of each of their pieces [N], −1: parted.
    /// Links, legs of hooks and slings that have come since the start, of one piece each.
    const std::vector<RecordedWire>* lines = nullptr;
    std::vector<float> line_pulls;                           ///< As `pulls`.
    const std::vector<std::int32_t>* gone_joints = nullptr;  ///< In Recording::joints; null: none.
};

enum class Ending : std::uint8_t { finished, interrupted, failed, unknown };

/// A recording in memory. Frames are decoded when asked for.
class Recording {
  public:
    Recording(Recording&&) noexcept = default;
    Recording& operator=(Recording&&) noexcept = default;
    Recording(const Recording&) = delete;  // Spans point into the bytes.
    Recording& operator=(const Recording&) = delete;

    /// @throws RecordingError when the file is no recording or holds no complete start.
    [[nodiscard]] static Recording open(const std::filesystem::path& file);
    [[nodiscard]] static Recording read(std::vector<std::byte> bytes, const std::string& name);

    std::string file;
    std::string scene_name, scene_path, scene_text;
    std::uint64_t scene_hash = 0;
    RecordingSettings settings;
    std::vector<RecordedBody> bodies;  ///< Of the scene, then those that came.
    std::size_t start_bodies = 0;      ///< Of the scene.
    std::vector<RecordedCable> cables;
    std::vector<std::int32_t> plot_cables, plot_bodies;
    std::vector<RecordedJoint> joints;
    std::int32_t element_count = 0;
    std::int64_t start_step = 0;
    std::uint64_t start_hash = 0;
    std::span<const std::byte> snapshot;    ///< For World::restore.
    std::vector<std::string> input_names;   ///< By index of RecordedInput::input; may be missing.
    std::vector<bool> inner_inputs;         ///< By the same: driven by a system they are a part of.
    std::vector<RecordedOutline> outlines;  ///< May be missing.
    std::vector<RecordedInput> inputs;
    std::vector<RecordedChanges> changes;
    std::vector<RecordedLoads> loads;
    std::vector<RecordedNote> notes;
    std::vector<RecordedCut> cuts;
    std::vector<RecordedTake> takes;  ///< Steps of all the above ascend within a take only.
    std::vector<RecordedEvent> events;
    Ending ending = Ending::unknown;
    std::int64_t end_step = 0;   ///< With an ending only.
    std::uint64_t end_hash = 0;  ///< With an ending only.
    std::string damage;          ///< Why reading stopped before the end; empty if it did not.

    [[nodiscard]] std::size_t frame_count() const noexcept { return frames_.size(); }
    [[nodiscard]] Frame frame(std::size_t index) const;
    /// Of a frame: how many entries of `takes` there are before it.
    [[nodiscard]] std::size_t take_of(std::size_t frame) const noexcept;
    /// By body: a lump of a wire in some frame in which nodes had come or gone.
    [[nodiscard]] std::vector<bool> wire_lumps() const;
    /// Without poses and tensions: cheap.
    [[nodiscard]] Frame frame_head(std::size_t index) const;

  private:
    Recording() = default;
    void read_chunk(std::string_view kind, std::span<const std::byte> payload, int& stage);
    void read_scene(ByteReader in);
    void read_settings(ByteReader in);
    void read_layout(ByteReader in);
    void read_inputs(ByteReader in);
    void read_changes(ByteReader in);
    void read_bodies(ByteReader in);
    void read_loads(ByteReader in);
    void read_take(ByteReader in);
    void add_cut(const RecordedCut& cut);
    void check_gap(std::int64_t step, bool frame) const;
    template <class T>
    [[nodiscard]] std::int64_t least_step(const std::vector<T>& all,
                                          std::size_t RecordedTake::* before) const;
    void read_note(ByteReader in);
    struct Wires;
    using WireTables = std::vector<std::unique_ptr<Wires>>;
    void read_wires(ByteReader in, WireTables& tables, bool joints_follow);
    void read_pulls(std::span<const std::byte> payload, const WireTables& tables);
    static const Wires* find_wires(std::size_t index, const WireTables& tables,
                                   std::vector<float>& pulls);
    void find_wires(std::size_t index, Frame& frame) const;
    void read_cut(ByteReader in);
    void read_event(ByteReader in);
    void read_end(ByteReader in);
    void check_floats(ByteReader in) const;
    void add_frame(std::span<const std::byte> payload);

    /// Bodies that frames have from one of them on: indices in `bodies`, in the order of a frame.
    struct Layout {
        std::size_t first_frame = 0, floats = 0;
        std::vector<std::int32_t> bodies;
    };
    [[nodiscard]] const Layout& layout_of(std::size_t frame) const;
    [[nodiscard]] std::size_t frame_size() const noexcept;

    std::vector<std::byte> bytes_;
    std::vector<std::span<const std::byte>> frames_;
    std::vector<Layout> layouts_;
    struct Wires {
        std::size_t first_frame = 0, pieces = 0;
        std::vector<RecordedWire> wires;
        std::vector<std::span<const std::byte>> pulls;  ///< Of each frame from there on.
        std::vector<std::int32_t> gone;                 ///< Of lines: joints of the start.
    };
    WireTables wires_, lines_;                            ///< Frames point into them.
    std::vector<std::pair<std::size_t, double>> waters_;  ///< From which frame on; Frame::water.
};

/// Floats of a body's pose in a frame: 7, 3, 1 or 0.
[[nodiscard]] int pose_floats(BodyKind kind) noexcept;

/// True for bodies between the ends of a cable: nodes and links, too many to name.
[[nodiscard]] std::vector<bool> cable_interior(const Recording& recording);

}  // namespace hawser::record
