// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file recording.h
/// Recordings: a file with a scene, its start state, all changes to it, and frames of its motion.
/// From start and changes a replay computes the run again bit for bit (repeater.h); frames are for
/// pictures.
///
/// ```
///     scene │ settings │ start state │ frame │ change │ frame │ … │ ending
/// ```
/// A recording is written chunk by chunk during the run (session.h). After a crash, all complete
/// chunks can be read. A *branch* begins when the run is restored to an earlier or later state.
/// docs/recording.md describes the format. Part of hawser::session.

#include <hawser/def.h>
#include <hawser/line_sea.h>
#include <hawser/math.h>
#include <hawser/stats.h>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
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

/// Exception if a recording cannot be written or read. Its message begins with the file.
struct RecordingError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// Settings and machine of a recording.
struct RecordingSettings {
    double step = 0.0;            ///< Time step [s].
    Form form = Form::automatic;  ///< Form of the equations.
    std::int32_t threads = 1;     ///< Number of threads.
    std::int32_t stride = 1;      ///< Number of steps between frames.
    /// Instruction set, version of the library, name of the processor.
    std::string instruction_set, version, processor;
};

/// Properties of a body for pictures.
struct RecordedBody {
    std::string name;                 ///< Name; may be empty.
    BodyKind kind = BodyKind::rigid;  ///< Kind.
    Vec3 half_size{0.0, 0.0, 0.0};    ///< Half sizes of the box in pictures [m].
    Pose start;                       ///< Pose in the first frame.
};

/// Properties of a cable for pictures.
struct RecordedCable {
    std::string name, line_type;                         ///< Name, and name of the line type.
    double EA = 0.0, breaking_load = 0.0, length = 0.0;  ///< Axial stiffness [N], breaking load
                                                         ///< [N], unstretched length [m].
    std::vector<std::int32_t> nodes;                     ///< Nodes in order, as indices of bodies.
    /// Positions of the cable's ends in the frames of its first and last body [m].
    Vec3 end[2] = {Vec3::Zero(), Vec3::Zero()};
    std::int32_t elements = 0;       ///< Number of elements.
    std::int32_t first_element = 0;  ///< Index of its first element in Frame::tensions.
};

/// Element of a wire between points in the frames of two bodies.
struct RecordedPiece {
    std::int32_t body[2] = {-1, -1};               ///< Indices of the bodies.
    Vec3 point[2] = {Vec3::Zero(), Vec3::Zero()};  ///< End points in the bodies' frames [m].
};

/// Wire whose nodes have changed. From a frame on it replaces the cable with the same name.
struct RecordedWire {
    std::string name;                   ///< Name of the wire.
    std::vector<RecordedPiece> pieces;  ///< Elements in order.
    std::size_t first_piece = 0;        ///< Index of its first element in Frame::pulls.
};

/// Joint or rod for pictures, between a point of one body and a point of another.
struct RecordedJoint {
    std::int32_t body[2] = {-1, -1};               ///< Indices of the bodies.
    Vec3 point[2] = {Vec3::Zero(), Vec3::Zero()};  ///< End points in the bodies' frames [m].
};

/// Form of an outline.
enum class OutlineKind : std::uint8_t {
    solid,  ///< Convex hull of balls of `radius` around the points.
    plane,  ///< Plane through the first point; the second is the direction out of the solid.
    lines,  ///< Lines with `row` points each.
};

/// Outline of a collision shape for pictures.
struct RecordedOutline {
    std::int32_t body = -1;                 ///< Index of the body.
    OutlineKind kind = OutlineKind::solid;  ///< Form.
    double radius = 0.0;                    ///< Radius of a solid's balls [m].
    std::int32_t row = 0;                   ///< Number of points of one line.
    std::vector<Vec3> points;               ///< Points in the body's frame [m].
};

/// Input that was set between two steps.
struct RecordedInput {
    std::int64_t step = 0;   ///< Number of completed steps before it was set.
    std::int32_t input = 0;  ///< Index of the input.
    double value = 0.0;      ///< Value in SI units.
};

/// Other changes of the world between two steps: additions, removals, poses and so on (changes.h).
struct RecordedChanges {
    std::int64_t step = 0;          ///< Number of completed steps before the changes.
    std::size_t inputs_before = 0;  ///< Number of entries of Recording::inputs before the changes.
    std::span<const std::byte> bytes;  ///< Encoded changes, read by Repeater.
};

/// Note of a program (Session::note()).
struct RecordedNote {
    std::int64_t step = 0;             ///< Number of completed steps before the note.
    std::string kind;                  ///< Owner of the note.
    std::span<const std::byte> bytes;  ///< Content, defined by its owner.
};

/// Loads of systems on bodies in one step (system.h).
struct RecordedLoads {
    std::int64_t step = 0;  ///< Number of completed steps before the step with these loads.
    std::span<const std::byte> bytes;  ///< Encoded loads, read by Repeater.
};

/// Start of a branch: the run was restored to another of its own states (WorldState::restore()).
/// The number of completed steps continues from that state. The first branch has no entry.
struct RecordedTake {
    std::int64_t from = 0;  ///< Number of completed steps before the restore.
    std::int64_t to = 0;    ///< Number of completed steps of the restored state.
    /// Numbers of entries of Recording::frame() to Recording::cuts before the branch.
    std::size_t frames = 0, inputs = 0, changes = 0, loads = 0, cuts = 0;
};

/// Step that omitted work to meet its budget.
struct RecordedCut {
    std::int64_t step = 0;                   ///< Number of completed steps before this step.
    Degradation left_out;                    ///< Omitted work.
    DegradedBy cause = DegradedBy::nothing;  ///< Reason.
    double foreseen = 0.0;                   ///< Predicted time, StepStats::foreseen_seconds [s].
};

/// Event of a step.
struct RecordedEvent {
    double time = 0.0;                    ///< Time [s].
    EventKind kind = EventKind::warning;  ///< Kind.
    double value = 0.0;                   ///< Value, as EventKind states.
    std::string where;                    ///< Name of the interaction or body.
};

/// Output or signal whose value each frame has.
struct RecordedOutput {
    std::string name;  ///< Name, as OutputDef::name; "system.signal" for a signal.
    std::string unit;  ///< Unit label. Values are in SI units.
};

/// State of the scene at one time, in single precision for pictures.
struct Frame {
    std::int64_t step = 0;           ///< Number of completed steps.
    double time = 0.0;               ///< Time [s].
    std::uint64_t hash = 0;          ///< WorldState::motion_hash().
    double violation_max = 0.0;      ///< Largest violation [m].
    double momentum_residual = 0.0;  ///< Relative momentum residual [1].
    double energy = 0.0;             ///< Mechanical energy [J].
    double water = 0.0;              ///< z of still water, if there is a sea [m].
    std::vector<Pose> poses;  ///< Pose of every body; the start pose if the body does not exist.
    std::vector<bool> there;  ///< True for each body that exists in this frame.
    std::vector<float> tensions;  ///< Tension of every element of every cable [N].
    /// Wires whose elements differ from those of the cables; owned by the recording. Null: none.
    const std::vector<RecordedWire>* wires = nullptr;
    std::vector<float> pulls;  ///< Tension of each element of `wires` [N]; −1: broken.
    /// Links of gear, and legs of hooks and slings, that were added since the start, with one
    /// element each; owned by the recording. Null: none.
    const std::vector<RecordedWire>* lines = nullptr;
    std::vector<float> line_pulls;  ///< Tension of each element of `lines` [N]; −1: broken.
    const std::vector<std::int32_t>* gone_joints = nullptr;  ///< Indices in Recording::joints of
                                                             ///< removed joints; null: none.
};

/// Ending of a run; `unknown` if the recording is incomplete.
enum class Ending : std::uint8_t { finished, interrupted, failed, unknown };

/// Recording in memory. Frames are decoded on request.
class Recording {
  public:
    Recording(Recording&&) noexcept = default;
    Recording& operator=(Recording&&) noexcept = default;
    Recording(const Recording&) = delete;  // Not copyable: spans point into the bytes.
    Recording& operator=(const Recording&) = delete;

    /// Read a recording from a file.
    /// @throws RecordingError if it is not a recording or has no complete start.
    [[nodiscard]] static Recording open(const std::filesystem::path& file);
    /// Read a recording from memory.
    /// @param name  Name for messages.
    /// @throws RecordingError as open().
    [[nodiscard]] static Recording read(std::vector<std::byte> bytes, const std::string& name);

    std::string file;                                ///< File, or the name for messages.
    std::uint32_t format = 0;                        ///< Version of the format.
    std::string scene_name, scene_path, scene_text;  ///< Name, file and resolved text of the scene.
    std::uint64_t scene_hash = 0;                    ///< Hash of the scene, scene::Scene::hash.
    RecordingSettings settings;                      ///< Settings and machine.
    std::vector<RecordedBody> bodies;                ///< Bodies of the scene, then added bodies.
    std::size_t start_bodies = 0;                    ///< Number of bodies of the scene.
    std::vector<RecordedCable> cables;               ///< Cables of the scene.
    /// Indices of the cables and bodies with curves in plots.
    std::vector<std::int32_t> plot_cables, plot_bodies;
    std::vector<RecordedJoint> joints;    ///< Joints of the scene.
    std::int32_t element_count = 0;       ///< Number of elements of all cables.
    std::int64_t start_step = 0;          ///< Number of completed steps of the start state.
    std::uint64_t start_hash = 0;         ///< Motion hash of the start state.
    std::span<const std::byte> snapshot;  ///< Start state, for WorldState::restore().
    std::vector<std::string>
        input_names;                 ///< Names of inputs by RecordedInput::input; may be empty.
    std::vector<bool> inner_inputs;  ///< True for inputs that a system owns and drives, by the same
                                     ///< index.
    std::vector<RecordedOutline> outlines;  ///< Outlines of collision shapes; may be empty.
    std::vector<RecordedOutput> outputs;    ///< Outputs of all frames; empty in earlier versions.
    std::vector<RecordedInput> inputs;      ///< Inputs that were set.
    std::vector<RecordedChanges> changes;   ///< Other changes.
    std::vector<RecordedLoads> loads;       ///< Loads of systems.
    std::vector<LineSea> seas;  ///< Seas whose loads on nodes of wires a replay computes again.
    std::vector<RecordedNote> notes;  ///< Notes of programs.
    std::vector<RecordedCut> cuts;    ///< Steps that omitted work.
    std::vector<RecordedTake>
        takes;  ///< Branches. Steps of the entries above ascend only within one.
    std::vector<RecordedEvent> events;  ///< Events.
    Ending ending = Ending::unknown;    ///< Ending of the run.
    std::int64_t end_step = 0;          ///< Number of completed steps at the end, if it is known.
    std::uint64_t end_hash = 0;         ///< Motion hash at the end, if it is known.
    std::string damage;  ///< Reason for which reading stopped before the end of the file; "": none.

    /// Return the number of frames.
    [[nodiscard]] std::size_t frame_count() const noexcept { return frames_.size(); }
    /// Decode a frame.
    /// @param index  0 to frame_count() − 1.
    [[nodiscard]] Frame frame(std::size_t index) const;
    /// Return the number of branches (entries of `takes`) that begin before a frame.
    [[nodiscard]] std::size_t take_of(std::size_t frame) const noexcept;
    /// Return for each body whether it is a lumped mass of a RecordedWire in any frame.
    [[nodiscard]] std::vector<bool> wire_lumps() const;
    /// Decode a frame without poses and tensions, at small cost.
    [[nodiscard]] Frame frame_head(std::size_t index) const;
    /// Return the values of `outputs` at a frame, in SI units; NaN if an output did not exist.
    [[nodiscard]] std::vector<double> output_values(std::size_t frame) const;

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
    void read_output_names(ByteReader in);
    void read_output_values(std::span<const std::byte> payload);
    void read_cut(ByteReader in);
    void read_event(ByteReader in);
    void read_end(ByteReader in);
    void check_floats(ByteReader in) const;
    void add_frame(std::span<const std::byte> payload);

    /// Bodies of the frames from one frame on: indices in `bodies`, in the order of a frame.
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
        std::vector<std::span<const std::byte>> pulls;  ///< Tensions of each frame from the first
                                                        ///< one on.
        std::vector<std::int32_t> gone;  ///< Lines only: joints of the start that are removed.
    };
    /// Outputs from one frame on.
    struct OutputTable {
        std::size_t first_frame = 0;
        std::vector<std::int32_t> outputs;               ///< Indices in `outputs`.
        std::vector<std::span<const std::byte>> values;  ///< Values of each frame from the first
                                                         ///< one on.
    };
    std::vector<OutputTable> output_tables_;
    std::map<std::pair<std::string, std::string>, std::int32_t>
        output_indices_;                                  ///< By name, unit.
    WireTables wires_, lines_;                            ///< Frames point into them.
    std::vector<std::pair<std::size_t, double>> waters_;  ///< First frame and Frame::water.
};

/// Return the number of floats of the pose of a body in a frame: 7, 3, 1 or 0.
[[nodiscard]] int pose_floats(BodyKind kind) noexcept;

/// Return for each body whether it is an inner node or link of a cable.
[[nodiscard]] std::vector<bool> cable_interior(const Recording& recording);

}  // namespace hawser::record
