// SPDX-License-Identifier: Apache-2.0
#include "scene/cable_layout.h"

#include <algorithm>
#include <cmath>

namespace hawser::scene {
namespace {

/// Adds the bodies and interactions of one cable with a layout.
class Builder {
  public:
    Builder(Description& out, const CableLayout& layout, const Place& place)
        : out_(out), c_(layout), place_(out.keep(place)), at_(place) {
        cable_.name = c_.name;
        cable_.links = c_.links;
        cable_.length = c_.length;
        for (const LayoutSection& section : c_.sections) add_up(section);
        if (c_.touches) cable_.trim.segment = c_.contact;
        cable_.trim.to_ends = c_.to_ends;
        cable_.from_point = c_.from.local;
        cable_.to_point = c_.to.local;
        cable_.laid_from = c_.laid_from;
        cable_.laid_to = c_.laid_to;
        if (c_.drum.valid()) cable_.drum_element = c_.fed ? c_.first().element : 0.0;
    }

    void build() {
        c_.links ? build_links() : build_nodes();
        if (c_.touches) {
            c_.links ? add_link_shapes() : add_segments();
        }
        out_.add_cable(std::move(cable_), at_);
    }

  private:
    void add_up(const LayoutSection& section) {
        const CableSection& line = section.line;
        const bool first = cable_.sections.empty();
        if (!first) cable_.line_type += " + ";
        cable_.line_type += line.line_type;
        cable_.EA = std::max(cable_.EA, line.EA);
        cable_.diameter = std::max(cable_.diameter, line.diameter);
        double& least = cable_.breaking_load;
        if (line.breaking_load > 0.0)
            least = least > 0.0 ? std::min(least, line.breaking_load) : line.breaking_load;
        if (first) cable_.color = section.color;
        cable_.trim.EI = first ? line.EI : std::min(cable_.trim.EI, line.EI);
        cable_.sections.push_back(line);
    }

    [[nodiscard]] std::string part(const char* what, std::size_t i) const {
        return c_.name + "/" + what + std::to_string(i);
    }

    /// Return the velocity of node i, interpolated between the velocities of the ends.
    [[nodiscard]] Vec3 node_velocity(std::size_t i) const {
        const double s = c_.share(i);
        return (1.0 - s) * c_.from.velocity + s * c_.to.velocity;
    }

    /// Return the group of part i of `count`.
    [[nodiscard]] std::string group(std::size_t i, std::size_t count) const {
        return c_.groups[i * c_.groups.size() / count];
    }

    /// Return buoyancy as a constant force, because the world has one gravity for all bodies.
    [[nodiscard]] Vec3 buoyancy(const LayoutSection& of, double mass) const {
        return mass * (of.submerged_factor - 1.0) * out_.settings.gravity;
    }
    /// Add the mass, drag and buoyancy of a piece of a section to a body.
    void add_share(BodyDef& def, const LayoutSection& of, double length) const {
        const double mass = of.line.mass_per_length * length;
        const Vec3 drag = Vec3::Constant(of.drag * length), force = buoyancy(of, mass);
        const bool only = def.mass == 0.0;
        def.mass += mass;
        def.linear_damping = only ? drag : Vec3(def.linear_damping + drag);
        def.force = only ? force : Vec3(def.force + force);
    }

    // --- Nodes -------------------------------------------------------------------------------

    BodyId node(std::size_t i) {
        const bool first = i == 0;
        const bool last = i == c_.elements;
        const CableEnd& end = first ? c_.from : c_.to;
        if ((first || last) && end.kind == CableEnd::Kind::body) {
            return end.body;
        }
        BodyDef def;
        def.name = part("", i);
        def.position = c_.nodes[i];
        if ((first || last) && end.kind == CableEnd::Kind::fixed) {
            def.kind = BodyKind::fixed;
            return out_.add_body(std::move(def), place_);
        }
        def.kind = BodyKind::lump;
        def.group = group(i, c_.elements + 1);
        def.velocity = node_velocity(i);
        def.mass = 0.0;
        // A free end has half of an element's mass.
        const LayoutSection &before = c_.of(first ? 0 : i - 1), &after = c_.of(last ? i - 1 : i);
        if (first || last) {
            add_share(def, first ? after : before, 0.5 * (first ? after : before).element);
        } else if (i == 1 && c_.fed) {  // the feed adds its half of the first element
            add_share(def, after, 0.5 * after.element);
        } else if (&before == &after) {
            add_share(def, after, after.element);
        } else {
            add_share(def, before, 0.5 * before.element);
            add_share(def, after, 0.5 * after.element);
        }
        return out_.add_body(std::move(def), place_);
    }

    [[nodiscard]] Vec3 point(std::size_t i) const {
        return i == 0 ? c_.from.local : i == c_.elements ? c_.to.local : Vec3::Zero();
    }

    void add_stretch(std::size_t i) {
        const bool winch = i == 0 && c_.drum.valid();
        const LayoutSection& section = c_.of(i);
        const CableSection& line = section.line;
        InteractionDef def;
        def.name = part("s", i);
        def.kind = winch ? InteractionKind::WinchStretch : InteractionKind::Stretch;
        def.body = {cable_.nodes[i], cable_.nodes[i + 1], winch ? c_.drum : BodyId{}};
        def.point = {point(i), point(i + 1), Vec3::Zero(), Vec3::Zero()};
        def.set("length", section.element);
        def.set("EA", line.EA);
        def.set("tension_only", c_.tension_only ? 1.0 : 0.0);
        const bool weak = c_.weak_load > 0.0 && i == c_.weak;
        if (const double load = weak ? c_.weak_load : line.breaking_load; load > 0.0) {
            def.set("breaking_load", load);
        }
        if (winch) {
            def.set("radius", c_.drum_radius);
        } else if (c_.consistent_mass) {
            def.set("mass", line.mass_per_length * section.element);
        }
        if (!std::isnan(section.axial_damping)) {
            // Fraction ζ of critical of the highest axial mode, ω = 2c/l with c = √(EA/ρ).
            def.damping_time[0] =
                section.axial_damping * section.element * std::sqrt(line.mass_per_length / line.EA);
        }
        cable_.stretch.push_back(out_.add_interaction(std::move(def), place_));
    }

    void add_bend(std::size_t i) {
        InteractionDef def;
        def.name = part("b", i);
        def.kind = InteractionKind::Bend;
        def.body = {cable_.nodes[i - 1], cable_.nodes[i], cable_.nodes[i + 1]};
        def.point = {point(i - 1), point(i), point(i + 1), Vec3::Zero()};
        // Both halves at the node bend in series: use the mean of their flexibilities.
        const LayoutSection &before = c_.of(i - 1), &after = c_.of(i);
        const bool same = &before == &after;
        const double length = same ? after.element : 0.5 * before.element + 0.5 * after.element;
        def.set("EI", same ? after.line.EI
                           : length / (0.5 * before.element / before.line.EI +
                                       0.5 * after.element / after.line.EI));
        def.set("length", length);
        out_.add_interaction(std::move(def), place_);
    }

    void build_nodes() {
        for (std::size_t i = 0; i <= c_.elements; ++i) {
            cable_.nodes.push_back(node(i));
        }
        for (std::size_t i = 0; i < c_.elements; ++i) {
            add_stretch(i);
        }
        for (std::size_t i = 1; i < c_.elements; ++i) {
            if (!(c_.of(i - 1).line.EI > 0.0 && c_.of(i).line.EI > 0.0)) continue;
            // If both ends of a loop of two elements are on one body, there is no bend.
            if (cable_.nodes[i - 1] != cable_.nodes[i + 1]) {
                add_bend(i);
            }
        }
    }

    // --- Links -------------------------------------------------------------------------------

    BodyId add_link(std::size_t i) {
        const Vec3 along = c_.nodes[i + 1] - c_.nodes[i];
        const double length = along.norm();
        BodyDef def;
        def.name = part("", i);
        def.group = group(i, c_.elements);
        def.position = 0.5 * (c_.nodes[i] + c_.nodes[i + 1]);
        def.orientation = turn_between(Vec3::UnitX(), along);
        const Vec3 difference = node_velocity(i + 1) - node_velocity(i);
        def.velocity = 0.5 * (node_velocity(i) + node_velocity(i + 1));
        def.angular_velocity = along.cross(difference) / (length * length);
        const LayoutSection& section = c_.first();
        const double element = section.element;
        def.mass = section.line.mass_per_length * element;
        const double r2 = c_.radius * c_.radius;
        const double across = def.mass * (3.0 * r2 + element * element) / 12.0;
        def.inertia = Vec3(def.mass * r2 / 2.0, across, across).asDiagonal();
        def.half_size = {0.5 * element, c_.radius, c_.radius};
        def.linear_damping = Vec3::Constant(section.drag * element);
        def.force = buoyancy(section, def.mass);
        return out_.add_body(std::move(def), place_);
    }

    void add_joint(std::size_t i) {
        const auto half = [&](std::size_t link) {
            return 0.5 * (c_.nodes[link + 1] - c_.nodes[link]).norm();
        };
        InteractionDef def;
        def.name = part("j", i);
        def.kind = InteractionKind::Ball;
        def.body[0] = i == 0 ? c_.from.body : links_[i - 1];
        def.point[0] = i == 0 ? c_.from.local : Vec3(half(i - 1), 0.0, 0.0);
        def.body[1] = i == c_.elements ? c_.to.body : links_[i];
        def.point[1] = i == c_.elements ? c_.to.local : Vec3(-half(i), 0.0, 0.0);
        for (std::size_t r = 0; r < 3; ++r) {
            def.compliance[r] = c_.joint_compliance;
            def.damping_time[r] = c_.joint_damping_time;
        }
        cable_.stretch.push_back(out_.add_interaction(std::move(def), place_));
    }

    void build_links() {
        const bool from_free = c_.from.kind == CableEnd::Kind::free;
        const bool to_free = c_.to.kind == CableEnd::Kind::free;
        for (std::size_t i = 0; i < c_.elements; ++i) {
            links_.push_back(add_link(i));
        }
        if (!from_free) {
            cable_.nodes.push_back(c_.from.body);
        }
        cable_.nodes.insert(cable_.nodes.end(), links_.begin(), links_.end());
        if (!to_free) {
            cable_.nodes.push_back(c_.to.body);
        }
        const std::size_t end = c_.elements + (to_free ? 0 : 1);
        for (std::size_t i = from_free ? 1 : 0; i < end; ++i) {
            add_joint(i);
        }
    }

    // --- Shapes ------------------------------------------------------------------------------

    /// Add contact segments for all elements. An end that is no node gets a segment only if the
    /// cable has contact up to its ends. The centre of a fixed body always counts as a node.
    void add_segments() {
        const auto kind = [&](std::size_t i) { return out_.body(cable_.nodes[i]).kind; };
        const auto is_lump = [&](std::size_t i) { return kind(i) == BodyKind::lump; };
        const auto ends = [&](std::size_t i) {
            return is_lump(i) || c_.to_ends || (kind(i) == BodyKind::fixed && point(i).isZero(0.0));
        };
        for (std::size_t i = 0; i < c_.elements; ++i) {
            if (!ends(i) || !ends(i + 1) || !(is_lump(i) || is_lump(i + 1))) continue;
            ShapeDef def = c_.contact;
            def.name = part("c", i);
            def.body = cable_.nodes[i];
            def.body_b = cable_.nodes[i + 1];
            if (!is_lump(i) || !is_lump(i + 1)) def.position = point(is_lump(i) ? i + 1 : i);
            out_.add_shape(std::move(def), place_);
        }
    }

    /// Add a capsule along each link.
    void add_link_shapes() {
        for (std::size_t i = 0; i < links_.size(); ++i) {
            ShapeDef def = c_.contact;
            def.name = part("c", i);
            def.body = links_[i];
            def.half_length = out_.body(links_[i]).half_size.x();
            def.orientation = turn_between(Vec3::UnitZ(), Vec3::UnitX());
            out_.add_shape(std::move(def), place_);
        }
    }

    Description& out_;
    const CableLayout& c_;
    int place_;
    Place at_;
    Cable cable_;
    std::vector<BodyId> links_;
};

}  // namespace

void expand_cable(Description& out, const Scope& scope, const Scope& to_scope, const Json& cable,
                  const Document& document, const Place& place) {
    const CableLayout layout = lay_out_cable(out, scope, to_scope, cable, document, place);
    Builder(out, layout, place).build();
    read_resolution(out, layout, cable, place);
    read_water(out, layout, document, place);
}

}  // namespace hawser::scene
