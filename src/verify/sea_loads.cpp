// SPDX-License-Identifier: Apache-2.0
#include "verify/sea_loads.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace hawser::verify {

namespace {

std::size_t numbered(std::int32_t i) { return static_cast<std::size_t>(i); }

Mat3 outer(const Vec3& a) { return a * a.transpose(); }

}  // namespace

SeaVerifier::SeaVerifier(const World& world) : def_(find_sea(world)) {
    if (def_ == nullptr) return;
    gravity_ = world.settings().gravity.norm();
    sea_ = std::make_unique<const Sea>(*def_, gravity_);
    for (const WaveComponent& w : sea_->components())
        waves_.push_back({w, std::cos(w.direction), std::sin(w.direction),
                          1.0 - std::exp(-2.0 * w.wave_number * def_->depth)});
    std::size_t sorts = 0;
    for (const WaterLine& line : def_->lines) sorts += line.sections.size();
    volumes_.reserve(sorts);  // pointers into it stay
    for (const WaterLine& line : def_->lines) {
        if (!world.alive(line.wire)) continue;
        const auto elements = world.wires().elements(line.wire);
        const auto nodes = world.wires().nodes(line.wire);
        std::size_t e = 0;
        for (std::size_t k = 0; k < line.sections.size(); ++k) {
            volumes_.push_back(line.sections[k].water);
            LineWater& w = volumes_.back();
            if (std::isnan(w.volume)) w.volume = std::numbers::pi / 4 * w.diameter * w.diameter;
            const bool last = k + 1 == line.sections.size();
            for (int n = 0; e < elements.size() && (last || n < line.sections[k].elements); ++n)
                line_water_.emplace_back(elements[e++], &w);
        }
        if (!line.free_first) ends_.push_back(nodes.front());
        if (!line.free_last) ends_.push_back(nodes.back());
    }
    std::sort(line_water_.begin(), line_water_.end(),
              [](const auto& a, const auto& b) { return a.first < b.first; });
}

void SeaVerifier::before_step(const World& world) {
    if (def_ == nullptr) return;
    time_ = world.time();
    intact_.assign(numbered(world.interaction_count()), false);
    for (const WireId wire : world.wires().ids())
        for (const InteractionId id : world.wires().elements(wire))
            intact_[numbered(id.index)] = world.alive(id) && world.intact(id);
    inputs_ = {.waves = world.system_signal("sea.waves"),
               .current = world.system_signal("sea.current"),
               .wind = world.system_signal("sea.wind"),
               .wind_direction = world.system_signal("sea.wind_direction"),
               .level = world.system_signal("sea.level")};
    step_ = world.settings().step;
    history_.resize(def_->hulls.size());
    for (std::size_t i = cells_.size(); i < def_->hulls.size(); ++i) {
        const HullMesh& mesh = def_->hulls[i].mesh;
        cells_.push_back(mesh.triangles.empty() ? std::vector<HullCell>() : hull_cells(mesh));
    }
    for (std::size_t i = 0; i < history_.size(); ++i)
        if (def_->hulls[i].coefficients) start_history(world, i);
}

double SeaVerifier::limit() const noexcept {
    constexpr double kDoubleTolerance = 1e-9, kSingleTolerance = 1e-5;
    constexpr std::size_t kFewComponents = 16;  // that are summed in double precision
    return waves_.size() > kFewComponents ? kSingleTolerance : kDoubleTolerance;
}

double SeaVerifier::surface(double x, double y) const {
    double z = level_;
    for (const auto& [w, east, north, all] : waves_)
        z += inputs_.waves * w.amplitude *
             std::cos(w.wave_number * (x * east + y * north) - w.frequency * time_ + w.phase);
    return z;
}

SeaVerifier::Water SeaVerifier::water(const Vec3& x) const {
    constexpr double kMaxExponent = 45.0;  // e^−45 is below the last bit of a sum
    Water out;
    out.surface = level_;
    double cosine[kMaxWaveComponents], sine[kMaxWaveComponents];
    for (std::size_t i = 0; i < waves_.size(); ++i) {
        const auto& [w, east, north, all] = waves_[i];
        const double theta =
            w.wave_number * (x.x() * east + x.y() * north) - w.frequency * time_ + w.phase;
        cosine[i] = std::cos(theta);
        sine[i] = std::sin(theta);
        out.surface += inputs_.waves * w.amplitude * cosine[i];
    }
    const double d = def_->depth, z = std::clamp(x.z(), -d, out.surface);
    const double down = d * (z + d) / (d + out.surface);  // above the bottom, stretched
    double dynamic = 0.0;
    for (std::size_t i = 0; i < waves_.size(); ++i) {
        const auto& [w, east, north, all] = waves_[i];
        const double k = w.wave_number, a = inputs_.waves * w.amplitude * w.frequency;
        if (k * (d - down) > kMaxExponent) continue;
        // cosh and sinh of k × height over sinh kd, where e^kd overflows too
        const double top = std::exp(k * (down - d));
        const double low = k * (down + d) > kMaxExponent ? 0.0 : std::exp(-k * (down + d));
        const double c = (top + low) / all * a, s = (top - low) / all * a;
        const double level = c * cosine[i], turned = c * sine[i];
        out.flow += Vec3(level * east, level * north, s * sine[i]);
        out.rate += w.frequency * Vec3(turned * east, turned * north, -s * cosine[i]);
        dynamic += def_->density * w.frequency / k * level;
    }
    const double depth = std::max(level_ - x.z(), 0.0);
    const auto& c = def_->current;
    const auto flow = [&](std::size_t i) {
        return Vec3(inputs_.current * c[i].speed * std::cos(c[i].direction),
                    inputs_.current * c[i].speed * std::sin(c[i].direction), 0.0);
    };
    for (std::size_t i = 0; i < c.size(); ++i) {
        const bool first = i == 0 && depth <= c[0].depth;
        const bool last = i + 1 == c.size() && depth >= c[i].depth;
        if (first || last) {
            out.flow += flow(i);
            break;
        }
        if (i + 1 < c.size() && depth > c[i].depth && depth < c[i + 1].depth) {
            const double fraction = (depth - c[i].depth) / (c[i + 1].depth - c[i].depth);
            out.flow += flow(i) + fraction * (flow(i + 1) - flow(i));
            break;
        }
    }
    if (x.z() < out.surface) out.pressure = def_->density * gravity_ * (level_ - x.z()) + dynamic;
    return out;
}

Vec3 SeaVerifier::wind(double z) const { return sea_->wind(air_, z); }

const LineWater* SeaVerifier::water_of_element(const World& world, WireId wire,
                                               std::size_t element) const {
    const auto elements = world.wires().elements(wire);
    const auto own = [&](std::size_t i) -> const LineWater* {
        const auto at =
            std::lower_bound(line_water_.begin(), line_water_.end(), elements[i],
                             [](const auto& a, const InteractionId& id) { return a.first < id; });
        return at != line_water_.end() && at->first == elements[i] ? at->second : nullptr;
    };
    for (std::size_t i = element + 1; i-- > 0;)
        if (const LineWater* w = own(i); w != nullptr) return w;
    for (std::size_t i = element; i < elements.size(); ++i)
        if (const LineWater* w = own(i); w != nullptr) return w;
    return nullptr;
}

void SeaVerifier::add_half(const World& world, WireId wire, std::size_t element, bool last,
                           const Water& at, const std::vector<Pose>& pose,
                           const std::vector<Twist>& before) {
    const auto nodes = world.wires().nodes(wire);
    const InteractionId id = world.wires().elements(wire)[element];
    const LineWater* w = world.alive(id) ? water_of_element(world, wire, element) : nullptr;
    if (w == nullptr) return;
    const BodyId own = nodes[element + (last ? 1 : 0)], other = nodes[element + (last ? 0 : 1)];
    const auto place = [&](BodyId b) -> Vec3 {
        const Pose& p = pose[numbered(b.index)];
        if (world.body_def(b).kind == BodyKind::lump) return p.position;
        const InteractionDef& d = world.interaction_def(id);
        return p.position + p.orientation * d.point[d.body[0] == b ? 0 : 1];
    };
    const Vec3 x = place(own), v = before[numbered(own.index)].linear;
    const Vec3 line =
        intact_[numbered(id.index)] && world.alive(other) ? Vec3(place(other) - x) : Vec3(0, 0, 0);
    const bool wound = kind_info(world.interaction_def(id).kind).is(kWoundUp);
    const double length = 0.5 * (wound ? line.norm() : world.interaction_def(id).get("length"));
    const double reach = 0.5 * std::abs(line.z()) + w->diameter;
    const double bottom = x.z() + std::min(0.0, 0.5 * line.z()) - 0.5 * w->diameter;
    const double fraction = (at.surface - bottom) / reach, error = surface_error_ / reach;
    const double rise = def_->density * w->volume * length * gravity_ / reach;
    if (std::abs(fraction) <= error || std::abs(fraction - 1.0) <= error)
        load_[numbered(own.index)].jump += rise;
    const double wet = std::clamp(fraction, 0.0, 1.0);
    if (wet <= 0.0 || length <= 0.0) return;
    Vec3 t = line.normalized();
    // A broken element hangs like the node's other element.
    const std::size_t next = last ? element + 1 : element - 1;  // −1: beyond the end, too
    if (line.isZero(0.0) && next < world.wires().elements(wire).size() &&
        water_of_element(world, wire, next) != nullptr &&
        intact_[numbered(world.wires().elements(wire)[next].index)])
        t = (place(nodes[last ? next + 1 : next]) - x).normalized();
    const Mat3 tt = outer(t), across = Mat3::Identity() - tt;
    const Vec3 r = at.flow - v, rn = across * r, rt = tt * r;
    const double rho = def_->density, d = w->diameter;
    const double cn = 0.5 * rho * w->cd_normal * d * length * wet;
    const double ct = 0.5 * rho * w->cd_tangential * std::numbers::pi * d * length * wet;
    Mat3 damping = cn * rn.norm() * across + 2.0 * ct * rt.norm() * tt;
    if (rn.norm() > 0.0) damping += cn / rn.norm() * outer(rn);
    const double mass = rho * w->volume * length * wet;
    const Mat3 added = mass * (w->ca_normal * across + w->ca_tangential * tt);
    Load& out = load_[numbered(own.index)];
    out.wet = true;
    out.force.head<3>() += cn * rn.norm() * rn + ct * rt.norm() * rt + damping * v +
                           mass * at.rate + added * at.rate + mass * gravity_ * Vec3(0, 0, 1);
    out.mass.topLeftCorner<3, 3>() += added;
    out.damping.topLeftCorner<3, 3>() += damping;
    if (wet < 1.0) out.stiffness(2, 2) += rise;
}

void SeaVerifier::add_lines(const World& world, const std::vector<Pose>& pose,
                            const std::vector<Twist>& before) {
    for (const WireId wire : world.wires().ids()) {
        const auto nodes = world.wires().nodes(wire);
        for (std::size_t i = 0; i < nodes.size(); ++i) {
            if (!world.alive(nodes[i]) || world.body_def(nodes[i]).kind != BodyKind::lump) continue;
            const bool at_end = i == 0 || i + 1 == nodes.size();
            if (at_end && std::find(ends_.begin(), ends_.end(), nodes[i]) != ends_.end()) continue;
            bool wet = false;
            for (std::size_t e = i > 0 ? i - 1 : 0; e < std::min(i + 1, nodes.size() - 1); ++e)
                wet = wet || (world.alive(world.wires().elements(wire)[e]) &&
                              water_of_element(world, wire, e) != nullptr);
            if (!wet) continue;
            const Vec3 x = pose[numbered(nodes[i].index)].position;
            Water at = water(x);
            if (def_->convective) at.rate += convection(x);
            if (i > 0) add_half(world, wire, i - 1, true, at, pose, before);
            if (i + 1 < nodes.size()) add_half(world, wire, i, false, at, pose, before);
        }
    }
}

/// Compute the force of quadratic drag, the gradient of ⅓ (rᵀ B r)^{3/2}, and its tangent.
void SeaVerifier::add_drag(const Mat3& axes, const Vec3& areas, double half_density,
                           const Vec3& flow, const Vec3& velocity, Load& out) {
    const Vec3 c = half_density * areas;
    Vec3 roots;
    for (int k = 0; k < 3; ++k) roots[k] = std::pow(c[k], 2.0 / 3.0);
    const Mat3 b = axes * roots.asDiagonal() * axes.transpose();
    const Vec3 r = flow - velocity, br = b * r;
    const double q = std::sqrt(std::max(r.dot(br), 0.0));
    if (q == 0.0) return;
    const Mat3 tangent = q * b + outer(br) / q;
    out.force.head<3>() += q * br + tangent * velocity;
    out.damping.topLeftCorner<3, 3>() += tangent;
}

void SeaVerifier::add_body(const WaterBody& def, const Pose& pose, const Vec3& velocity) {
    const double height =
        def.height > 0.0 ? def.height : std::cbrt(6.0 * def.volume / std::numbers::pi);
    Water at = water(pose.position);
    if (def_->convective) at.rate += convection(pose.position);
    const double z = pose.position.z();
    const double fraction = (at.surface - z) / height + 0.5;
    const double wet = std::clamp(fraction, 0.0, 1.0);
    const Mat3 axes = pose.orientation.toRotationMatrix();
    Load& out = load_[numbered(def.body.index)];
    if (std::abs(fraction) <= surface_error_ / height)
        out.jump += def_->density * def.volume * gravity_ / height;
    if (wet < 1.0 && !def.wind_area.isZero(0.0)) {
        out.wet = true;
        add_drag(axes, def.wind_area, 0.5 * def_->wind.density * (1.0 - wet),
                 wind(z + 0.5 * height), velocity, out);
    }
    if (wet <= 0.0) return;
    out.wet = true;
    add_drag(axes, def.drag_area, 0.5 * def_->density * wet, at.flow, velocity, out);
    const double mass = def_->density * def.volume * wet;
    const Mat3 added = mass * (axes * def.added_mass.asDiagonal() * axes.transpose());
    out.force.head<3>() += (mass * Mat3::Identity() + added) * at.rate;
    out.force.z() += mass * gravity_;
    out.mass.topLeftCorner<3, 3>() += added;
    out.stiffness(2, 2) += mass * gravity_ / (at.surface - (z - 0.5 * height));
}

double SeaVerifier::after_step(const World& world, const std::vector<Pose>& pose,
                               const std::vector<Twist>& before) {
    if (def_ == nullptr) return 0.0;
    level_ = sea_->tide(time_) + inputs_.level;
    sea_->at(time_, inputs_, air_);
    load_.assign(numbered(world.body_count()), Load{});
    double variance = 0.0;
    for (const Wave& wave : waves_) variance += 0.5 * wave.of.amplitude * wave.of.amplitude;
    // The permitted error is relative to the significant height. Coordinates have a rounding.
    surface_error_ = limit() * 4.0 * std::abs(inputs_.waves) * std::sqrt(variance) + 1e-12;
    add_lines(world, pose, before);
    for (const WaterBody& b : def_->bodies)
        add_body(b, pose[numbered(b.body.index)], before[numbered(b.body.index)].linear);
    mass_.assign(numbered(world.body_count()), 0.0);
    for (const WaterHull& h : def_->hulls)
        mass_[numbered(h.body.index)] = world.body_def(h.body).mass;
    for (std::size_t i = 0; i < def_->hulls.size(); ++i) {
        const WaterHull& h = def_->hulls[i];
        const std::size_t body = numbered(h.body.index);
        add_hull(h, pose[body], before[body]);
        if (h.coefficients) add_coefficients(h, history_[i], pose[body], before[body]);
    }
    for (const WaterRod& rod : def_->rods)
        add_rod(rod, pose[numbered(rod.body.index)], before[numbered(rod.body.index)]);
    double worst = 0.0;
    for (const LoadView& view : sea_loads(world)) {
        Load& mine = load_[numbered(view.body.index)];
        const auto n = static_cast<int>(view.force.size());
        const auto compare = [&](std::span<const double> world_values, const auto& entry,
                                 double size, double jump = 0.0) {
            constexpr int kHeave = 5;  // entry (2, 2) of a lower triangle by rows
            double most = 0.0;
            for (int i = 0; i < static_cast<int>(world_values.size()); ++i) {
                const double off = std::abs(world_values[numbered(i)] - entry(i));
                most = std::max(most, i == kHeave && off <= jump * (1.0 + 1e-6) ? 0.0 : off);
            }
            if (!(most <= 1e-14 * size)) worst = std::max(worst, most / size);
        };
        const double speed = before[numbered(view.body.index)].linear.norm();
        // The scale includes the weight of the body, because almost still water gives no scale.
        const double m = world.body_def(view.body).mass, h = world.settings().step;
        compare(
            view.force, [&](int i) { return mine.force[i]; },
            mine.force.norm() + mine.damping.norm() * speed + m * gravity_);
        struct Part {
            std::span<const double> world_values;
            const Mat6& own;
            double rounding_floor, jump = 0.0;
        };
        for (const Part& part :
             {Part{view.mass, mine.mass, m}, Part{view.damping, mine.damping, m / h},
              Part{view.stiffness, mine.stiffness, m / (h * h), mine.jump}}) {
            std::vector<double> triangle_of_own;
            for (int i = 0; i < n; ++i)
                for (int j = 0; j <= i; ++j) triangle_of_own.push_back(part.own(i, j));
            compare(
                part.world_values, [&](int i) { return triangle_of_own[numbered(i)]; },
                part.own.norm() + part.rounding_floor, part.jump);
        }
        mine.wet = false;
    }
    // Bodies that should have a load but have none.
    for (const Load& left : load_)
        if (left.wet && left.force.norm() > 0.0) worst = std::max(worst, 1.0);
    return worst;
}

}  // namespace hawser::verify
