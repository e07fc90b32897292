// SPDX-License-Identifier: Apache-2.0
#include "world/wire_maker.h"

#include "world/checks.h"
#include "world/wire_capsule.h"

#include <cmath>
#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace hawser::world {
namespace {

constexpr int kMostElements = 100'000;

/// Sections of a wire; a wire without sections has a single one.
class Sections {
  public:
    explicit Sections(const WireDef& def) : list_(def.sections) {
        if (!list_.empty()) return;
        single_section_ = {.elements = def.elements,
                           .length = def.length,
                           .EA = def.EA,
                           .mass_per_length = def.mass_per_length,
                           .EI = def.EI,
                           .axial_damping = def.axial_damping,
                           .breaking_load = def.breaking_load,
                           .drag = def.drag};
        list_ = {&single_section_, 1};
    }
    Sections(const Sections&) = delete;
    Sections& operator=(const Sections&) = delete;

    [[nodiscard]] std::span<const WireSection> list() const noexcept { return list_; }
    void set_length(double length) noexcept {
        single_section_.length = length;
    }  ///< Length of the only section [m].
    [[nodiscard]] std::int64_t elements() const noexcept {
        std::int64_t sum = 0;
        for (const WireSection& s : list_) sum += s.elements;
        return sum;
    }
    /// Return the section of element i.
    [[nodiscard]] const WireSection& section_of_element(std::size_t i) const noexcept {
        for (const WireSection& s : list_) {
            const auto here = static_cast<std::size_t>(s.elements);
            if (i < here) return s;
            i -= here;
        }
        return list_.back();
    }

  private:
    WireSection single_section_{};
    std::span<const WireSection> list_;
};

double element_length_of_section(const WireSection& s) noexcept { return s.length / s.elements; }

/// Compute the positions of the nodes: the path, or by length between the ends.
void compute_node_positions(const World& w, const WireDef& def, const Sections& sections,
                            std::vector<Vec3>& out) {
    out.assign(def.path.begin(), def.path.end());
    if (!def.path.empty()) return;
    const Vec3 a = w.world_point(def.from, def.from_point);
    double whole = 0.0;
    for (const WireSection& s : sections.list()) whole += s.length;
    const Vec3 b =
        def.to.valid() ? w.world_point(def.to, def.to_point) : Vec3(a - whole * Vec3::UnitZ());
    if (def.sections.empty()) {
        for (int i = 1; i <= def.elements - (def.to.valid() ? 1 : 0); ++i)
            out.push_back(a + (b - a) * (static_cast<double>(i) / def.elements));
        return;
    }
    double before = 0.0;
    for (const WireSection& s : sections.list()) {
        for (int i = 1; i <= s.elements; ++i)
            out.push_back(a + (b - a) * ((before + i * element_length_of_section(s)) / whole));
        before += s.length;
    }
    if (def.to.valid()) out.pop_back();
}

double length_of_wire(const World& w, const WireDef& def, const std::vector<Vec3>& lumps) {
    if (!std::isnan(def.length)) return def.length;
    Vec3 last = w.world_point(def.from, def.from_point);
    double sum = 0.0;
    for (const Vec3& p : lumps) {
        sum += (p - last).norm();
        last = p;
    }
    return sum + (def.to.valid() ? (w.world_point(def.to, def.to_point) - last).norm() : 0.0);
}

/// Adds the parts of a wire to a world.
class WireMaker {
  public:
    WireMaker(World& world, const WireDef& def, Wire& out, std::vector<Vec3>& lumps)
        : world_(world), def_(def), out_(out), lumps_(lumps), sections_(def) {
        compute_node_positions(world, def, sections_, lumps);
        if (def.sections.empty()) sections_.set_length(length_of_wire(world, def, lumps_));
        for (const WireSection& s : sections_.list())
            if (!(element_length_of_section(s) > 0.0) ||
                !std::isfinite(element_length_of_section(s)))
                throw_def_error(Where("wire", def.name), "its length must be positive");
    }

    void make() {
        // Recording a part must not throw, or it could not be removed again.
        const auto n = static_cast<std::size_t>(sections_.elements());
        out_.nodes.reserve(n + 1);
        out_.lumps.reserve(n);
        for (auto* list : {&out_.elements, &out_.bends}) list->reserve(n);
        out_.shapes.reserve(n);
        if (def_.radius > 0.0) {
            ShapeDef& segment = out_.trim.segment.emplace();
            segment.kind = ShapeKind::capsule;
            segment.radius = def_.radius;
            segment.material = def_.material;
            segment.group = def_.group;
            segment.touches = def_.touches;
            out_.trim.to_ends = def_.end_capsules;
        }
        out_.nodes.push_back(def_.from);
        for (std::size_t i = 0; i < lumps_.size(); ++i) add_lump(i);
        if (def_.to.valid()) out_.nodes.push_back(def_.to);
        for (std::size_t i = 0; i + 1 < out_.nodes.size(); ++i) add_element(i);
        for (std::size_t i = 1; i + 1 < out_.nodes.size(); ++i)
            if (sections_.section_of_element(i - 1).EI > 0.0 &&
                sections_.section_of_element(i).EI > 0.0 && out_.nodes[i - 1] != out_.nodes[i + 1])
                add_bend(i);
        for (std::size_t i = out_.trim.to_ends ? 0 : 1; i + 1 < out_.nodes.size(); ++i)
            add_segment(i);
    }

  private:
    [[nodiscard]] std::string numbered_part(const char* what, std::size_t i) const {
        return def_.name + "/" + what + std::to_string(i);
    }
    [[nodiscard]] Vec3 point(std::size_t i) const {
        return i == 0                                          ? def_.from_point
               : def_.to.valid() && i + 1 == out_.nodes.size() ? def_.to_point
                                                               : Vec3::Zero().eval();
    }
    /// Add the node behind element i with half of its mass, and half of the next one unless it is a
    /// free end.
    void add_lump(std::size_t i) {
        const bool end = !def_.to.valid() && i + 1 == lumps_.size();
        const WireSection& before = sections_.section_of_element(i);
        BodyDef body{
            .name = numbered_part("", i + 1), .kind = BodyKind::lump, .position = lumps_[i]};
        body.velocity = def_.velocity;
        const auto add = [&](const WireSection& s, double share) {
            body.mass += s.mass_per_length * share;
            body.linear_damping += Vec3::Constant(s.drag * share);
        };
        body.mass = 0.0;
        if (const WireSection& after = sections_.section_of_element(i + 1);
            !end && &after != &before) {
            add(before, 0.5 * element_length_of_section(before));
            add(after, 0.5 * element_length_of_section(after));
        } else {
            add(before, (end ? 0.5 : 1.0) * element_length_of_section(before));
        }
        out_.lumps.push_back(world_.add_body(body));
        out_.nodes.push_back(out_.lumps.back());
    }
    void add_element(std::size_t i) {
        const WireSection& s = sections_.section_of_element(i);
        const double element = element_length_of_section(s);
        InteractionDef d;
        d.name = numbered_part("s", i);
        d.kind = InteractionKind::Stretch;
        d.body = {out_.nodes[i], out_.nodes[i + 1]};
        d.point = {point(i), point(i + 1), Vec3::Zero(), Vec3::Zero()};
        d.set("length", element).set("EA", s.EA);
        if (def_.consistent_mass) d.set("mass", s.mass_per_length * element);
        if (!std::isnan(s.breaking_load)) d.set("breaking_load", s.breaking_load);
        // Fraction ζ of critical damping of the highest axial mode, ω = 2c/l with c = √(EA/ρ).
        if (!std::isnan(s.axial_damping))
            d.damping_time[0] = s.axial_damping * element * std::sqrt(s.mass_per_length / s.EA);
        out_.elements.push_back(world_.add_interaction(d));
    }
    void add_bend(std::size_t i) {
        InteractionDef d;
        d.name = numbered_part("b", i);
        d.kind = InteractionKind::Bend;
        d.body = {out_.nodes[i - 1], out_.nodes[i], out_.nodes[i + 1]};
        d.point = {point(i - 1), point(i), point(i + 1), Vec3::Zero()};
        // About the node both halves bend in series: sum their flexibilities.
        const WireSection &before = sections_.section_of_element(i - 1),
                          &after = sections_.section_of_element(i);
        double length = element_length_of_section(before), EI = before.EI;
        if (&before != &after) {
            const double one = 0.5 * length, other = 0.5 * element_length_of_section(after);
            length = one + other;
            EI = length / (one / before.EI + other / after.EI);
        }
        d.set("EI", EI).set("length", length);
        out_.bends.push_back(world_.add_interaction(d));
    }
    void add_segment(std::size_t i) {
        const std::optional<ShapeDef> segment = element_capsule(
            world_, out_.trim, {out_.nodes[i], out_.nodes[i + 1]}, {point(i), point(i + 1)});
        if (segment) out_.shapes.push_back(world_.add_shape(*segment));
    }

    World& world_;
    const WireDef& def_;
    Wire& out_;
    const std::vector<Vec3>& lumps_;
    Sections sections_;
};

void check(const Where& where, const WireSection& s) {
    if (s.elements < 1 || s.elements > kMostElements)
        throw_def_error(where, "elements must be 1 to 100000, not " + std::to_string(s.elements));
    if (!(s.mass_per_length > 0.0) || !(s.mass_per_length <= 1e9))
        throw_def_error(where, "mass_per_length = " + number(s.mass_per_length) +
                                   " kg/m; its lumps need a positive mass");
    if (!(s.EA > 0.0)) throw_def_error(where, "EA must be given, in N");
    for (const auto& [value, what] : {std::pair(s.EI, "EI"), std::pair(s.drag, "drag")})
        if (!(value >= 0.0) || !std::isfinite(value))
            throw_def_error(where, std::string(what) + " must be a number from 0 on");
    if (!std::isnan(s.axial_damping) && !(s.axial_damping >= 0.0 && s.axial_damping <= 1e3))
        throw_def_error(where, "axial_damping must be 0 to 1000");
}

}  // namespace

void check(const WireDef& def) {
    const Where where("wire", def.name);
    if (def.name.empty()) throw DefError("a wire needs a name");
    const Sections sections(def);
    for (const WireSection& s : sections.list()) check(where, s);
    for (const WireSection& s : def.sections)
        if (!(s.length > 0.0) || !std::isfinite(s.length))
            throw_def_error(where, "each of its sections needs a length above 0, in m");
    if (sections.elements() > kMostElements)
        throw_def_error(where,
                        "elements must be 1 to 100000, not " + std::to_string(sections.elements()));
    if (!def.to.valid() && sections.elements() < 2)
        throw_def_error(where, "a wire of one element needs a body at its last end");
    if (!(def.radius >= 0.0) || !std::isfinite(def.radius))
        throw_def_error(where, "radius must be a number from 0 on");
    if (def.end_capsules && !(def.radius > 0.0))
        throw_def_error(where, "end_capsules: its capsules need a radius above 0");
    if (!def.sections.empty() && (!std::isnan(def.length) || !std::isnan(def.EA) ||
                                  def.mass_per_length != 0.0 || def.EI != 0.0 || def.drag != 0.0 ||
                                  !std::isnan(def.axial_damping) || !std::isnan(def.breaking_load)))
        throw_def_error(
            where,
            "length, EA, mass_per_length, EI, axial_damping, breaking_load and drag are those "
            "of its "
            "sections; leave them out");
    const auto lumps = static_cast<std::size_t>(sections.elements() - (def.to.valid() ? 1 : 0));
    if (!def.path.empty() && def.path.size() != lumps)
        throw_def_error(where, "path has " + std::to_string(def.path.size()) +
                                   " points; give one for each "
                                   "of its " +
                                   std::to_string(lumps) + " lumps, or none");
    if (def.path.empty() && !def.to.valid() && sections.list().size() == 1 &&
        std::isnan(sections.list()[0].length))
        throw_def_error(where, "a wire with a free end needs a length or a path");
}

void make_wire(World& world, const WireDef& def, Wire& out, std::vector<Vec3>& lumps) {
    WireMaker(world, def, out, lumps).make();
}

}  // namespace hawser::world
