// SPDX-License-Identifier: Apache-2.0
#include "marine/sea_system.h"

#include <hawser/world.h>

#include "marine/bodies.h"
#include "marine/spectra.h"

#include <algorithm>
#include <cmath>
#include <new>
#include <utility>

namespace hawser::marine {
namespace {

static_assert(LineNodes::kChunk <= WaterField::kMostPoints &&
              HullWater::kChunk <= WaterField::kMostPoints);

std::size_t slot(int i) noexcept { return static_cast<std::size_t>(i); }

/// Add a 3×3 triangle to a larger one, from row `first` on.
template <class To>
void add_sym(const Sym3& from, To& to) noexcept {
    for (int n = 0; n < 6; ++n) to[n] += from.m[n];
}

/// Add the loads of a hull or a rod.
template <class Water>
void add_hull(const Water& from, const BodyLoad& to) noexcept {
    if (to.freedom < 6) return;
    for (std::size_t k = 0; k < 6; ++k) to.force[k] += from.force[k];
    for (std::size_t k = 0; k < 21; ++k) {
        to.mass[k] += from.mass[k];
        to.damping[k] += from.damping[k];
        to.stiffness[k] += from.stiffness[k];
    }
}

}  // namespace

void add_point(const PointLoad& from, const BodyLoad& to) noexcept {
    for (int k = 0; k < 3 && k < to.freedom; ++k) to.force[k] += from.force[k];
    if (to.freedom < 3) return;
    add_sym(from.mass, to.mass);
    add_sym(from.damping, to.damping);
    add_sym(from.stiffness, to.stiffness);
}

SeaSystem::SeaSystem(const SeaDef& def, double gravity, LineTable lines, Start start)
    : def_(def),
      start_(std::move(start)),
      sea_(def, gravity),
      in_(sea_.inputs()),
      moment_(sea_.at(0.0)),
      field_(sea_, def_.current),
      lines_(std::move(lines)),
      line_part_(marine::line_part(def_, gravity, lines_.table())),
      bodies_(def_.bodies.size()) {
    hulls_.reserve(def_.hulls.size());
    for (std::size_t i = 0; i < def_.hulls.size(); ++i) {
        WaterHull& hull = def_.hulls[i];
        if (std::isnan(hull.linear.weight)) hull.linear.weight = start_.weight[i];
        if (hull.coefficients)
            hull.coefficients =
                std::make_shared<const WaveCoefficients>(without_noise(*hull.coefficients));
        try {
            hulls_.emplace_back(hull, sea_, start_.step, start_.heading[i], field_.fast().reach());
        } catch (const DefError& error) {
            throw SeaError("hulls/" + std::to_string(i) + "/coefficients", error.what());
        }
        list_work(static_cast<int>(i));
    }
    rods_.reserve(def_.rods.size());
    for (const WaterRod& rod : def_.rods) {
        rods_.emplace_back(rod);
        for (int c = 0; c < rods_.back().chunks(); ++c)
            points_.push_back({Piece::segments, static_cast<int>(rods_.size()) - 1, c});
    }
}

void SeaSystem::list_work(int hull) {
    const auto list = [&](std::vector<Work>& to, Piece piece, int chunks) {
        for (int c = 0; c < chunks; ++c) to.push_back({piece, hull, c});
    };
    const HullWater& of = hulls_[slot(hull)];
    list(points_, Piece::memory, def_.hulls[slot(hull)].coefficients ? 1 : 0);
    list(points_, Piece::corners, of.corner_chunks());
    list(points_, Piece::strips, of.strip_chunks());
    list(points_, Piece::cells, of.cell_chunks());
    list(sums_, Piece::triangles, of.triangle_chunks());
}

std::unique_ptr<System> SeaSystem::clone() const {
    return std::make_unique<SeaSystem>(def_, sea_.gravity(), lines_.table(), start_);
}

void SeaSystem::visit_state(StateVisitor& v) {
    for (double* x : {&in_.waves, &in_.current, &in_.wind, &in_.wind_direction, &in_.level,
                      &elevation_, &gust_, &tide_})
        v.visit(*x);
    for (HullWater& hull : hulls_) hull.visit_state(v);
}

void SeaSystem::check_state(const World& world, StateRules& rules) const {
    static_cast<void>(world);
    for (const HullWater& hull : hulls_) hull.check_state(rules);
}

HullMemory SeaSystem::memory(std::size_t hull) const {
    HullMemory out;
    if (hull >= hulls_.size())
        throw DefError("hull " + std::to_string(hull) + ": the sea has " +
                       std::to_string(hulls_.size()));
    hulls_[hull].write_memory(out);
    return out;
}

SeaAccuracy SeaSystem::accuracy() const {
    SeaAccuracy out;
    if (!acted_ || !field_.fast().on() || moment_.waves == 0.0) return out;
    out.significant = field_.fast().significant().velocity;
    out.tolerance = kKinematicTolerance;
    double worst = lines_.velocity_error(field_, out.points);
    for (const HullWater& hull : hulls_)
        worst = std::max(worst, hull.velocity_error(field_, out.points));
    out.error = worst / (moment_.waves * out.significant);
    return out;
}

void SeaSystem::signals(SignalTable& table) {
    table.input("waves", "1", in_.waves, 0.0, 10.0);
    table.input("current", "1", in_.current, -10.0, 10.0);
    table.input("wind", "m/s", in_.wind, 0.0, 100.0);
    table.input("wind_direction", "rad", in_.wind_direction, -1e3, 1e3);
    // Keep a hundredth of the depth at the lowest tide: the sea must not fall below the bottom.
    double lowest = def_.level.empty() ? 0.0 : def_.level.front().level;
    for (const SeaLevel& l : def_.level) lowest = std::min(lowest, l.level);
    table.input("level", "m", in_.level, std::max(-100.0, -0.99 * (def_.depth + lowest)), 100.0);
    table.output("elevation", "m", elevation_);
    table.output("gust", "m/s", gust_);
    table.output("tide", "m", tide_);
}

void SeaSystem::holds(HoldTable& table) const {
    for (const WaterBody& b : def_.bodies) table.hold(b.body);
    for (const WaterHull& h : def_.hulls) table.hold(h.body);
    for (const WaterRod& r : def_.rods) table.hold(r.body);
}

void SeaSystem::prestep(Prestep& now, Loads& loads) noexcept {
    acted_ = false;
    acting_ = in_;
    try {
        sea_.at(now.time, in_, moment_);
        field_.begin(moment_);
        lines_.list(now.world);
    } catch (const std::bad_alloc&) {
        return now.set_input(InputId{}, std::nan(""));  // ends the step
    } catch (const DefError&) {
        return now.set_input(InputId{}, std::nan(""));
    }
    elevation_ = sea_.elevation(moment_, def_.gauge[0], def_.gauge[1]);
    gust_ = moment_.wind - moment_.mean_wind;
    tide_ = sea_.tide(now.time);  // without in_.level, which is a separate input
    if (!compute(now)) return now.set_input(InputId{}, std::nan(""));
    acted_ = true;
    apply_loads(loads);
}

void SeaSystem::load_body(const World& world, int i) noexcept {
    const WaterBody& def = def_.bodies[slot(i)];
    const Pose pose = world.pose(def.body);
    const PointMotion motion{pose.position, world.velocity(def.body).linear};
    const Mat3 axes = pose.orientation.toRotationMatrix();
    PointLoad& out = bodies_[slot(i)];
    out = {};
    const Vec3 wind = sea_.wind(moment_, motion.position.z() + 0.5 * height_of(def));
    WaterPoint water = sea_.water(moment_, motion.position);
    if (def_.convective) water.acceleration += sea_.convection(moment_, motion.position);
    add_body_water(def, height_of(def), axes, motion, water, wind, def_.wind.density,
                   {sea_.density(), sea_.gravity()}, out);
}

void SeaSystem::do_work(const Work& w) noexcept {
    if (w.piece == Piece::segments)
        return rods_[slot(w.hull)].load(field_, def_.convective, w.chunk);
    HullWater& hull = hulls_[slot(w.hull)];
    if (w.piece == Piece::corners) return hull.press(field_, w.chunk);
    if (w.piece == Piece::strips) return hull.flow_past(field_, w.chunk);
    if (w.piece == Piece::cells) return hull.flow_over(field_, w.chunk);
    hull.remember(sea_, moment_);
}

bool SeaSystem::compute(Prestep& now) noexcept {
    for (HullWater& hull : hulls_) hull.begin(now.world, def_.convective);
    for (RodWater& rod : rods_) rod.begin(now.world);
    // Threads synchronise four times, for any number of hulls.
    now.for_each(lines_.wires(), [&](int i) noexcept { lines_.find(now.world, i); });
    const int works = static_cast<int>(points_.size());
    const int chunks = lines_.chunks();
    now.for_each(works + chunks + static_cast<int>(bodies_.size()), [&](int i) noexcept {
        if (i < works) return do_work(points_[slot(i)]);
        if (i >= works + chunks) return load_body(now.world, i - works - chunks);
        lines_.load_chunk(field_, def_.convective, i - works);
    });
    for (const HullWater& hull : hulls_)
        if (hull.lacks_direction()) return false;
    now.for_each(static_cast<int>(sums_.size()), [&](int i) noexcept {
        hulls_[slot(sums_[slot(i)].hull)].sum(sums_[slot(i)].chunk);
    });
    const int hulls = static_cast<int>(hulls_.size());
    now.for_each(hulls + static_cast<int>(rods_.size()), [&](int i) noexcept {
        if (i >= hulls) return rods_[slot(i - hulls)].finish();
        hulls_[slot(i)].finish(field_, def_.wind.density);
    });
    return true;
}

/// Add the computed loads to the world in the order of nodes, bodies, hulls and rods. The order
/// does not depend on threads.
void SeaSystem::apply_loads(Loads& loads) const noexcept {
    if (line_part_) loads.repeat(true);
    for (int i = 0; i < lines_.count(); ++i)
        if (lines_.of(i).any) add_point(lines_.of(i), loads.of(lines_.body(i)));
    loads.repeat(false);
    for (std::size_t i = 0; i < bodies_.size(); ++i)
        if (bodies_[i].any) add_point(bodies_[i], loads.of(def_.bodies[i].body));
    for (const HullWater& hull : hulls_)
        if (hull.any()) add_hull(hull, loads.of(hull.body()));
    for (const RodWater& rod : rods_)
        if (rod.any()) add_hull(rod, loads.of(rod.body()));
}

std::vector<LoadView> SeaSystem::loads() const {
    totals_.clear();
    std::vector<LoadView> out;
    if (!acted_) return out;
    const auto total = [&](BodyId body, int freedom) -> Total& {
        totals_.push_back({.body = body, .freedom = freedom});
        return totals_.back();
    };
    const auto load_of = [](Total& t) {
        return BodyLoad{t.freedom, t.force.data(), t.mass.data(), t.damping.data(),
                        t.stiffness.data()};
    };
    for (int i = 0; i < lines_.count(); ++i)
        if (lines_.of(i).any) add_point(lines_.of(i), load_of(total(lines_.body(i), 3)));
    for (std::size_t i = 0; i < bodies_.size(); ++i)
        if (bodies_[i].any) add_point(bodies_[i], load_of(total(def_.bodies[i].body, 3)));
    for (const HullWater& hull : hulls_)
        if (hull.any()) add_hull(hull, load_of(total(hull.body(), 6)));
    for (const RodWater& rod : rods_)
        if (rod.any()) add_hull(rod, load_of(total(rod.body(), 6)));
    std::stable_sort(totals_.begin(), totals_.end(),
                     [](const Total& a, const Total& b) { return a.body < b.body; });
    std::size_t last = 0;
    for (std::size_t i = 1; i < totals_.size(); ++i) {
        Total& to = totals_[last];
        if (totals_[i].body != to.body) {
            totals_[++last] = totals_[i];
            continue;
        }
        to.freedom = std::max(to.freedom, totals_[i].freedom);
        for (std::size_t k = 0; k < 6; ++k) to.force[k] += totals_[i].force[k];
        for (std::size_t k = 0; k < 21; ++k) {
            to.mass[k] += totals_[i].mass[k];
            to.damping[k] += totals_[i].damping[k];
            to.stiffness[k] += totals_[i].stiffness[k];
        }
    }
    if (!totals_.empty()) totals_.resize(last + 1);
    for (const Total& t : totals_) {
        const auto n = slot(t.freedom), size = n * (n + 1) / 2;
        out.push_back({t.body,
                       {t.force.data(), n},
                       {t.mass.data(), size},
                       {t.damping.data(), size},
                       {t.stiffness.data(), size}});
    }
    return out;
}

}  // namespace hawser::marine
