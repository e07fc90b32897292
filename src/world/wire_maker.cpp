// SPDX-License-Identifier: Apache-2.0
#include "world/wire_maker.h"

#include "world/checks.h"

#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace hawser::world {
namespace {

constexpr int kMostElements = 100'000;

/// Where the lumps are: the path, or evenly between the ends.
void find_places(const World& w, const WireDef& def, std::vector<Vec3>& out) {
    out.assign(def.path.begin(), def.path.end());
    if (!def.path.empty()) return;
    const Vec3 a = w.world_point(def.from, def.from_point);
    const Vec3 b =
        def.to.valid() ? w.world_point(def.to, def.to_point) : Vec3(a - def.length * Vec3::UnitZ());
    for (int i = 1; i <= def.elements - (def.to.valid() ? 1 : 0); ++i)
        out.push_back(a + (b - a) * (static_cast<double>(i) / def.elements));
}

double length_of(const World& w, const WireDef& def, const std::vector<Vec3>& lumps) {
    if (!std::isnan(def.length)) return def.length;
    Vec3 last = w.world_point(def.from, def.from_point);
    double sum = 0.0;
    for (const Vec3& p : lumps) {
        sum += (p - last).norm();
        last = p;
    }
    return sum + (def.to.valid() ? (w.world_point(def.to, def.to_point) - last).norm() : 0.0);
}

/// Adds the pieces of a wire to a world.
class WireMaker {
  public:
    WireMaker(World& world, const WireDef& def, Wire& out, std::vector<Vec3>& lumps)
        : world_(world), def_(def), out_(out), lumps_(lumps) {
        find_places(world, def, lumps);
        element_ = length_of(world, def, lumps_) / def.elements;
        if (!(element_ > 0.0) || !std::isfinite(element_))
            refuse(Where("wire", def.name), "its length must be positive");
    }

    void make() {
        // What is noted must not throw, or it would not be taken away.
        const auto n = static_cast<std::size_t>(def_.elements);
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
        }
        out_.nodes.push_back(def_.from);
        for (std::size_t i = 0; i < lumps_.size(); ++i) add_lump(i);
        if (def_.to.valid()) out_.nodes.push_back(def_.to);
        for (std::size_t i = 0; i + 1 < out_.nodes.size(); ++i) add_element(i);
        for (std::size_t i = 1; def_.EI > 0.0 && i + 1 < out_.nodes.size(); ++i)
            if (out_.nodes[i - 1] != out_.nodes[i + 1]) add_bend(i);
        for (std::size_t i = 1; def_.radius > 0.0 && i + 1 < out_.nodes.size(); ++i) add_segment(i);
    }

  private:
    [[nodiscard]] std::string part(const char* what, std::size_t i) const {
        return def_.name + "/" + what + std::to_string(i);
    }
    [[nodiscard]] Vec3 point(std::size_t i) const {
        return i == 0                                          ? def_.from_point
               : def_.to.valid() && i + 1 == out_.nodes.size() ? def_.to_point
                                                               : Vec3::Zero().eval();
    }
    void add_lump(std::size_t i) {
        // A free end carries half an element.
        const bool end = !def_.to.valid() && i + 1 == lumps_.size();
        const double share = end ? 0.5 * element_ : element_;
        BodyDef body{.name = part("", i + 1), .kind = BodyKind::lump, .position = lumps_[i]};
        body.velocity = def_.velocity;
        body.mass = def_.mass_per_length * share;
        body.linear_damping = Vec3::Constant(def_.drag * share);
        out_.lumps.push_back(world_.add_body(body));
        out_.nodes.push_back(out_.lumps.back());
    }
    void add_element(std::size_t i) {
        InteractionDef d;
        d.name = part("s", i);
        d.kind = InteractionKind::Stretch;
        d.body = {out_.nodes[i], out_.nodes[i + 1]};
        d.point = {point(i), point(i + 1), Vec3::Zero(), Vec3::Zero()};
        d.set("length", element_).set("EA", def_.EA);
        if (def_.consistent_mass) d.set("mass", def_.mass_per_length * element_);
        if (!std::isnan(def_.breaking_load)) d.set("breaking_load", def_.breaking_load);
        // Fraction ζ of critical of the highest axial mode, ω = 2c/l with c = √(EA/ρ).
        if (!std::isnan(def_.axial_damping))
            d.damping_time[0] =
                def_.axial_damping * element_ * std::sqrt(def_.mass_per_length / def_.EA);
        out_.elements.push_back(world_.add_interaction(d));
    }
    void add_bend(std::size_t i) {
        InteractionDef d;
        d.name = part("b", i);
        d.kind = InteractionKind::Bend;
        d.body = {out_.nodes[i - 1], out_.nodes[i], out_.nodes[i + 1]};
        d.point = {point(i - 1), point(i), point(i + 1), Vec3::Zero()};
        d.set("EI", def_.EI).set("length", element_);
        out_.bends.push_back(world_.add_interaction(d));
    }
    /// Between lumps: what ends on a body has none there.
    void add_segment(std::size_t i) {
        const auto is_lump = [&](BodyId id) { return world_.body_def(id).kind == BodyKind::lump; };
        if (!is_lump(out_.nodes[i]) || !is_lump(out_.nodes[i + 1]) || !out_.trim.segment) return;
        ShapeDef s = *out_.trim.segment;
        s.body = out_.nodes[i];
        s.body_b = out_.nodes[i + 1];
        out_.shapes.push_back(world_.add_shape(s));
    }

    World& world_;
    const WireDef& def_;
    Wire& out_;
    const std::vector<Vec3>& lumps_;
    double element_ = 0.0;
};

}  // namespace

void check(const WireDef& def) {
    const Where where("wire", def.name);
    if (def.name.empty()) throw DefError("a wire needs a name");
    if (def.elements < 1 || def.elements > kMostElements)
        refuse(where, "elements must be 1 to 100000, not " + std::to_string(def.elements));
    if (!def.to.valid() && def.elements < 2)
        refuse(where, "a wire of one element needs a body at its last end");
    if (!(def.mass_per_length > 0.0) || !(def.mass_per_length <= 1e9))
        refuse(where, "mass_per_length = " + number(def.mass_per_length) +
                          " kg/m; its lumps need a positive mass");
    if (!(def.EA > 0.0)) refuse(where, "EA must be given, in N");
    for (const auto& [value, what] :
         {std::pair(def.EI, "EI"), std::pair(def.drag, "drag"), std::pair(def.radius, "radius")})
        if (!(value >= 0.0) || !std::isfinite(value))
            refuse(where, std::string(what) + " must be a number from 0 on");
    if (!std::isnan(def.axial_damping) && !(def.axial_damping >= 0.0 && def.axial_damping <= 1e3))
        refuse(where, "axial_damping must be 0 to 1000");
    const auto lumps = static_cast<std::size_t>(def.elements - (def.to.valid() ? 1 : 0));
    if (!def.path.empty() && def.path.size() != lumps)
        refuse(where, "path has " + std::to_string(def.path.size()) +
                          " points; give one for each "
                          "of its " +
                          std::to_string(lumps) + " lumps, or none");
    if (def.path.empty() && !def.to.valid() && std::isnan(def.length))
        refuse(where, "a wire with a free end needs a length or a path");
}

void make_wire(World& world, const WireDef& def, Wire& out, std::vector<Vec3>& lumps) {
    WireMaker(world, def, out, lumps).make();
}

}  // namespace hawser::world
