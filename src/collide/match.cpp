// SPDX-License-Identifier: Apache-2.0
#include "collide/match.h"

#include "base/index.h"
#include "base/small.h"
#include "collide/grow.h"

#include <algorithm>
#include <cmath>

namespace hawser::collide {
namespace {

using generic::dot;
using generic::load3;
using generic::store3;
using generic::V3;
constexpr double kSamePoint = 1e-6;  ///< [m]; far below the radius of a wire, far above rounding
constexpr double kMinParallelCosine = 1.0 - 1e-9;

template <class C>
bool before(const C& c, std::int32_t a, std::int32_t b) noexcept {
    return c.shape[0] < a || (c.shape[0] == a && c.shape[1] < b);
}

/// Return the first contact of shapes (a, b) or later. Searches from `from` on in growing steps,
/// because the result is usually near.
std::size_t find(const std::vector<Contact>& contacts, std::size_t from, std::int32_t a,
                 std::int32_t b) noexcept {
    std::size_t low = from, high = from, step = 4;
    while (low > 0 && !before(contacts[low], a, b)) {
        high = low;
        low -= std::min(low, step);
        step *= 2;
    }
    step = 4;
    while (high < contacts.size() && before(contacts[high], a, b)) {
        low = high;
        high += std::min(contacts.size() - high, step);
        step *= 2;
    }
    const auto first = contacts.begin();
    const auto found = std::lower_bound(first + static_cast<std::ptrdiff_t>(low),
                                        first + static_cast<std::ptrdiff_t>(high), 0,
                                        [&](const Contact& c, int) { return before(c, a, b); });
    return static_cast<std::size_t>(found - first);
}

struct Side {
    int slots;
    std::int32_t body;  ///< First body.
};
Side side_of(const Contact& c, int s) noexcept {
    return s == 0 ? Side{c.side_0, c.body[0]} : Side{c.slots - c.side_0, c.body[c.side_0]};
}

/// True if contact `o` is a duplicate of contact `c` at a node that two segments share. Side t of
/// `o` belongs to the owner of the node; side s of `c` is the other segment.
bool same_contact(const Contact& c, int s, const Contact& o, int t) noexcept {
    const Side mine = side_of(c, s), its = side_of(o, t);
    if (its.slots != 1 || its.body != mine.body) return false;
    const double sign = s == t ? 1.0 : -1.0;
    if (sign * dot(load3(c.normal), load3(o.normal)) < kMinParallelCosine) return false;
    for (int k = 0; k < 2; ++k) {
        const V3 d = load3(c.on[k]) - load3(o.on[s == t ? k : 1 - k]);
        if (dot(d, d) > kSamePoint * kSamePoint) return false;
    }
    return true;
}

double distance_squared(const double* a, const double* b) noexcept {
    const V3 d = load3(a) - load3(b);
    return dot(d, d);
}

bool same_pair(const KeptContact& a, const KeptContact& b) noexcept {
    return a.shape[0] == b.shape[0] && a.shape[1] == b.shape[1];
}

/// Match the contacts [a, b) with the contacts [p, q) of the last step, which are those of the same
/// pair of shapes.
void match_pair(std::vector<Contact>& contacts, const base::Array<KeptContact>& now,
                const base::Array<KeptContact>& last, std::size_t a, std::size_t b, std::size_t p,
                std::size_t q, double radius, base::Array<std::uint8_t>& taken) noexcept {
    std::size_t open = 0;
    for (std::size_t i = a; i < b; ++i) {
        for (std::size_t j = p; j < q && contacts[i].previous < 0; ++j) {
            if (taken[j] != 0 || last[j].feature != now[i].feature) continue;
            contacts[i].previous = static_cast<std::int32_t>(j);
            taken[j] = 1;
        }
        if (contacts[i].previous < 0) ++open;
    }
    for (std::size_t i = a; i < b && open > 0; ++i) {
        if (contacts[i].previous >= 0) continue;
        double best = radius * radius;
        for (std::size_t j = p; j < q; ++j) {
            const double d = distance_squared(now[i].at, last[j].at);
            if (taken[j] != 0 || !(d < best)) continue;
            best = d;
            contacts[i].previous = static_cast<std::int32_t>(j);
        }
        if (contacts[i].previous >= 0) taken[at(contacts[i].previous)] = 1;
        --open;
    }
}

}  // namespace

void local_point(const Contact& contact, const Shape& side, const Placed& placed,
                 double* out) noexcept {
    const V3 d = load3(contact.on[1]) - load3(placed.at.x);
    store3(out, side.segment() ? d : generic::tmul(generic::load9(placed.at.r), d));
}

bool is_duplicate(const std::vector<Contact>& contacts, std::size_t i,
                  const std::vector<Shape>& shapes) noexcept {
    const Contact& c = contacts[i];
    for (int s = 0; s < 2; ++s) {
        const Shape& shape = shapes[at(c.shape[s])];
        const Side side = side_of(c, s);
        if (!shape.segment() || side.slots != 1) continue;
        const std::int32_t owner = shape.owner[side.body == shape.body[0] ? 0 : 1];
        const std::int32_t other = c.shape[1 - s];
        if (owner < 0 || owner == other) continue;
        const std::int32_t a = std::min(owner, other), b = std::max(owner, other);
        const int t = owner < other ? 0 : 1;
        for (std::size_t j = find(contacts, i, a, b);
             j < contacts.size() && contacts[j].shape[0] == a && contacts[j].shape[1] == b; ++j)
            if (same_contact(c, s, contacts[j], t)) return true;
    }
    return false;
}

void match(std::vector<Contact>& contacts, const base::Array<KeptContact>& now,
           const base::Array<KeptContact>& last, std::size_t awake, double radius,
           base::Array<std::uint8_t>& taken) {
    resize_with_reserve(taken, last.size());
    std::fill(taken.begin(), taken.end(), std::uint8_t{0});
    const std::size_t ends[2] = {awake, last.size()};
    std::size_t from[2] = {0, awake};
    for (std::size_t a = 0, b = 0; a < contacts.size(); a = b) {
        for (b = a + 1; b < contacts.size() && same_pair(now[a], now[b]);) ++b;
        for (int part = 0; part < 2; ++part) {
            std::size_t p = from[part];
            while (p < ends[part] && before(last[p], now[a].shape[0], now[a].shape[1])) ++p;
            std::size_t q = p;
            while (q < ends[part] && same_pair(last[q], now[a])) ++q;
            if (p < q) match_pair(contacts, now, last, a, b, p, q, radius, taken);
            from[part] = q;
        }
    }
}

}  // namespace hawser::collide
