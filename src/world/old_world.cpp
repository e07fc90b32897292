// SPDX-License-Identifier: Apache-2.0
/// Old names of World, which call its facets.
#include <hawser/experimental/splits.h>
#include <hawser/inspect.h>
#include <hawser/structure.h>
#include <hawser/trace.h>
#include <hawser/world.h>

#include <string>
#include <utility>

namespace hawser {

World& OldWorld::self() noexcept { return static_cast<World&>(*this); }
const World& OldWorld::self() const noexcept { return static_cast<const World&>(*this); }

WireId OldWorld::add_wire(const WireDef& def) { return self().wires().add(def); }
WireId OldWorld::adopt_wire(const std::string& name, std::span<const InteractionId> elements,
                            const WireTrim& trim) {
    return self().wires().adopt(name, elements, trim);
}
const Removed& OldWorld::remove_wire(WireId id) { return self().wires().remove(id); }
WireId OldWorld::find_wire(std::string_view name) const noexcept {
    return self().wires().find(name);
}
WireId OldWorld::wire_of(InteractionId element) const noexcept {
    return self().wires().of(element);
}
const std::string& OldWorld::wire_name(WireId id) const { return self().wires().name(id); }
std::span<const BodyId> OldWorld::nodes(WireId id) const { return self().wires().nodes(id); }
std::span<const InteractionId> OldWorld::elements(WireId id) const {
    return self().wires().elements(id);
}
double OldWorld::length(WireId id) const { return self().wires().length(id); }
double OldWorld::tension(WireId id, double s) const { return self().wires().tension(id, s); }
std::array<Vec3, 2> OldWorld::ends(InteractionId element) const {
    return self().wires().ends(element);
}
std::array<double, 2> OldWorld::wrapped(InteractionId element) const {
    return self().wires().wrapped(element);
}
int OldWorld::wire_alert(InteractionId element) const {
    return self().wires().damped_steps(element);
}
BodyId OldWorld::insert_node(InteractionId element, double share, double mass) {
    return self().wires().insert_node(element, share, mass);
}
bool OldWorld::remove_node(BodyId node, double bend) {
    return self().wires().remove_node(node, bend);
}
void OldWorld::set_mass(BodyId node, double mass) { self().wires().set_mass(node, mass); }
void OldWorld::part(WireId id, double s) { self().wires().part(id, s); }
void OldWorld::part(InteractionId element) { self().wires().part(element); }
WireId OldWorld::cut(WireId id, double s) { return self().wires().cut(id, s); }
WireId OldWorld::cut(InteractionId element, double share) {
    return self().wires().cut(element, share);
}
Joint OldWorld::join(WireId a, int end_a, WireId b, int end_b, const JoinDef& def) {
    return self().wires().join(a, end_a, b, end_b, def);
}
Joint OldWorld::join(BodyId a, BodyId b, const Vec3& point, const JoinDef& def) {
    return self().wires().join(a, b, point, def);
}
Joint OldWorld::attach(WireId id, int end, BodyId body, const Vec3& point, const JoinDef& def) {
    return self().wires().attach(id, end, body, point, def);
}
void OldWorld::detach(WireId id, int end) { self().wires().detach(id, end); }
void OldWorld::detach(InteractionId element, int end) { self().wires().detach(element, end); }
void OldWorld::release(InteractionId hook) { self().wires().release(hook); }
InteractionId OldWorld::wind_up(WireId id, int end, BodyId drum, double radius) {
    return self().wires().spool(id, end, drum, radius);
}
std::array<InteractionId, 2> OldWorld::lay_over(InteractionId element, InteractionDef before,
                                                const InteractionDef& behind) {
    return self().wires().engage(element, std::move(before), behind);
}
InteractionId OldWorld::lift_off(InteractionId before, InteractionId behind,
                                 InteractionDef element) {
    return self().wires().disengage(before, behind, std::move(element));
}
bool OldWorld::move_along(InteractionId before, InteractionId behind, double along, double fed) {
    return self().wires().move_along(before, behind, along, fed);
}

std::vector<std::byte> OldWorld::save() const { return self().state().save(); }
void OldWorld::save(std::vector<std::byte>& out) const { self().state().save(out); }
std::vector<std::byte> OldWorld::save_motion() const { return self().state().save_motion(); }
void OldWorld::restore(std::span<const std::byte> bytes) { self().state().restore(bytes); }
void OldWorld::restore(const Structure& made_of, std::span<const std::byte> bytes) {
    self().state().restore(made_of, bytes);
}
void OldWorld::restore_variant(std::span<const std::byte> bytes) {
    self().state().restore_variant(bytes);
}
Structure OldWorld::structure() const { return self().state().structure(); }
std::uint64_t OldWorld::identity() const { return self().state().identity(); }
std::uint64_t OldWorld::state_hash() const noexcept { return self().state().hash(); }
std::uint64_t OldWorld::motion_hash() const noexcept { return self().state().motion_hash(); }
void OldWorld::copy_state(const World& other) { self().state().copy_from(other); }

std::vector<Event> OldWorld::take_events() { return self().events().take(); }
std::uint64_t OldWorld::events_since(std::uint64_t& cursor, std::vector<Event>& out) const {
    return self().events().since(cursor, out);
}
std::uint64_t OldWorld::event_cursor() const noexcept { return self().events().cursor(); }
EventExtremes OldWorld::event_extremes(EventKind kind) const noexcept {
    return self().events().extremes(kind);
}

SystemView OldWorld::inspect() const { return self().solver().matrix(); }
RowsView OldWorld::rows(InteractionId id) const { return self().solver().rows(id); }
bool OldWorld::completed(InteractionId id) const { return self().solver().completed(id); }
std::array<double, kMaxInteractionRows> OldWorld::stiffness_force(InteractionId id) const {
    return self().solver().stiffness_force(id);
}
void OldWorld::degrade_next_step(const Degradation& degradation) noexcept {
    self().solver().degrade_next_step(degradation);
}
int OldWorld::coarsening() const noexcept { return self().solver().coarsening(); }
std::size_t OldWorld::memory_bytes() const noexcept { return self().solver().memory_bytes(); }
void OldWorld::start_trace(std::size_t spans) { self().solver().start_trace(spans); }
TraceView OldWorld::trace(std::int64_t steps) const { return self().solver().trace(steps); }

void OldWorld::set_group(BodyId id, const std::string& group) {
    self().splits().set_group(id, group);
}
void OldWorld::set_groups(int parts) { self().splits().set_groups(parts); }
void OldWorld::follow_groups(int parts, int every) { self().splits().follow_groups(parts, every); }
std::vector<std::int32_t> OldWorld::groups() const { return self().splits().groups(); }
void OldWorld::set_coupling(InteractionId id, Coupling coupling) {
    self().splits().set_coupling(id, coupling);
}
Coupling OldWorld::coupling(InteractionId id) const { return self().splits().coupling(id); }
std::vector<CutView> OldWorld::cuts() const { return self().splits().cuts(); }
PartitionView OldWorld::partition(const PartitionRequest& request) const {
    return self().splits().partition(request);
}

}  // namespace hawser
