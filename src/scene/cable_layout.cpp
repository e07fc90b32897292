// SPDX-License-Identifier: Apache-2.0
#include "scene/cable_layout.h"

#include "scene/cable_shape.h"
#include "scene/line_types.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace hawser::scene {
namespace {

/// Largest relative difference between the distance of two nodes and the length of a rigid link. It
/// allows a small initial zig-zag, but no other length.
constexpr double kLinkMismatch = 0.01;

CableEnd read_end(Description& out, const Scope& scope, const Json& json, bool links,
                  const SourceLocation& location) {
    CableEnd end;
    if (json.contains("at")) {
        end.kind = CableEnd::Kind::fixed;
        end.world = scope.frame.point(vector_of(json["at"]));
        if (links) {
            end.body = out.world_body();
            end.local = end.world;
        }
        return end;
    }
    if (json.contains("free")) {
        end.kind = CableEnd::Kind::free;
        end.world = scope.frame.point(vector_of(json["free"]));
        end.velocity = scope.frame.velocity_at(end.world);
        return end;
    }
    if (!json.contains("body")) {
        throw_error(location, "a cable end needs \"body\", \"at\" or \"free\"");
    }
    end.body = resolve_body(out, scope, json["body"].get<std::string>(), location / "body");
    end.local = vector_or(json, "point", Vec3::Zero());
    const BodyDef& body = out.body(end.body);
    if (body.kind == BodyKind::scalar) {
        throw_error(location / "body", "the scalar body " + in_quotes(body.name) +
                                           " has no position; name it as the drum of a \"winch\"");
    }
    if (body.kind == BodyKind::lump && !end.local.isZero(0.0)) {
        throw_error(location / "point", "the lump " + in_quotes(body.name) + " is a point");
    }
    end.world = out.world_point(end.body, end.local);
    end.velocity = out.frame_of(end.body).velocity_at(end.world);
    return end;
}

/// Read the ends of a cable. With a winch the cable starts at the fairlead; "from" may then name
/// the drum.
void read_ends(CableLayout& c, Description& out, const Scope& scope, const Scope& to_scope,
               const Json& cable, const SourceLocation& location) {
    const Json* from = cable.contains("from") ? &cable["from"] : nullptr;
    SourceLocation from_location = location / "from";
    if (const auto winch = cable.find("winch"); winch != cable.end()) {
        const SourceLocation at = location / "winch";
        if (c.links) {
            throw_error(at, "a cable of links cannot be paid out; use \"as\": \"lumps\"");
        }
        const std::string drum = (*winch)["drum"].get<std::string>();
        c.drum = resolve_body(out, scope, drum, at / "drum");
        if (out.body(c.drum).kind != BodyKind::scalar) {
            throw_error(at / "drum", "the body " + in_quotes(drum) + " is not of kind scalar");
        }
        c.drum_radius = (*winch)["radius"].get<double>();
        c.fed = out.version >= 2;
        if (winch->contains("fairlead")) {
            if (from != nullptr && from->value("body", "") != drum) {
                throw_error(at / "fairlead", "the cable starts at \"from\" already; leave one out");
            }
            from = &(*winch)["fairlead"];
            from_location = at / "fairlead";
        }
    }
    if (from == nullptr) {
        throw_error(location, "a cable needs the key \"from\" (a cable end)");
    }
    c.from = read_end(out, scope, *from, c.links, from_location);
    c.to = read_end(out, to_scope, cable["to"], c.links, location / "to");
}

/// Return the index of the element at a material coordinate.
std::size_t element_at(const CableLayout& c, double at) {
    std::size_t before = 0;
    for (const LayoutSection& section : c.sections) {
        if (at < section.line.length || &section == &c.sections.back())
            return before + std::min(static_cast<std::size_t>(at / section.element),
                                     section.line.elements - 1);
        before += section.line.elements;
        at -= section.line.length;
    }
    return before;
}

/// Read the key `weak` of a cable. The lengths of the elements must have been computed.
void read_weak(CableLayout& c, const Json& cable, const SourceLocation& location) {
    const auto weak = cable.find("weak");
    if (weak == cable.end()) return;
    if (c.links) throw_error(location / "weak", "a cable of links does not part");
    const double at = (*weak)["at"].get<double>();
    if (at > c.length)
        throw_error(location / "weak" / "at",
                    fmt::format("the cable ends at {:.6g} m, before {:.6g} m", c.length, at));
    c.weak = element_at(c, at);
    c.weak_load = (*weak)["breaking_load"].get<double>();
}

void read_elements(CableLayout& c, const Description& out, const Json& cable,
                   const SourceLocation& location) {
    const Json* points = listed_points(cable);
    const bool counted = cable.contains("elements");
    const bool sections = cable.contains("sections");
    if (!counted && !sections && points == nullptr) {
        throw_error(location, "a cable needs the key \"elements\" (their number)");
    }
    if (!sections) c.elements = counted ? cable["elements"].get<std::size_t>() : points->size() + 1;
    if (points != nullptr && points->size() + 1 != c.elements) {
        throw_error(location / "shape",
                    fmt::format("expected {} points, one fewer than the elements, "
                                "found {}",
                                c.elements - 1, points->size()));
    }
    if (!sections) c.sections.front().line.elements = c.elements;
    const auto most = static_cast<std::size_t>(out.settings.max_bodies);
    if ((out.bodies.size() + c.elements) * out.copies > most) {
        throw_error(
            location / "elements",
            fmt::format("the scene would have more than {} bodies (settings.max_bodies), its {} "
                        "copies included",
                        most, out.copies));
    }
}

void check_lengths(CableLayout& c, const SourceLocation& location) {
    // The smallest length that a stretch accepts.
    constexpr double kMinElementLength = 1e-9;
    measure_elements(c);
    for (const LayoutSection& section : c.sections)
        if (!(section.element >= kMinElementLength)) {
            throw_error(location,
                        fmt::format("its elements would be {} m long; the ends coincide or "
                                    "\"elements\" is too large",
                                    section.element));
        }
    for (std::size_t i = 0; i < c.elements; ++i) {
        const double distance = (c.nodes[i + 1] - c.nodes[i]).norm();
        if (!(distance > kMinElementLength)) {
            throw_error(location, fmt::format("the nodes {} and {} coincide", i, i + 1));
        }
        const double element = c.of(i).element;
        if (c.links && std::abs(distance - element) > kLinkMismatch * element) {
            throw_error(location,
                        fmt::format("the nodes {} and {} lie {:.6g} m apart, but a rigid link "
                                    "is {:.6g} m long; change \"length\" or the shape",
                                    i, i + 1, distance, element));
        }
    }
}

void read_groups(CableLayout& c, const Json& cable) {
    const auto groups = cable.find("groups");
    if (groups == cable.end()) {
        return;
    }
    c.groups.clear();
    for (const Json& group : *groups) {
        c.groups.push_back(group_of(group));
    }
}

void read_contact(CableLayout& c, Description& out, const Json& cable,
                  const SourceLocation& location) {
    const auto contact = cable.find("contact");
    if (contact == cable.end()) {
        return;
    }
    const SourceLocation at = location / "contact";
    c.touches = true;
    c.contact.kind = ShapeKind::capsule;
    c.contact.radius = number_or(*contact, "radius", c.radius);
    if (!(c.contact.radius > 0.0)) {
        throw_error(at, "a cable that touches needs \"radius\", or \"diameter\" in its line type");
    }
    c.to_ends = contact->value("to_ends", false);
    if (c.to_ends && c.links)
        throw_error(at / "to_ends", "links have their capsules on them; leave it out");
    read_surface(c.contact, out, *contact, at);
}

}  // namespace

CableLayout lay_out_cable(Description& out, const Scope& scope, const Scope& to_scope,
                          const Json& cable, const Document& document,
                          const SourceLocation& location) {
    CableLayout c;
    c.name = scope.prefix + cable["name"].get<std::string>();
    if (out.has_cable(c.name)) {
        throw_error(location / "name", "the cable " + in_quotes(c.name) + " exists already");
    }
    c.links = text_or(cable, "as", "lumps") == "links";
    c.tension_only = cable.value("tension_only", true);
    c.consistent_mass = cable.value("consistent_mass", false);
    if (c.links && c.consistent_mass)
        throw_error(location / "consistent_mass",
                    "links are rigid bodies and already have consistent mass");
    c.joint_compliance = number_or(cable, "compliance", out.default_compliance);
    c.joint_damping_time = number_or(cable, "damping_time", out.default_damping_time);
    read_line_types(c, cable, document, location);
    read_contact(c, out, cable, location);
    read_groups(c, cable);
    read_ends(c, out, scope, to_scope, cable, location);
    read_elements(c, out, cable, location);
    if (c.fed) {  // added and removed nodes need elements with mass
        c.consistent_mass = true;
        if (c.elements == 1 && c.to.kind == CableEnd::Kind::free)
            throw_error(location / "elements",
                        "with \"winch\" and a free end a cable needs at least two "
                        "elements");
    }
    place_nodes(c, out, scope, cable, still_sea(document), location);
    check_lengths(c, location);
    check_links(c, cable, location);
    read_weak(c, cable, location);
    return c;
}

}  // namespace hawser::scene
