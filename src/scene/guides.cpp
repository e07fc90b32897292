// SPDX-License-Identifier: Apache-2.0
/// Guides: the element of a cable that passes one becomes two, so that inputs and outputs find them
/// by name.
#include <hawser/guide.h>

#include "scene/description.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

namespace hawser::scene {
namespace {

InteractionDef& element_def(Description& out, InteractionId id) {
    return out.interactions[static_cast<std::size_t>(id.index)];
}

Cable& find_cable_of_guide(Description& out, const Scope& scope, const std::string& name,
                           const SourceLocation& location) {
    std::vector<std::string> known;
    for (Cable& cable : out.cables) {
        if (cable.name == scope.prefix + name) return cable;
        if (cable.name.starts_with(scope.prefix))
            known.push_back(cable.name.substr(scope.prefix.size()));
    }
    report_missing(out.mistakes, OmittedPart::cable, scope.prefix + name, location,
                   "there is no cable " + in_quotes(name) + suggestion(name, known));
}

/// Return the distance of a point from an element [m].
double separation(const Description& out, const InteractionDef& d, const Vec3& p) {
    const Vec3 a = out.world_point(d.body[0], d.point[0]);
    const Vec3 along = out.world_point(d.body[1], d.point[1]) - a;
    const double t =
        std::clamp((p - a).dot(along) / std::max(along.squaredNorm(), 1e-300), 0.0, 1.0);
    return (p - a - t * along).norm();
}

/// Return the number of the element with the smallest distance to the guide, among the elements
/// without a drum or guide.
std::size_t nearest(Description& out, const Cable& cable, const GuideDef& def,
                    const SourceLocation& location) {
    const Vec3 at = out.world_point(def.body, def.point);
    std::size_t best = cable.stretch.size();
    double least = 1e300, guided = 1e300;
    for (std::size_t k = 0; k < cable.stretch.size(); ++k) {
        const InteractionDef& d = element_def(out, cable.stretch[k]);
        const double far = separation(out, d, at);
        if (kind_info(d.kind).is(kAtGuide)) guided = std::min(guided, far);
        if (kind_info(d.kind).is(kWoundUp) || far >= least) continue;
        least = far;
        best = k;
    }
    if (best == cable.stretch.size())
        throw_error(location / "cable", "all elements of the cable " + in_quotes(cable.name) +
                                            " are at drums or guides already; give it more");
    // Another one would be pulled to it from there.
    constexpr double kSamePosition = 1e-3;
    if (guided < least - kSamePosition)
        throw_error(location / "point",
                    "the cable " + in_quotes(cable.name) +
                        " passes it with an element of another guide; two guides need "
                        "a node between them: give it more elements");
    return best;
}

/// Return the section of a cable that contains an element.
CableSection& section_of(Cable& cable, std::size_t element) {
    std::size_t k = 0;
    for (; k + 1 < cable.sections.size() && element >= cable.sections[k].elements; ++k)
        element -= cable.sections[k].elements;
    return cable.sections[k];
}

/// Subtract half of the mass of the element from the node, with its fraction of drag and of weight
/// in water.
void subtract_half_mass(BodyDef& lump, double half, const SourceLocation& location) {
    if (lump.kind != BodyKind::lump || !(half > 0.0)) return;
    if (!(lump.mass > half * (1.0 + 1e-6)))
        throw_error(location / "cable",
                    "a node next to the guide has no other element; give the cable more elements");
    const double scale = (lump.mass - half) / lump.mass;
    lump.mass -= half;
    lump.linear_damping *= scale;
    lump.force *= scale;
}

/// Replace the neighbour in the bends at both ends of an element by the body of the guide.
void move_bends_to_guide(Description& out, const InteractionDef& element, const GuidePlan& plan,
                         double radius) {
    // Point at which each part touches the wheel, as marked by its frame there.
    const auto touches = [&](const InteractionDef& part, std::size_t slot) {
        return Vec3(part.point[slot] + std::abs(radius) * (part.frame[slot] * Vec3::UnitX()));
    };
    const Vec3 point[2] = {touches(plan.before, 1), touches(plan.behind, 0)};
    const BodyId body = plan.before.body[1];
    for (InteractionDef& d : out.interactions) {
        if (!kind_info(d.kind).is(kBendsWire)) continue;
        for (const std::size_t end : {0U, 1U})
            for (const std::size_t slot : {0U, 2U})
                if (d.body[1] == element.body[end] && d.body[slot] == element.body[1 - end]) {
                    d.body[slot] = body;
                    d.point[slot] = point[end];
                }
    }
}

/// Add the capsule of the part of an element between a node and the guide.
void add_part_segment(Description& out, const ShapeDef& whole, const InteractionDef& part,
                      const char* suffix, int location) {
    const auto is_lump = [&](std::size_t end) {
        return out.body(part.body[end]).kind == BodyKind::lump;
    };
    if (is_lump(0) == is_lump(1)) return;
    ShapeDef def = whole;
    def.name += suffix;
    def.body = part.body[0];
    def.body_b = part.body[1];
    def.position = part.point[is_lump(0) ? 1 : 0];
    out.add_shape(std::move(def), location);
}

GuideDef read_guide(Description& out, const Scope& scope, const Json& json,
                    const SourceLocation& location) {
    GuideDef def;
    def.name = scope.prefix + json["name"].get<std::string>();
    def.body = resolve_body(out, scope, json["on"].get<std::string>(), location / "on");
    def.point = vector_or(json, "point", def.point);
    def.axis = vector_or(json, "axis", def.axis);
    def.radius = number_or(json, "radius", def.radius);
    def.friction = number_or(json, "friction", def.friction);
    def.efficiency = number_or(json, "efficiency", def.efficiency);
    def.inertia = number_or(json, "inertia", def.inertia);
    if (const auto turns = json.find("turns"); turns != json.end()) def.turns = turns->get<int>();
    def.element_length = number_or(json, "element", def.element_length);
    if (const auto closed = json.find("closed"); closed != json.end())
        def.closed = closed->get<bool>();
    return def;
}

/// Replace an element by the parts before and behind the guide, with slide and friction.
void divide_element(Description& out, Cable& cable, std::size_t k, GuideDef& def,
                    const SourceLocation& location) {
    const InteractionDef element = element_def(out, cable.stretch[k]);
    const double length = element.get("length"), mass = std::max(0.0, element.get("mass"));
    const double density = std::isnan(mass) ? 0.0 : mass / length;
    CableSection& section = section_of(cable, k);
    def.mass_per_length = density;
    if (std::isnan(def.element_length)) def.element_length = density > 0.0 ? length : 0.0;
    if (def.element_length > 0.0 && !(density > 0.0))
        throw_error(location, "elements of the cable " + in_quotes(cable.name) +
                                  " have no mass that could run through; give the cable "
                                  "\"consistent_mass\": true, or the guide \"element\": 0");
    const double chord = (out.world_point(element.body[1], element.point[1]) -
                          out.world_point(element.body[0], element.point[0]))
                             .norm();
    InteractionDef filled = element;
    for (const auto& [key, value] : {std::pair{"tension_only", 1.0}, {"breaking_load", 1e30}})
        if (std::isnan(filled.get(key))) filled.set(key, value);
    const auto body_of = [&out](BodyId id) {
        const BodyDef& b = out.body(id);
        return RouteBody{b.position, b.orientation.normalized(), b.kind, b.mass};
    };
    const auto direction = [&](std::size_t i) -> Vec3 {
        const InteractionDef& d = element_def(out, cable.stretch[i]);
        return (out.world_point(d.body[1], d.point[1]) - out.world_point(d.body[0], d.point[0]))
            .normalized();
    };
    const DrawnWire drawn{direction(k > 0 ? k - 1 : k),
                          direction(k + 1 < cable.stretch.size() ? k + 1 : k)};
    GuidePlan plan =
        plan_guide(def, filled, filled.get("EA") * (chord / length - 1.0), body_of, &drawn);
    if (density > 0.0)
        for (const BodyId end : {element.body[0], element.body[1]})
            subtract_half_mass(out.bodies[static_cast<std::size_t>(end.index)], 0.5 * mass,
                               location);
    const int at = out.store_location(location);
    def.slide = out.add_body(plan.slide, at);
    for (InteractionDef* part : {&plan.before, &plan.behind}) part->body[2] = def.slide;
    const std::optional<ShapeDef> segment = out.remove_segment(element.body[0], element.body[1]);
    if (segment && cable.trim.to_ends)
        for (const InteractionDef* part : {&plan.before, &plan.behind})
            add_part_segment(out, *segment, *part, part == &plan.before ? "" : "/behind", at);
    move_bends_to_guide(out, element, plan, def.radius);
    element_def(out, cable.stretch[k]) = plan.before;
    const InteractionId behind = out.add_interaction(plan.behind, at);
    plan.friction.body[0] = def.slide;
    plan.friction.load[0].interaction = cable.stretch[k];
    plan.friction.load[1].interaction = behind;
    out.add_interaction(plan.friction, at);
    const auto after = static_cast<std::ptrdiff_t>(k) + 1;
    cable.stretch.insert(cable.stretch.begin() + after, behind);
    cable.nodes.insert(cable.nodes.begin() + after, def.body);
    ++section.elements;
}

}  // namespace

void expand_guides(Description& out, const Scope& scope) {
    const auto list = scope.content->find("guides");
    if (list == scope.content->end()) return;
    for (std::size_t i = 0; i < list->size(); ++i) {
        const Json& json = (*list)[i];
        if (json.is_null()) continue;  // Left out: mistakes.h.
        const SourceLocation location = scope.location / "guides" / i;
        (void)attempt(out.mistakes, [&] {
            GuideDef def = read_guide(out, scope, json, location);
            for (const GuideItem& other : out.guides)
                if (other.def.name == def.name)
                    throw_error(location / "name",
                                "the guide " + in_quotes(def.name) + " exists already");
            Cable& cable = find_cable_of_guide(out, scope, json["cable"].get<std::string>(),
                                               location / "cable");
            if (cable.links)
                throw_error(location / "cable",
                            "a cable of links cannot run over a guide; give it \"as\": \"lumps\"");
            const std::string name = cable.name;
            try {
                divide_element(out, cable, nearest(out, cable, def, location), def, location);
            } catch (const DefError& error) {
                throw_error(location, library_words(error));
            }
            out.guides.push_back({std::move(def), name, out.store_location(location)});
        });
    }
}

}  // namespace hawser::scene
