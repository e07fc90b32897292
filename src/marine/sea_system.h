// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file sea_system.h
/// Apply the sea at the beginning of each step (hawser/sea.h).
///
/// Nodes of lines, bodies, corners of hulls and segments of rods are listed in the order of the
/// definition and of the wires' nodes. Several threads compute their loads, each into separate
/// entries. Loads are then added in that order, so that no sum depends on threads.
///
/// *Lines.* The definition gives each existing element a sort (its coefficients). An element that
/// is inserted later has the sort of the previous element of its wire; at the beginning of a wire
/// it has that of the next element with a known sort. The elements of a wire that is cut off keep
/// their sorts. If the line ends on a body at the definition, the half element at the body gets no
/// loads of the water.

#include <hawser/line_sea.h>
#include <hawser/sea.h>
#include <hawser/sea_accuracy.h>

#include "marine/drag.h"
#include "marine/field.h"
#include "marine/hull_flow.h"
#include "marine/hull_sums.h"
#include "marine/radiation.h"
#include "marine/rods.h"
#include "marine/wave_force.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

namespace hawser::marine {

/// Sorts of elements, and the bodies that hold lines, at the time of the definition.
struct LineTable {
    struct Known {
        std::int32_t generation = -1, sort = -1;
    };
    std::vector<LineWater> sorts;      ///< With their volumes.
    std::vector<Known> of_element;     ///< Sort by index of the interaction.
    std::vector<BodyId> holders;       ///< Ascending.
    std::array<int, 64> length_param;  ///< By kind, −1: none.

    [[nodiscard]] int coefficient_set_of(InteractionId id) const noexcept;
    [[nodiscard]] bool holds(BodyId id) const noexcept;
};
/// Return the index of the parameter `length` by kind of element, −1: none.
[[nodiscard]] std::array<int, 64> length_params();
/// Return the definition of the lines in a sea for their loads; null if no line is in the sea.
[[nodiscard]] std::shared_ptr<const LineSea> line_part(const SeaDef& def, double gravity,
                                                       const LineTable& table);
/// Add the load of a point to that of a body.
void add_point(const PointLoad& from, const BodyLoad& to) noexcept;
/// List the different sets of line coefficients of a sea. @throws SeaError
[[nodiscard]] LineTable line_table(const World& world, const SeaDef& def);

/// Nodes of lines in the water.
class LineNodes {
  public:
    struct Lump {
        BodyId body{};
        PointMotion motion{Vec3::Zero(), Vec3::Zero()};
        HalfElement half[2]{};
        int halves = 0;  ///< Number of half elements; 0: no node, or not in the water.
    };
    explicit LineNodes(LineTable table) : table_(std::move(table)) {}
    /// List all wires of the world; none if no wire has water loads. @throws std::bad_alloc
    void list(const World& world);
    [[nodiscard]] int wires() const noexcept { return static_cast<int>(wires_.size()); }
    /// List the present nodes of one wire.
    void find(const World& world, int wire) noexcept;
    static constexpr int kChunk = 16;  ///< Number of nodes of one task.
    /// Compute the loads on the nodes [begin, end), at most kChunk.
    void load(const WaterField& field, bool convective, int begin, int end) noexcept;
    /// Return the number of tasks load_chunk(). The bits of a load depend on the nodes of its task.
    [[nodiscard]] int chunks() const noexcept { return (count() + kChunk - 1) / kChunk; }
    void load_chunk(const WaterField& field, bool convective, int chunk) noexcept {
        load(field, convective, chunk * kChunk, std::min((chunk + 1) * kChunk, count()));
    }
    /// Return the largest error of a velocity of the last load() [m/s]. @param points  Increased by
    /// the number of nodes.
    [[nodiscard]] double velocity_error(const WaterField& field, std::int64_t& points) const;
    /// Return the number of nodes of all wires.
    [[nodiscard]] int count() const noexcept { return static_cast<int>(lumps_.size()); }
    [[nodiscard]] BodyId body(int i) const noexcept { return lumps_[at(i)].body; }
    [[nodiscard]] const PointLoad& of(int i) const noexcept { return loads_[at(i)]; }
    [[nodiscard]] const LineTable& table() const noexcept { return table_; }

  private:
    static std::size_t at(int i) noexcept { return static_cast<std::size_t>(i); }
    /// List the nodes in the water among [begin, end), with their positions. @return their number.
    int points(int begin, int end, FieldPoint* out, int* lump) const noexcept;
    struct Wire {
        std::span<const BodyId> nodes;
        std::span<const InteractionId> elements;
        std::size_t first;  ///< Index of its first node.
    };
    void assign_coefficient_sets(const Wire& wire) noexcept;
    enum class NodeState : std::uint8_t { gone, lump, other };
    /// Element in the water.
    struct Span {
        const LineWater* of = nullptr;  ///< Null: no element, or not in the water.
        Vec3 chord{0.0, 0.0, 0.0};      ///< From its first to its last node; 0: parted [m].
        Vec3 along{0.0, 0.0, 0.0};      ///< Its direction, or 0.
        double length = 0.0;            ///< [m].
    };
    void find_spans(const World& world, const Wire& wire) noexcept;
    static void add_half(const Span& span, double side, Lump& lump) noexcept;

    LineTable table_;
    std::vector<Wire> wires_;
    // By node of all wires; an element has the index of the node before it.
    std::vector<int> coefficient_sets_;
    std::vector<Vec3> places_;
    std::vector<NodeState> nodes_;
    std::vector<Span> spans_;
    std::vector<Lump> lumps_;
    std::vector<PointLoad> loads_;
};

/// Hull in the water.
class HullWater {
  public:
    static constexpr int kChunk = 64;  ///< Number of corners or triangles of one task.

    /// Create the water loads of a hull.
    /// @param heading  Initial heading of the body [rad].
    /// @param reach  Radius of a cluster of points in single precision [m]; 0: none.
    HullWater(const WaterHull& def, const Sea& sea, double step, double heading, double reach);
    void begin(const World& world, bool convective) noexcept;
    /// Store the velocity of the hull in its radiation memory, and update its wave forces from
    /// coefficients. Several threads process hulls.
    void remember(const Sea& sea, const SeaMoment& now) noexcept;
    [[nodiscard]] int corner_chunks() const noexcept;
    [[nodiscard]] int strip_chunks() const noexcept;
    [[nodiscard]] int triangle_chunks() const noexcept;
    void press(const WaterField& field, int chunk) noexcept;
    [[nodiscard]] int cell_chunks() const noexcept;
    /// Sample the motion of the water at the hull's cells that belong to a task.
    void flow_over(const WaterField& field, int chunk) noexcept;
    /// Return the largest error of a velocity at a cell in the last step [m/s]. @param points
    /// Increased by the number of cells.
    [[nodiscard]] double velocity_error(const WaterField& field, std::int64_t& points) const {
        return flow_.velocity_error(field, pose_, points);
    }
    /// Sample the water velocity at the cells of the hull that belong to a task.
    void flow_past(const WaterField& field, int chunk) noexcept;
    /// Compute the forces on the triangles of a task, and their sum. The pressures at all corners
    /// must have been computed.
    void sum(int chunk) noexcept;
    /// Sum the parts of the tasks, and add the forces at the centre of mass.
    void finish(const WaterField& field, double air) noexcept;
    [[nodiscard]] BodyId body() const noexcept { return def_->body; }
    [[nodiscard]] bool any() const noexcept { return any_; }
    /// True if a wave has a direction for which the hull has no coefficients.
    [[nodiscard]] bool lacks_direction() const noexcept { return lost_; }
    void visit_state(StateVisitor& v);
    void check_state(StateRules& rules) const;
    void write_memory(HullMemory& out) const;

    std::array<double, 6> force{};
    std::array<double, 21> mass{}, damping{}, stiffness{};

  private:
    void add_pressure(const Sea& sea, const HullSums& all) noexcept;
    void add_linear(const Sea& sea, const SeaMoment& now) noexcept;
    void add_motion(const Sea& sea, const SeaMoment& now, double wet, double air) noexcept;
    void add_coefficients(const Sea& sea, const SeaMoment& now) noexcept;
    void add_strips(const Sea& sea) noexcept;
    static void add_matrix(const Mat3& axes, const Matrix6& m, std::array<double, 21>& to) noexcept;
    /// Add a force and a moment. @param moment  About the centre of mass.
    void add_force(const Vec3& push, const Vec3& moment) noexcept;
    void add_at_reference(const Vec6& f) noexcept;

    const WaterHull* def_;
    double volume_ = 0.0;  ///< Volume of the whole mesh [m³].
    Pose pose_{};
    Twist twist_{};
    Mat3 axes_ = Mat3::Identity();
    /// Frame of the coefficients: the body's axes. If wave forces come from coefficients, it is
    /// level and has the slow heading. The coefficients are linear in this frame, so that their
    /// mean comes from the drift table alone.
    Mat3 frame_ = Mat3::Identity();
    std::vector<HullCorner> corners_;  ///< Positions relative to the centre of mass, in world axes.
    std::vector<std::int32_t> order_;  ///< Corners in the order of the clusters.
    std::vector<HullSums> parts_;
    std::vector<Vec3> flows_;  ///< Velocities of the water at strips [m/s].
    HullFlow flow_;
    bool any_ = false, lost_ = false, convective_ = false;
    // From coefficients; matrices at the centre of mass, along the body's axes.
    Matrix6 added_ = Matrix6::Zero(), constant_ = Matrix6::Zero(), statics_ = Matrix6::Zero();
    double weight_ = 0.0;  ///< Weight of the displaced water at rest [N].
    HullMemorySums memory_;
    WaveForce waves_;
    Vec6 remembered_ = Vec6::Zero(), pushed_ = Vec6::Zero();
    Vec6 ahead_ = Vec6::Zero();  ///< ν at the reference half a step on, along frame_.
};

/// Return the matrix that maps motions at the centre of mass to motions at `point`, which is
/// relative to the centre of mass.
[[nodiscard]] Matrix6 motion_at(const Vec3& point) noexcept;
/// Return the rotation of a quaternion about z [rad].
[[nodiscard]] double heading_of(const Quat& q) noexcept;

class SeaSystem final : public System {
  public:
    /// Data of the world at the definition, from which the system was made.
    struct Start {
        double step = 0.0;
        std::vector<double> heading, weight;  ///< Heading [rad] and weight [N] of each hull's body.
    };
    SeaSystem(const SeaDef& def, double gravity, LineTable lines, Start start);

    [[nodiscard]] std::string_view name() const noexcept override { return "sea"; }
    void prestep(Prestep& now, Loads& loads) noexcept override;
    void visit_state(StateVisitor& visitor) override;
    void check_state(const World& world, StateRules& rules) const override;
    void signals(SignalTable& table) override;
    void holds(HoldTable& table) const override;
    [[nodiscard]] bool is_water() const noexcept override { return true; }
    [[nodiscard]] std::unique_ptr<System> clone() const override;
    [[nodiscard]] const SeaDef& def() const noexcept { return def_; }
    /// Return the height z of still water at a time, including the set level [m].
    [[nodiscard]] double still_water(double time) const noexcept {
        return sea_.tide(time) + in_.level;
    }
    /// Return the sums of loads by body, for readers. @throws std::bad_alloc
    [[nodiscard]] std::vector<LoadView> loads() const;
    [[nodiscard]] const std::shared_ptr<const LineSea>& line_part() const noexcept {
        return line_part_;
    }
    /// Return the inputs in the last step.
    [[nodiscard]] const SeaInputs& acting_inputs() const noexcept { return acting_; }
    [[nodiscard]] HullMemory memory(std::size_t hull) const;
    [[nodiscard]] SeaAccuracy accuracy() const;

  private:
    /// Tasks on hulls and rods, in their order.
    enum class Piece : std::uint8_t { corners, strips, cells, memory, triangles, segments };
    struct Work {
        Piece piece;
        int hull, chunk;  ///< For segments, `hull` is the index of the rod.
    };

    /// Compute the loads of the water on all objects. @return false if coefficients lack a
    /// direction.
    [[nodiscard]] bool compute(Prestep& now) noexcept;
    void load_body(const World& world, int i) noexcept;
    void do_work(const Work& work) noexcept;
    void list_work(int hull);
    void apply_loads(Loads& loads) const noexcept;

    SeaDef def_;
    Start start_;
    Sea sea_;
    SeaInputs in_, acting_;
    SeaMoment moment_;
    WaterField field_;
    LineNodes lines_;
    std::shared_ptr<const LineSea> line_part_;
    std::vector<PointLoad> bodies_;
    std::vector<HullWater> hulls_;
    std::vector<RodWater> rods_;
    std::vector<Work> points_,
        sums_;  ///< Tasks that need poses only, and tasks that need pressures.
    // Output signals.
    double elevation_ = 0.0, gust_ = 0.0, tide_ = 0.0;
    bool acted_ = false;
    /// Sum of all loads on a body, for readers.
    struct Total {
        BodyId body{};
        int freedom = 3;
        std::array<double, 6> force{};
        std::array<double, 21> mass{}, damping{}, stiffness{};
    };
    mutable std::vector<Total> totals_;
};

}  // namespace hawser::marine
