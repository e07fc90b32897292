// SPDX-License-Identifier: Apache-2.0
#include "report/wires.h"

#include "record/scene_info.h"
#include "record/units.h"
#include "record/wire_position.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace hawser::report {

namespace {

constexpr std::size_t kMaxCourseSamples = 20, kMaxBroken = 100, kShownWires = 20, kShownBroken = 8;

void follow(Course& course, double now, bool first) {
    if (first) course = {now, now, now, now};
    course.now = now;
    course.least = std::min(course.least, now);
    course.most = std::max(course.most, now);
}

double count_nodes(const World& world, WireId wire) {
    const auto nodes = world.wires().nodes(wire);
    return static_cast<double>(
        std::count_if(nodes.begin(), nodes.end(), [&](BodyId id) { return world.alive(id); }));
}

BrokenWire broken_wire(const World& world, const Event& event) {
    BrokenWire out{.time = event.time,
                   .wire = {},
                   .element = record::interaction_label(world, event.interaction),
                   .tension = event.value};
    if (const auto at = record::wire_position(world, event.interaction)) {
        out.wire = at->wire;
        out.s = at->s;
        out.length = at->length;
    }
    return out;
}

std::string from_to(const Course& c, const char* unit) {
    if (c.least == c.most) return record::with_unit(c.now, unit);
    return fmt::format("{} ({} to {})", record::with_unit(c.now, unit),
                       record::with_unit(c.least, unit), record::with_unit(c.most, unit));
}

std::string count_from_to(const Course& c) {
    if (c.least == c.most) return fmt::format("{:.0f}", c.now);
    return fmt::format("{:.0f} ({:.0f} to {:.0f})", c.now, c.least, c.most);
}

}  // namespace

void WireWatch::sample(const World& world, Watched& w, bool first) {
    const auto elements = world.wires().elements(w.id);
    const double length = world.wires().length(w.id);
    follow(w.figures.nodes, count_nodes(world, w.id), first);
    follow(w.figures.length, length, first);
    w.elements.assign(elements.begin(), elements.end());
    w.fraction.assign(elements.size(), -1);
    const auto n = static_cast<double>(w.figures.along.size());
    double s = 0.0, shortest = HUGE_VAL, longest = 0.0, mass = 0.0;
    constexpr double kNeverParts = 1e30;  // default breaking load of elements [N]
    double weakest = kNeverParts;
    for (std::size_t i = 0; i < elements.size(); ++i) {
        if (!world.alive(elements[i])) continue;
        const double rest = record::rest_length(world, elements[i]);
        const double middle = n * (s + 0.5 * rest) / std::max(length, 1e-300);
        w.fraction[i] = static_cast<std::int32_t>(std::clamp(middle, 0.0, n - 1.0));
        s += rest;
        shortest = std::min(shortest, rest);
        longest = std::max(longest, rest);
        const InteractionDef& d = world.interaction_def(elements[i]);
        const KindInfo& kind = kind_info(d.kind);
        if (!kind.is(kWoundUp)) mass += std::max(0.0, d.get("mass"));
        if (kind.is(kWireElement)) weakest = std::min(weakest, d.get("breaking_load"));
    }
    w.figures.breaking_load = weakest < kNeverParts ? weakest : 0.0;
    if (longest == 0.0) shortest = 0.0;
    follow(w.figures.shortest, shortest, first);
    follow(w.figures.longest, longest, first);
    follow(w.figures.mass, mass, first);
}

/// Record the present element lengths of wires with adaptive resolution. If the list is full,
/// remove every second sample.
void WireWatch::record_edit_times(const World& world) {
    for (Watched& w : wires_) {
        if (!world.alive(w.id)) continue;
        WireFigures& f = w.figures;
        f.times.push_back({world.time(), f.nodes.now, f.shortest.now, f.longest.now});
    }
    if (wires_.empty() || wires_.front().figures.times.size() < kMaxTimes) return;
    noted_every_ *= 2;
    for (Watched& w : wires_) {
        std::vector<Resolved>& times = w.figures.times;
        for (std::size_t k = 0; 2 * k < times.size(); ++k) times[k] = times[2 * k];
        times.resize((times.size() + 1) / 2);
    }
}

WireWatch::WireWatch(const World& world) {
    for (const WireId id : world.wires().ids()) add(world, id, false);
    known_.assign(world.wires().ids().begin(), world.wires().ids().end());
}

void WireWatch::add(const World& world, WireId id, bool is_cut_piece) {
    const std::size_t shares =
        std::clamp<std::size_t>(world.wires().elements(id).size(), 1, kMaxCourseSamples);
    Watched one{.id = id, .figures = {}};
    one.sum.assign(shares, 0.0);
    one.counted.assign(shares, 0);
    one.figures.name = world.wires().name(id);
    one.figures.since = world.time();
    one.figures.is_cut_piece = is_cut_piece;
    one.figures.along.assign(shares, {HUGE_VAL, 0.0, -HUGE_VAL});
    sample(world, one, true);
    wires_.push_back(std::move(one));
}

/// Add the pieces of wires that were cut since the last call.
void WireWatch::add_pieces(const World& world) {
    const auto now = world.wires().ids();
    if (std::equal(now.begin(), now.end(), known_.begin(), known_.end())) return;
    for (const WireId id : now)
        if (std::find(known_.begin(), known_.end(), id) == known_.end()) add(world, id, true);
    known_.assign(now.begin(), now.end());
}

void WireWatch::after_step(const World& world, std::span<const Event> events) {
    for (const Event& event : events) {
        if (event.kind != EventKind::line_break || broken_.size() >= kMaxBroken) continue;
        if (world.alive(event.interaction)) broken_.push_back(broken_wire(world, event));
    }
    add_pieces(world);
    const bool due = steps_ % kSampleEvery == 0, noted = steps_ % noted_every_ == 0;
    ++steps_;
    for (Watched& w : wires_) {
        if (!world.alive(w.id)) continue;
        const auto elements = world.wires().elements(w.id);
        if (due ||
            !std::equal(elements.begin(), elements.end(), w.elements.begin(), w.elements.end()))
            sample(world, w, false);
        for (std::size_t i = 0; i < elements.size(); ++i) {
            if (w.fraction[i] < 0 || !world.alive(elements[i])) continue;
            const auto k = static_cast<std::size_t>(w.fraction[i]);
            TensionAlong& along = w.figures.along[k];
            // The force of a broken element is 0, that of a slack one maybe -0.
            const double tension = 0.0 - world.force(elements[i])[0];
            along.least = std::min(along.least, tension);
            along.greatest = std::max(along.greatest, tension);
            w.sum[k] += tension;
            ++w.counted[k];
        }
    }
    if (noted) record_edit_times(world);
}

std::vector<WireFigures> WireWatch::result(const World& world) const {
    std::vector<WireFigures> out;
    for (Watched w : wires_) {
        if (world.alive(w.id)) sample(world, w, false);
        TensionAlong whole{HUGE_VAL, 0.0, -HUGE_VAL};
        double tensions = 0.0;
        for (std::size_t k = 0; k < w.sum.size(); ++k) {
            TensionAlong& along = w.figures.along[k];
            if (w.counted[k] == 0) {
                along = {};
                continue;
            }
            along.mean = w.sum[k] / static_cast<double>(w.counted[k]);
            whole.least = std::min(whole.least, along.least);
            whole.greatest = std::max(whole.greatest, along.greatest);
            whole.mean += w.sum[k];
            tensions += static_cast<double>(w.counted[k]);
        }
        if (tensions > 0.0) {
            whole.mean /= tensions;
            w.figures.tension = whole;
        }
        for (const BrokenWire& p : broken_)
            if (p.wire == w.figures.name) w.figures.broken_wires.push_back(p);
        out.push_back(std::move(w.figures));
    }
    return out;
}

std::string wire_lines(const std::vector<WireFigures>& wires,
                       const std::vector<BrokenWire>& broken_wires) {
    std::string text;
    const auto out = std::back_inserter(text);
    for (std::size_t i = 0; i < std::min(kShownBroken, broken_wires.size()); ++i) {
        const BrokenWire& p = broken_wires[i];
        fmt::format_to(out, "  {:<11}  ", i == 0 ? "parted" : "");
        if (!p.wire.empty())
            fmt::format_to(out, "the wire {} at s = {} of {}, ", record::name_in_quotes(p.wire),
                           record::with_unit(p.s, "m"), record::with_unit(p.length, "m"));
        fmt::format_to(out, "element {}, at {:.6g} s with {}\n", record::name_in_quotes(p.element),
                       p.time, record::with_unit(p.tension, "N"));
    }
    if (broken_wires.size() > kShownBroken)
        fmt::format_to(out, "  {:<11}  and {} more (see --summary)\n", "",
                       broken_wires.size() - kShownBroken);
    // Wires without changes are reported in the table of cables.
    std::size_t shown = 0;
    for (const WireFigures& w : wires) {
        const bool changes =
            w.nodes.least != w.nodes.most || w.length.most - w.length.least > 1e-9 * w.length.most;
        if ((!changes && w.broken_wires.empty() && !w.is_cut_piece) || ++shown > kShownWires)
            continue;
        const std::string since =
            w.is_cut_piece ? ", a piece since " + record::with_unit(w.since, "s") : std::string();
        fmt::format_to(out, "  {:<11}  {}{}: nodes {}, elements {} to {}, unstretched length {}",
                       shown == 1 ? "wires" : "", record::name_in_quotes(w.name), since,
                       count_from_to(w.nodes), record::with_unit(w.shortest.least, "m"),
                       record::with_unit(w.longest.most, "m"), from_to(w.length, "m"));
        if (w.mass.most > 0.0) fmt::format_to(out, ", material {:.6g} kg", w.mass.now);
        fmt::format_to(out, "\n");
    }
    if (shown > kShownWires)
        fmt::format_to(out, "  {:<11}  and {} more (see --summary)\n", "", shown - kShownWires);
    return text;
}

}  // namespace hawser::report
