// SPDX-License-Identifier: Apache-2.0
#include "scene/cable_layout.h"

#include <algorithm>
#include <cmath>

namespace hawser::scene {
namespace {

/// Adds the bodies and interactions of one cable with a layout.
class Builder {
  public:
    Builder(Description& out, const CableLayout& layout, const SourceLocation& location)
        : out_(out), layout_(layout), location_(out.store_location(location)), at_(location) {
        cable_.name = layout_.name;
        cable_.links = layout_.links;
        cable_.length = layout_.length;
        for (const LayoutSection& section : layout_.sections) add_up(section);
        if (layout_.touches) cable_.trim.segment = layout_.contact;
        cable_.trim.to_ends = layout_.to_ends;
        cable_.from_point = layout_.from.local;
        cable_.to_point = layout_.to.local;
        cable_.laid_from = layout_.laid_from;
        cable_.laid_to = layout_.laid_to;
        if (layout_.drum.valid()) cable_.drum_element = layout_.fed ? layout_.first().element : 0.0;
    }

    void build() {
        layout_.links ? build_links() : build_nodes();
        if (layout_.touches) {
            layout_.links ? add_link_shapes() : add_segments();
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
        return layout_.name + "/" + what + std::to_string(i);
    }

    /// Return the velocity of node i, interpolated between the velocities of the ends.
    [[nodiscard]] Vec3 node_velocity(std::size_t i) const {
        const double s = layout_.length_fraction(i);
        return (1.0 - s) * layout_.from.velocity + s * layout_.to.velocity;
    }

    /// Return the partition group of node or link i of `count`.
    [[nodiscard]] std::string group(std::size_t i, std::size_t count) const {
        return layout_.groups[i * layout_.groups.size() / count];
    }

    /// Return buoyancy as a constant force, because the world has one gravity for all bodies.
    [[nodiscard]] Vec3 buoyancy(const LayoutSection& of, double mass) const {
        return mass * (of.submerged_factor - 1.0) * out_.settings.gravity;
    }
    /// Add the mass, drag and buoyancy of a piece of a section to a body.
    void add_mass_of_length(BodyDef& def, const LayoutSection& of, double length) const {
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
        const bool last = i == layout_.elements;
        const CableEnd& end = first ? layout_.from : layout_.to;
        if ((first || last) && end.kind == CableEnd::Kind::body) {
            return end.body;
        }
        BodyDef def;
        def.name = part("", i);
        def.position = layout_.nodes[i];
        if ((first || last) && end.kind == CableEnd::Kind::fixed) {
            def.kind = BodyKind::fixed;
            return out_.add_body(std::move(def), location_);
        }
        def.kind = BodyKind::lump;
        def.group = group(i, layout_.elements + 1);
        def.velocity = node_velocity(i);
        def.mass = 0.0;
        // A free end has half of an element's mass.
        const LayoutSection &before = layout_.of(first ? 0 : i - 1),
                            &after = layout_.of(last ? i - 1 : i);
        if (first || last) {
            add_mass_of_length(def, first ? after : before, 0.5 * (first ? after : before).element);
        } else if (i == 1 && layout_.fed) {  // the feed adds its half of the first element
            add_mass_of_length(def, after, 0.5 * after.element);
        } else if (&before == &after) {
            add_mass_of_length(def, after, after.element);
        } else {
            add_mass_of_length(def, before, 0.5 * before.element);
            add_mass_of_length(def, after, 0.5 * after.element);
        }
        return out_.add_body(std::move(def), location_);
    }

    [[nodiscard]] Vec3 point(std::size_t i) const {
        return i == 0                  ? layout_.from.local
               : i == layout_.elements ? layout_.to.local
                                       : Vec3::Zero();
    }

    void add_stretch(std::size_t i) {
        const bool winch = i == 0 && layout_.drum.valid();
        const LayoutSection& section = layout_.of(i);
        const CableSection& line = section.line;
        InteractionDef def;
        def.name = part("s", i);
        def.kind = winch ? InteractionKind::WinchStretch : InteractionKind::Stretch;
        def.body = {cable_.nodes[i], cable_.nodes[i + 1], winch ? layout_.drum : BodyId{}};
        def.point = {point(i), point(i + 1), Vec3::Zero(), Vec3::Zero()};
        def.set("length", section.element);
        def.set("EA", line.EA);
        def.set("tension_only", layout_.tension_only ? 1.0 : 0.0);
        const bool weak = layout_.weak_load > 0.0 && i == layout_.weak;
        if (const double load = weak ? layout_.weak_load : line.breaking_load; load > 0.0) {
            def.set("breaking_load", load);
        }
        if (winch) {
            def.set("radius", layout_.drum_radius);
        } else if (layout_.consistent_mass) {
            def.set("mass", line.mass_per_length * section.element);
        }
        if (!std::isnan(section.axial_damping)) {
            // Fraction ζ of critical of the highest axial mode, ω = 2c/l with c = √(EA/ρ).
            def.damping_time[0] =
                section.axial_damping * section.element * std::sqrt(line.mass_per_length / line.EA);
        }
        cable_.stretch.push_back(out_.add_interaction(std::move(def), location_));
    }

    void add_bend(std::size_t i) {
        InteractionDef def;
        def.name = part("b", i);
        def.kind = InteractionKind::Bend;
        def.body = {cable_.nodes[i - 1], cable_.nodes[i], cable_.nodes[i + 1]};
        def.point = {point(i - 1), point(i), point(i + 1), Vec3::Zero()};
        // Both halves at the node bend in series: use the mean of their flexibilities.
        const LayoutSection &before = layout_.of(i - 1), &after = layout_.of(i);
        const bool same = &before == &after;
        const double length = same ? after.element : 0.5 * before.element + 0.5 * after.element;
        def.set("EI", same ? after.line.EI
                           : length / (0.5 * before.element / before.line.EI +
                                       0.5 * after.element / after.line.EI));
        def.set("length", length);
        out_.add_interaction(std::move(def), location_);
    }

    void build_nodes() {
        for (std::size_t i = 0; i <= layout_.elements; ++i) {
            cable_.nodes.push_back(node(i));
        }
        for (std::size_t i = 0; i < layout_.elements; ++i) {
            add_stretch(i);
        }
        for (std::size_t i = 1; i < layout_.elements; ++i) {
            if (!(layout_.of(i - 1).line.EI > 0.0 && layout_.of(i).line.EI > 0.0)) continue;
            // If both ends of a loop of two elements are on one body, there is no bend.
            if (cable_.nodes[i - 1] != cable_.nodes[i + 1]) {
                add_bend(i);
            }
        }
    }

    // --- Links -------------------------------------------------------------------------------

    BodyId add_link(std::size_t i) {
        const Vec3 along = layout_.nodes[i + 1] - layout_.nodes[i];
        const double length = along.norm();
        BodyDef def;
        def.name = part("", i);
        def.group = group(i, layout_.elements);
        def.position = 0.5 * (layout_.nodes[i] + layout_.nodes[i + 1]);
        def.orientation = turn_between(Vec3::UnitX(), along);
        const Vec3 difference = node_velocity(i + 1) - node_velocity(i);
        def.velocity = 0.5 * (node_velocity(i) + node_velocity(i + 1));
        def.angular_velocity = along.cross(difference) / (length * length);
        const LayoutSection& section = layout_.first();
        const double element = section.element;
        def.mass = section.line.mass_per_length * element;
        const double r2 = layout_.radius * layout_.radius;
        const double across = def.mass * (3.0 * r2 + element * element) / 12.0;
        def.inertia = Vec3(def.mass * r2 / 2.0, across, across).asDiagonal();
        def.half_size = {0.5 * element, layout_.radius, layout_.radius};
        def.linear_damping = Vec3::Constant(section.drag * element);
        def.force = buoyancy(section, def.mass);
        return out_.add_body(std::move(def), location_);
    }

    void add_joint(std::size_t i) {
        const auto half = [&](std::size_t link) {
            return 0.5 * (layout_.nodes[link + 1] - layout_.nodes[link]).norm();
        };
        InteractionDef def;
        def.name = part("j", i);
        def.kind = InteractionKind::Ball;
        def.body[0] = i == 0 ? layout_.from.body : links_[i - 1];
        def.point[0] = i == 0 ? layout_.from.local : Vec3(half(i - 1), 0.0, 0.0);
        def.body[1] = i == layout_.elements ? layout_.to.body : links_[i];
        def.point[1] = i == layout_.elements ? layout_.to.local : Vec3(-half(i), 0.0, 0.0);
        for (std::size_t r = 0; r < 3; ++r) {
            def.compliance[r] = layout_.joint_compliance;
            def.damping_time[r] = layout_.joint_damping_time;
        }
        cable_.stretch.push_back(out_.add_interaction(std::move(def), location_));
    }

    void build_links() {
        const bool from_free = layout_.from.kind == CableEnd::Kind::free;
        const bool to_free = layout_.to.kind == CableEnd::Kind::free;
        for (std::size_t i = 0; i < layout_.elements; ++i) {
            links_.push_back(add_link(i));
        }
        if (!from_free) {
            cable_.nodes.push_back(layout_.from.body);
        }
        cable_.nodes.insert(cable_.nodes.end(), links_.begin(), links_.end());
        if (!to_free) {
            cable_.nodes.push_back(layout_.to.body);
        }
        const std::size_t end = layout_.elements + (to_free ? 0 : 1);
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
            return is_lump(i) || layout_.to_ends ||
                   (kind(i) == BodyKind::fixed && point(i).isZero(0.0));
        };
        for (std::size_t i = 0; i < layout_.elements; ++i) {
            if (!ends(i) || !ends(i + 1) || !(is_lump(i) || is_lump(i + 1))) continue;
            ShapeDef def = layout_.contact;
            def.name = part("c", i);
            def.body = cable_.nodes[i];
            def.body_b = cable_.nodes[i + 1];
            if (!is_lump(i) || !is_lump(i + 1)) def.position = point(is_lump(i) ? i + 1 : i);
            out_.add_shape(std::move(def), location_);
        }
    }

    /// Add a capsule along each link.
    void add_link_shapes() {
        for (std::size_t i = 0; i < links_.size(); ++i) {
            ShapeDef def = layout_.contact;
            def.name = part("c", i);
            def.body = links_[i];
            def.half_length = out_.body(links_[i]).half_size.x();
            def.orientation = turn_between(Vec3::UnitZ(), Vec3::UnitX());
            out_.add_shape(std::move(def), location_);
        }
    }

    Description& out_;
    const CableLayout& layout_;
    int location_;
    SourceLocation at_;
    Cable cable_;
    std::vector<BodyId> links_;
};

}  // namespace

void expand_cable(Description& out, const Scope& scope, const Scope& to_scope, const Json& cable,
                  const Document& document, const SourceLocation& location) {
    const CableLayout layout = lay_out_cable(out, scope, to_scope, cable, document, location);
    Builder(out, layout, location).build();
    read_resolution(out, layout, cable, location);
    read_water(out, layout, document, location);
}

}  // namespace hawser::scene
