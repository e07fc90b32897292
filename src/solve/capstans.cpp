// SPDX-License-Identifier: Apache-2.0
#include "solve/capstans.h"

#include "base/index.h"
#include "solve/bounds.h"

#include <algorithm>
#include <span>

namespace hawser::stepper {
namespace {

using assembly::Capstan;
using assembly::CapstanEntry;

double sign_of(double x) noexcept { return x > 0.0 ? 1.0 : x < 0.0 ? -1.0 : 0.0; }

/// f(capstan, its entries) of all.
template <class F>
void each_capstan(assembly::System& system, F&& f) noexcept {
    CapstanEntry* entry = system.capstan_entries.data();
    for (Capstan& c : system.capstans) {
        f(c, std::span<CapstanEntry>(entry, at(c.entries)));
        entry += c.entries;
    }
}

bool slides(const Model& model, const Capstan& c) noexcept {
    return model.interactions.active[at(c.friction)] == 0.0;
}

/// Sign of the force of one that slides; kept for when the force itself is none.
double side_of(const Model& model, Capstan& c) noexcept {
    const double held = model.interactions.held[at(c.friction)];
    if (held != 0.0) c.side = sign_of(held);
    return c.side;
}

}  // namespace

void release_capstans(Model& model, const Newton& newton) noexcept {
    model::Interactions& in = model.interactions;
    each_capstan(model.system, [&](Capstan& c, std::span<CapstanEntry>) {
        if (!slides(model, c)) return;
        const double side = side_of(model, c);
        const auto id = at(c.friction);
        in.held[id] =
            newton.bound_time * (side > 0.0 ? in.high[id] : side < 0.0 ? in.low[id] : 0.0);
    });
}

void follow_capstans(Model& model, const Newton& newton, const assembly::View& v) noexcept {
    model::Interactions& in = model.interactions;
    each_capstan(model.system, [&](Capstan& c, std::span<CapstanEntry>) {
        if (!slides(model, c)) return;
        const double side = side_of(model, c);
        if (side == 0.0) return;
        const ImpulseRange range = impulse_range(model, newton, c.friction);
        const std::int32_t row = in.row_begin[at(c.friction)],
                           offset = v.interaction_offset[c.friction];
        const double force = side > 0.0 ? range.high : range.low;
        in.held[at(c.friction)] = force;
        v.lambda[row] = v.multiplier[row] = force;
        v.residual[row] = 0.0;
        if (offset >= 0) v.solution[offset] = 0.0;
    });
}

bool couple_capstans(Model& model) noexcept {
    bool any = false;
    const model::Interactions& in = model.interactions;
    each_capstan(model.system, [&](Capstan& c, std::span<CapstanEntry> entries) {
        const double side = slides(model, c) ? side_of(model, c) : 0.0;
        for (CapstanEntry& e : entries) {
            const double pulls = in.lambda[at(in.row_begin[at(e.load)])] > 0.0 ? -1.0 : 1.0;
            e.value = in.parted[at(e.load)] ? 0.0 : -side * e.factor * pulls;
            any |= e.value != 0.0;
        }
    });
    return any;
}

void switch_runs(Model& model, const Newton& newton) noexcept {
    assembly::System& s = model.system;
    model::Interactions& in = model.interactions;
    const std::size_t count = s.capstans.size();
    for (CapstanEntry& e : s.capstan_entries)
        e.tension = std::max(0.0, -in.lambda[at(in.row_begin[at(e.load)])]);
    // Those with two loads, which stand two by two where all of a run have as many.
    std::size_t entry = 0;
    for (std::size_t first = 0; first < count;) {
        std::size_t last = first, begin = entry;
        const auto two = [&](std::size_t k) { return s.capstans[k].entries == 2; };
        while (two(last) && last + 1 < count && two(last + 1) &&
               s.capstan_entries[begin + 2 * (last - first) + 1].load ==
                   s.capstan_entries[begin + 2 * (last - first) + 2].load)
            ++last;
        const std::size_t n = last - first + 1;
        if (n == 1) {
            entry += at(s.capstans[first].entries);
            ++first;
            continue;
        }
        CapstanEntry* e = &s.capstan_entries[begin];
        const auto ratio = [&](std::size_t k) {
            const double f = std::min(e[2 * k].factor, 1.0 - 1e-12);
            return (1.0 + f) / (1.0 - f);
        };
        // What the second end lets the spans before it have, then what the first one does.
        for (std::size_t k = n; k-- > 1;) {
            const double r = ratio(k), behind = e[2 * k + 1].tension;
            e[2 * k].tension = std::clamp(e[2 * k].tension, behind / r, behind * r);
            e[2 * k - 1].tension = e[2 * k].tension;
        }
        for (std::size_t k = 0; k + 1 < n; ++k) {
            const double r = ratio(k), before = e[2 * k].tension;
            e[2 * k + 1].tension = std::clamp(e[2 * k + 1].tension, before / r, before * r);
            e[2 * k + 2].tension = e[2 * k + 1].tension;
        }
        constexpr double kAtBound = 1.0 - 1e-9;
        for (std::size_t k = 0; k < n; ++k) {
            Capstan& c = s.capstans[first + k];
            if (slides(model, c)) continue;
            const double r = kAtBound * ratio(k), t1 = e[2 * k].tension, t2 = e[2 * k + 1].tension;
            if (!(t1 > r * t2) && !(t2 > r * t1)) continue;
            in.active[at(c.friction)] = 0.0;
            c.side = t1 > t2 ? 1.0 : -1.0;
            const ImpulseRange range = impulse_range(model, newton, c.friction);
            in.held[at(c.friction)] = c.side > 0.0 ? range.high : range.low;
            in.lambda[at(in.row_begin[at(c.friction)])] = in.held[at(c.friction)];
        }
        entry += 2 * n;
        first = last + 1;
    }
}

bool is_capstan(const Model& model, std::int32_t friction) noexcept {
    const auto& all = model.system.capstans;  // ascending
    const auto found = std::lower_bound(
        all.begin(), all.end(), friction,
        [](const Capstan& c, std::int32_t wanted) { return c.friction < wanted; });
    return found != all.end() && found->friction == friction;
}

}  // namespace hawser::stepper
