// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file old_world.h
/// Deprecated functions of World, which have moved to its facets (facet.h). Each calls the function
/// that its warning names. They will be removed in the version after 0.1. Descriptions:
/// world_wires.h, world_state.h, world_events.h, world_solver.h, experimental/splits.h.

#include <hawser/edits.h>
#include <hawser/id.h>
#include <hawser/interactions.h>
#include <hawser/math.h>
#include <hawser/stats.h>
#include <hawser/wire.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace hawser {

struct CutView;           // inspect.h
struct PartitionRequest;  // experimental/partition.h
struct PartitionView;     // experimental/partition.h
struct RowsView;          // inspect.h
struct Structure;         // structure.h
struct SystemView;        // inspect.h
struct TraceView;         // trace.h
class World;

/// Base class of World with its deprecated functions.
class OldWorld {
  public:
    // Wires.
    [[deprecated("use wires().add()")]] WireId add_wire(const WireDef& def);
    [[deprecated("use wires().adopt()")]] WireId adopt_wire(const std::string& name,
                                                            std::span<const InteractionId> elements,
                                                            const WireTrim& trim = {});
    [[deprecated("use wires().remove()")]] const Removed& remove_wire(WireId id);
    [[deprecated("use wires().find()")]] [[nodiscard]] WireId find_wire(
        std::string_view name) const noexcept;
    [[deprecated("use wires().of()")]] [[nodiscard]] WireId wire_of(
        InteractionId element) const noexcept;
    [[deprecated("use wires().name()")]] [[nodiscard]] const std::string& wire_name(
        WireId id) const;
    [[deprecated("use wires().nodes()")]] [[nodiscard]] std::span<const BodyId> nodes(
        WireId id) const;
    [[deprecated("use wires().elements()")]] [[nodiscard]] std::span<const InteractionId> elements(
        WireId id) const;
    [[deprecated("use wires().length()")]] [[nodiscard]] double length(WireId id) const;
    [[deprecated("use wires().tension()")]] [[nodiscard]] double tension(WireId id, double s) const;
    [[deprecated("use wires().ends()")]] [[nodiscard]] std::array<Vec3, 2> ends(
        InteractionId element) const;
    [[deprecated("use wires().wrapped()")]] [[nodiscard]] std::array<double, 2> wrapped(
        InteractionId element) const;
    [[deprecated("use wires().damped_steps()")]] [[nodiscard]] int wire_alert(
        InteractionId element) const;
    [[deprecated("use wires().insert_node()")]] BodyId insert_node(InteractionId element,
                                                                   double share,
                                                                   double mass = kDefault);
    [[deprecated("use wires().remove_node()")]] bool remove_node(BodyId node, double bend = 0.05);
    [[deprecated("use wires().set_mass()")]] void set_mass(BodyId node, double mass);
    [[deprecated("use wires().part()")]] void part(WireId id, double s);
    [[deprecated("use wires().part()")]] void part(InteractionId element);
    [[deprecated("use wires().cut()")]] WireId cut(WireId id, double s);
    [[deprecated("use wires().cut()")]] WireId cut(InteractionId element, double share);
    [[deprecated("use wires().join()")]] Joint join(WireId a, int end_a, WireId b, int end_b,
                                                    const JoinDef& def = {});
    [[deprecated("use wires().join()")]] Joint join(BodyId a, BodyId b, const Vec3& point,
                                                    const JoinDef& def);
    [[deprecated("use wires().attach()")]] Joint attach(WireId id, int end, BodyId body,
                                                        const Vec3& point, const JoinDef& def = {});
    [[deprecated("use wires().detach()")]] void detach(WireId id, int end);
    [[deprecated("use wires().detach()")]] void detach(InteractionId element, int end);
    [[deprecated("use wires().release()")]] void release(InteractionId hook);
    [[deprecated("use wires().spool()")]] InteractionId wind_up(WireId id, int end, BodyId drum,
                                                                double radius);
    [[deprecated("use wires().engage()")]] std::array<InteractionId, 2> lay_over(
        InteractionId element, InteractionDef before, const InteractionDef& behind);
    [[deprecated("use wires().disengage()")]] InteractionId lift_off(InteractionId before,
                                                                     InteractionId behind,
                                                                     InteractionDef element);
    [[deprecated("use wires().move_along()")]] bool move_along(InteractionId before,
                                                               InteractionId behind, double along,
                                                               double fed);
    // State.
    [[deprecated("use state().save()")]] [[nodiscard]] std::vector<std::byte> save() const;
    [[deprecated("use state().save()")]] void save(std::vector<std::byte>& out) const;
    [[deprecated("use state().save_motion()")]] [[nodiscard]] std::vector<std::byte> save_motion()
        const;
    [[deprecated("use state().restore()")]] void restore(std::span<const std::byte> bytes);
    [[deprecated("use state().restore()")]] void restore(const Structure& made_of,
                                                         std::span<const std::byte> bytes);
    [[deprecated("use state().restore_variant()")]] void restore_variant(
        std::span<const std::byte> bytes);
    [[deprecated("use state().structure()")]] [[nodiscard]] Structure structure() const;
    [[deprecated("use state().identity()")]] [[nodiscard]] std::uint64_t identity() const;
    [[deprecated("use state().hash()")]] [[nodiscard]] std::uint64_t state_hash() const noexcept;
    [[deprecated("use state().motion_hash()")]] [[nodiscard]] std::uint64_t motion_hash()
        const noexcept;
    [[deprecated("use state().copy_from()")]] void copy_state(const World& other);
    // Events.
    [[deprecated("use events().take()")]] [[nodiscard]] std::vector<Event> take_events();
    [[deprecated("use events().since()")]] std::uint64_t events_since(
        std::uint64_t& cursor, std::vector<Event>& out) const;
    [[deprecated("use events().cursor()")]] [[nodiscard]] std::uint64_t event_cursor()
        const noexcept;
    [[deprecated("use events().extremes()")]] [[nodiscard]] EventExtremes event_extremes(
        EventKind kind) const noexcept;
    // Solver.
    [[deprecated("use solver().matrix()")]] [[nodiscard]] SystemView inspect() const;
    [[deprecated("use solver().rows()")]] [[nodiscard]] RowsView rows(InteractionId id) const;
    [[deprecated("use solver().completed()")]] [[nodiscard]] bool completed(InteractionId id) const;
    [[deprecated(
        "use solver().stiffness_force()")]] [[nodiscard]] std::array<double, kMaxInteractionRows>
    stiffness_force(InteractionId id) const;
    [[deprecated("use solver().degrade_next_step()")]] void degrade_next_step(
        const Degradation& degradation) noexcept;
    [[deprecated("use solver().coarsening()")]] [[nodiscard]] int coarsening() const noexcept;
    [[deprecated("use solver().memory_bytes()")]] [[nodiscard]] std::size_t memory_bytes()
        const noexcept;
    [[deprecated("use solver().start_trace()")]] void start_trace(std::size_t spans);
    [[deprecated("use solver().trace()")]] [[nodiscard]] TraceView trace(
        std::int64_t steps = 1'000'000) const;
    // Splits.
    [[deprecated("use splits().set_group()")]] void set_group(BodyId id, const std::string& group);
    [[deprecated("use splits().set_groups()")]] void set_groups(int parts);
    [[deprecated("use splits().follow_groups()")]] void follow_groups(int parts, int every = 60);
    [[deprecated("use splits().groups()")]] [[nodiscard]] std::vector<std::int32_t> groups() const;
    [[deprecated("use splits().set_coupling()")]] void set_coupling(InteractionId id,
                                                                    Coupling coupling);
    [[deprecated("use splits().coupling()")]] [[nodiscard]] Coupling coupling(
        InteractionId id) const;
    [[deprecated("use splits().cuts()")]] [[nodiscard]] std::vector<CutView> cuts() const;
    [[deprecated("use splits().partition()")]] [[nodiscard]] PartitionView partition(
        const PartitionRequest& request) const;

  protected:
    OldWorld() = default;
    ~OldWorld() = default;
    OldWorld(OldWorld&&) noexcept = default;
    OldWorld& operator=(OldWorld&&) noexcept = default;

  private:
    [[nodiscard]] World& self() noexcept;
    [[nodiscard]] const World& self() const noexcept;
};

}  // namespace hawser
