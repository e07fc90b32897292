// SPDX-License-Identifier: Apache-2.0
#include "report/wires.h"

#include "record/scene_info.h"
#include "record/units.h"
#include "record/wire_place.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace hawser::report {

namespace {

constexpr std::size_t kShares = 20, kMostParted = 100, kShownWires = 20, kShownParted = 8;

void follow(Course& course, double now, bool first) {
    if (first) course = {now, now, now, now};
    course.now = now;
    course.least = std::min(course.least, now);
    course.most = std::max(course.most, now);
}

double nodes_there(const World& world, WireId wire) {
    const auto nodes = world.nodes(wire);
    return static_cast<double>(
        std::count_if(nodes.begin(), nodes.end(), [&](BodyId id) { return world.alive(id); }));
}

PartedWire parted_wire(const World& world, const Event& event) {
    PartedWire out{.time = event.time,
                   .wire = {},
                   .element = record::interaction_label(world, event.interaction),
                   .tension = event.value};
    if (const auto at = record::wire_place(world, event.interaction)) {
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

WireWatch::WireWatch(const World& world) {
    for (const WireId id : world.wires()) {
        const std::size_t shares = std::clamp<std::size_t>(world.elements(id).size(), 1, kShares);
        Watched one{id, {}, std::vector<double>(shares, 0.0), std::vector<std::size_t>(shares, 0)};
        one.figures.name = world.wire_name(id);
        one.figures.along.assign(shares, {HUGE_VAL, 0.0, -HUGE_VAL});
        follow(one.figures.nodes, nodes_there(world, id), true);
        follow(one.figures.length, world.length(id), true);
        wires_.push_back(std::move(one));
    }
}

void WireWatch::after_step(const World& world, std::span<const Event> events) {
    for (const Event& event : events) {
        if (event.kind != EventKind::line_break || parted_.size() >= kMostParted) continue;
        if (world.alive(event.interaction)) parted_.push_back(parted_wire(world, event));
    }
    for (Watched& w : wires_) {
        if (!world.alive(w.id)) continue;
        WireFigures& f = w.figures;
        const double length = world.length(w.id);
        follow(f.nodes, nodes_there(world, w.id), false);
        follow(f.length, length, false);
        double s = 0.0;
        for (const InteractionId element : world.elements(w.id)) {
            if (!world.alive(element)) continue;
            const double rest = record::rest_length(world, element);
            const double share = (s + 0.5 * rest) / std::max(length, 1e-300);
            s += rest;
            const auto n = static_cast<double>(f.along.size());
            const auto k = static_cast<std::size_t>(std::clamp(share * n, 0.0, n - 1.0));
            const double tension =
                world.intact(element) ? record::element_tension(world, element) + 0.0 : 0.0;
            f.along[k].least = std::min(f.along[k].least, tension);
            f.along[k].greatest = std::max(f.along[k].greatest, tension);
            w.sum[k] += tension;
            ++w.counted[k];
        }
    }
}

std::vector<WireFigures> WireWatch::result() const {
    std::vector<WireFigures> out;
    for (const Watched& w : wires_) {
        out.push_back(w.figures);
        for (std::size_t k = 0; k < w.sum.size(); ++k)
            if (w.counted[k] > 0)
                out.back().along[k].mean = w.sum[k] / static_cast<double>(w.counted[k]);
            else
                out.back().along[k] = {};
        for (const PartedWire& p : parted_)
            if (p.wire == w.figures.name) out.back().parted.push_back(p);
    }
    return out;
}

std::string wires_in_words(const std::vector<WireFigures>& wires,
                           const std::vector<PartedWire>& parted) {
    std::string text;
    const auto out = std::back_inserter(text);
    for (std::size_t i = 0; i < std::min(kShownParted, parted.size()); ++i) {
        const PartedWire& p = parted[i];
        fmt::format_to(out, "  {:<11}  ", i == 0 ? "parted" : "");
        if (!p.wire.empty())
            fmt::format_to(out, "the wire {} at s = {} of {}, ", record::name_in_quotes(p.wire),
                           record::with_unit(p.s, "m"), record::with_unit(p.length, "m"));
        fmt::format_to(out, "element {}, at {:.6g} s with {}\n", record::name_in_quotes(p.element),
                       p.time, record::with_unit(p.tension, "N"));
    }
    if (parted.size() > kShownParted)
        fmt::format_to(out, "  {:<11}  and {} more (see --summary)\n", "",
                       parted.size() - kShownParted);
    // Wires of which nothing changes are told of in the table of cables.
    std::size_t shown = 0;
    for (const WireFigures& w : wires) {
        const bool changes =
            w.nodes.least != w.nodes.most || w.length.most - w.length.least > 1e-9 * w.length.most;
        if ((!changes && w.parted.empty()) || ++shown > kShownWires) continue;
        fmt::format_to(out, "  {:<11}  {}: nodes {}, unstretched length {}\n",
                       shown == 1 ? "wires" : "", record::name_in_quotes(w.name),
                       count_from_to(w.nodes), from_to(w.length, "m"));
    }
    if (shown > kShownWires)
        fmt::format_to(out, "  {:<11}  and {} more (see --summary)\n", "", shown - kShownWires);
    return text;
}

}  // namespace hawser::report
