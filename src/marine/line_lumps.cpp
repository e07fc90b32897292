// SPDX-License-Identifier: Apache-2.0
#include <hawser/world.h>

#include "marine/bodies.h"
#include "marine/checks.h"
#include "marine/sea_system.h"

#include <algorithm>
#include <string>

namespace hawser::marine {
namespace {

void add_line(const World& world, const WaterLine& line, const std::string& at, LineTable& out) {
    if (!world.alive(line.wire)) throw SeaError(at + "/wire", "there is no such wire");
    if (line.sections.empty()) throw SeaError(at + "/sections", "it needs one");
    const auto elements = world.wires().elements(line.wire);
    const auto nodes = world.wires().nodes(line.wire);
    std::size_t section = 0, end = 0;
    for (std::size_t i = 0; i < elements.size(); ++i) {
        while (section < line.sections.size() &&
               i >= end + static_cast<std::size_t>(line.sections[section].elements)) {
            if (section + 1 == line.sections.size()) break;
            end += static_cast<std::size_t>(line.sections[section++].elements);
        }
        const auto place = static_cast<std::size_t>(elements[i].index);
        if (out.of_element.size() <= place) out.of_element.resize(place + 1);
        LineTable::Known& known = out.of_element[place];
        if (known.generation == elements[i].generation)
            throw SeaError(at + "/wire", "this wire is in the water already");
        known = {elements[i].generation, static_cast<int>(out.sorts.size() + section)};
    }
    for (std::size_t k = 0; k < line.sections.size(); ++k) {
        const LineWater w = with_volume(line.sections[k].water);
        check_line_water(at + "/" + entry("sections", k) + "/water", w);
        if (line.sections[k].elements < 0)
            throw SeaError(at + "/" + entry("sections", k) + "/elements", "give 0 or more");
        out.sorts.push_back(w);
    }
    const bool free_end[] = {line.free_first, line.free_last};
    const BodyId ends[] = {nodes.front(), nodes.back()};
    for (int k = 0; k < 2; ++k)
        if (!free_end[k]) out.holders.push_back(ends[k]);
}

/// Number of nodes ahead of the present one whose definitions are prefetched. Definitions are far
/// apart in memory: reading one takes longer than all other work on a node.
constexpr std::size_t kPrefetchNodes = 8;

void prefetch_node(const World& world, std::span<const BodyId> nodes, std::size_t i) noexcept {
    if (i < nodes.size() && world.alive(nodes[i]))
        __builtin_prefetch(&world.body_def(nodes[i]).kind);
}

void prefetch_element(const World& world, std::span<const InteractionId> elements,
                      std::size_t i) noexcept {
    if (i >= elements.size() || !world.alive(elements[i])) return;
    const InteractionDef& def = world.interaction_def(elements[i]);
    __builtin_prefetch(&def.kind);
    __builtin_prefetch(def.params.data());
}

}  // namespace

int LineTable::coefficient_set_of(InteractionId id) const noexcept {
    const auto place = static_cast<std::size_t>(id.index);
    if (id.index < 0 || place >= of_element.size()) return -1;
    return of_element[place].generation == id.generation ? of_element[place].sort : -1;
}

bool LineTable::holds(BodyId id) const noexcept {
    return std::binary_search(holders.begin(), holders.end(), id);
}

std::array<int, 64> length_params() {
    std::array<int, 64> out{};
    out.fill(-1);
    for (const KindInfo& kind : interaction_kinds())
        for (std::size_t p = 0; p < kind.params.size(); ++p)
            if (kind.is(kWireElement) && std::string_view(kind.params[p].name) == "length")
                out[static_cast<std::size_t>(kind.kind)] = static_cast<int>(p);
    return out;
}

LineTable line_table(const World& world, const SeaDef& def) {
    LineTable out;
    out.length_param = length_params();
    for (std::size_t i = 0; i < def.lines.size(); ++i)
        add_line(world, def.lines[i], entry("lines", i), out);
    std::sort(out.holders.begin(), out.holders.end());
    return out;
}

void LineNodes::assign_coefficient_sets(const Wire& wire) noexcept {
    int* const sorts = coefficient_sets_.data() + wire.first;
    int last = -1;
    std::size_t unknown = 0;
    for (std::size_t e = 0; e < wire.elements.size(); ++e) {
        const int set_index = table_.coefficient_set_of(wire.elements[e]);
        if (set_index >= 0 && last < 0)  // elements before the first known one have its set
            for (std::size_t i = 0; i < unknown; ++i) sorts[i] = set_index;
        if (set_index >= 0) last = set_index;
        if (last < 0) ++unknown;
        sorts[e] = last;
    }
}

/// Compute the data of each element of a wire, so that both of its nodes can use them.
void LineNodes::find_spans(const World& world, const Wire& wire) noexcept {
    for (std::size_t e = 0; e < kPrefetchNodes; ++e) prefetch_element(world, wire.elements, e);
    for (std::size_t e = 0; e < wire.elements.size(); ++e) {
        prefetch_element(world, wire.elements, e + kPrefetchNodes);
        Span& span = spans_[wire.first + e];
        const InteractionId id = wire.elements[e];
        const int set_index = coefficient_sets_[wire.first + e];
        span.of = nullptr;
        if (set_index < 0 || !world.alive(id)) continue;
        span.of = &table_.sorts[static_cast<std::size_t>(set_index)];
        const InteractionDef& def = world.interaction_def(id);
        const int param = table_.length_param[static_cast<std::size_t>(def.kind)];
        const std::size_t node = wire.first + e;
        const bool is_intact = nodes_[node] != NodeState::gone &&
                               nodes_[node + 1] != NodeState::gone && world.intact(id);
        span.chord = is_intact ? Vec3(places_[node + 1] - places_[node]) : Vec3(Vec3::Zero());
        const double size = span.chord.norm();
        span.along = size > 0.0 ? Vec3(span.chord / size) : Vec3(Vec3::Zero());
        span.length = kind_info(def.kind).is(kWoundUp) || param < 0
                          ? size
                          : def.params[static_cast<std::size_t>(param)];
    }
}

/// Add the half of an element next to a node. @param side  1: the element begins at the node; −1:
/// it ends there.
void LineNodes::add_half(const Span& span, double side, Lump& lump) noexcept {
    if (span.of == nullptr) return;
    HalfElement& half = lump.half[lump.halves++];
    half.of = span.of;
    half.length = 0.5 * span.length;
    half.middle = lump.motion.position + (0.5 * side) * span.chord;
    half.along = side * span.along;
}

void LineNodes::list(const World& world) {
    wires_.clear();
    std::size_t nodes = 0;
    if (!table_.sorts.empty())
        for (const WireId wire : world.wires().ids()) {
            wires_.push_back({world.wires().nodes(wire), world.wires().elements(wire), nodes});
            nodes += wires_.back().nodes.size();
        }
    coefficient_sets_.resize(nodes);
    places_.resize(nodes, Vec3::Zero());
    nodes_.resize(nodes);
    spans_.resize(nodes);
    lumps_.resize(nodes);
    loads_.resize(nodes);
}

void LineNodes::find(const World& world, int number) noexcept {
    const Wire& wire = wires_[at(number)];
    const auto& [nodes, elements, first] = wire;
    assign_coefficient_sets(wire);
    const bool wet = !elements.empty() && coefficient_sets_[first + elements.size() - 1] >= 0;
    for (std::size_t i = 0; wet && i < kPrefetchNodes; ++i) prefetch_node(world, nodes, i);
    for (std::size_t i = 0; wet && i < nodes.size(); ++i) {
        prefetch_node(world, nodes, i + kPrefetchNodes);
        NodeState& state = nodes_[first + i];
        state = NodeState::gone;
        if (!world.alive(nodes[i])) continue;
        const bool lump = world.body_def(nodes[i]).kind == BodyKind::lump;
        state = lump ? NodeState::lump : NodeState::other;
        Vec3& place = places_[first + i];
        place = world.pose(nodes[i]).position;
        const std::size_t element = i < elements.size() ? i : i - 1;
        if (lump || !world.alive(elements[element])) continue;
        const InteractionDef& def = world.interaction_def(elements[element]);
        const std::size_t side = def.body[0] == nodes[i] ? 0 : 1;
        place = world.world_point(nodes[i], def.point[side]);
    }
    if (wet) find_spans(world, wire);
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        Lump& lump = lumps_[first + i];
        lump.halves = 0;
        const BodyId body = nodes[i];
        if (!wet || nodes_[first + i] != NodeState::lump) continue;
        if ((i == 0 || i + 1 == nodes.size()) && table_.holds(body)) continue;
        lump.body = body;
        lump.motion = {places_[first + i], world.velocity(body).linear};
        if (i > 0) add_half(spans_[first + i - 1], -1.0, lump);
        if (i < elements.size()) add_half(spans_[first + i], 1.0, lump);
        // A broken element has the direction of its neighbour.
        if (lump.halves == 2)
            for (int k = 0; k < 2; ++k)
                if (lump.half[k].along.isZero(0.0)) lump.half[k].along = lump.half[1 - k].along;
    }
}

void LineNodes::load(const WaterField& field, bool convective, int begin, int end) noexcept {
    FieldPoint where[kChunk];
    WaterPoint water[kChunk];
    int wet[kChunk];
    for (int i = begin; i < end; ++i) loads_[at(i)].any = false;
    const int count = points(begin, end, where, wet);
    if (count == 0) return;
    field.water(where, count, water);
    const Sea& sea = field.sea();
    const WaterLaw law{sea.density(), sea.gravity()};
    for (int i = 0; i < count; ++i) {
        const Lump& lump = lumps_[at(wet[i])];
        PointLoad& out = loads_[at(wet[i])];
        out = {};
        if (convective) water[i].acceleration += sea.convection(field.now(), lump.motion.position);
        for (int k = 0; k < lump.halves; ++k)
            add_half_element(lump.half[k], lump.motion, water[i], law, out);
    }
}

double LineNodes::velocity_error(const WaterField& field, std::int64_t& compared) const {
    double worst = 0.0;
    for (int begin = 0; begin < count(); begin += kChunk) {
        FieldPoint where[kChunk];
        WaterPoint water[kChunk];
        int wet[kChunk];
        const int some = points(begin, std::min(begin + kChunk, count()), where, wet);
        field.water(where, some, water);
        for (int i = 0; i < some; ++i) {
            const Vec3 exact =
                field.sea().water(field.now(), Vec3(where[i].x, where[i].y, where[i].z)).velocity;
            worst = std::max(worst, (water[i].velocity - exact).norm());
        }
        compared += some;
    }
    return worst;
}

int LineNodes::points(int begin, int end, FieldPoint* out, int* wet) const noexcept {
    int count = 0;
    for (int i = begin; i < end; ++i) {
        const Lump& lump = lumps_[at(i)];
        if (lump.halves == 0) continue;
        double top = lump.motion.position.z();
        for (int k = 0; k < lump.halves; ++k) top = std::max(top, lump.half[k].middle.z());
        for (int k = 0; k < lump.halves; ++k) top += lump.half[k].of->diameter;
        out[count] = {lump.motion.position, top};
        wet[count++] = i;
    }
    return count;
}

}  // namespace hawser::marine
