// SPDX-License-Identifier: Apache-2.0
#include "collide/collider.h"

#include "base/index.h"
#include "collide/grow.h"
#include "collide/touch.h"

#include <hawser/def.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <new>

namespace hawser::collide {
namespace {

constexpr int kPlacingChunk = 256;  ///< Shapes of one task.
constexpr int kPairChunk = 32;      ///< Pairs of one task.
constexpr int kContactChunk = 256;

constexpr std::size_t kChunkCapacity = kPairChunk * kMaxManifold;

/// Largest distance between points of one friction memory if the feature changes, in margins.
constexpr double kMatchMargins = 2.0;

/// Inverted box: it meets no box, not even itself.
constexpr Bounds kEmptyBounds{{4e30, 4e30, 4e30}, {-4e30, -4e30, -4e30}};

}  // namespace

void Collider::prepare(const model::Bodies& bodies, const model::Interactions& interactions,
                       double h) {
    find_owners(bodies.count());
    find_lines(interactions, bodies.count());
    filter_.build(shapes_, bodies.count(), interactions);
    // Boxes of other shapes need no update: collide() places all shapes again. Their old boxes
    // affect only the time of the broad phase.
    if (all_new_) placements_.clear();
    all_new_ = false;
    if (placements_.size() > shapes_.size()) placements_.resize(shapes_.size());
    while (placements_.size() < shapes_.size()) {
        new_.push_back(static_cast<std::int32_t>(placements_.size()));
        resize_with_reserve(placements_, placements_.size() + 1);
    }
    for (const std::int32_t s : new_) {
        if (at(s) >= shapes_.size()) continue;
        Placed& placed = placements_[at(s)] = {};
        placed.geometry = shapes_[at(s)].geometry;
        if (shapes_[at(s)].is_removed())
            placed.swept = kEmptyBounds;
        else
            place(shapes_[at(s)], bodies, lines_, h, margin, placed);
    }
    new_.clear();
    broad_.prepare(placements_);
}

void Collider::keep(Kept& out) const {
    out.slots = slots;
    out.shapes = shapes_;
    out.data = data_;
    out.contacts = last_contacts_;
    out.awake = last_awake_count_;
}

void Collider::restore_shapes(Kept& to) noexcept {
    std::swap(slots, to.slots);
    shapes_.swap(to.shapes);
    data_.swap(to.data);
    last_contacts_.swap(to.contacts);
    last_awake_count_ = to.awake;
    new_.clear();
    all_new_ = true;
}

void Collider::place_shapes(const model::Bodies& bodies, double h, base::Executor& pool) noexcept {
    auto task = [&](int i, int) noexcept {
        const std::size_t end = std::min(shapes_.size(), at((i + 1) * kPlacingChunk));
        for (std::size_t s = at(i * kPlacingChunk); s < end; ++s) {
            if (shapes_[s].is_removed()) continue;  // stays nowhere
            place(shapes_[s], bodies, lines_, h, margin, placements_[s]);
            const std::int32_t line = shapes_[s].line;
            if (line >= 0 && lines_->parted[at(line)] != 0) placements_[s].swept = kEmptyBounds;
        }
    };
    pool.for_each(base::chunks(shapes_.size(), kPlacingChunk), task);
}

/// Allocate buffers for the largest possible number of contacts of each task, because tasks must
/// not allocate.
void Collider::make_chunks(int tasks) {
    if (static_cast<int>(chunks_.size()) >= tasks) return;
    const auto room = at(tasks + tasks / 2 + 1);
    const double more =
        static_cast<double>(room - chunks_.size()) * kChunkCapacity * sizeof(Contact);
    if (const double all = static_cast<double>(bytes()) + more; all > max_bytes)
        throw LimitError({Bound::memory, all, max_bytes});
    chunk_size_.resize(room, 0);
    chunks_.reserve(room);
    while (chunks_.size() < room)
        chunks_.push_back(std::make_unique_for_overwrite<Contact[]>(kChunkCapacity));
}

void Collider::collide_pairs(double h, base::Executor& pool) {
    const int tasks = base::chunks(pairs_.size(), kPairChunk);
    make_chunks(tasks);
    auto task = [&](int i, int) noexcept {
        Contact* const begin = chunks_[at(i)].get();
        Contact* to = begin;
        const std::size_t end =
            pool.stopping() ? 0 : std::min(pairs_.size(), at((i + 1) * kPairChunk));
        for (std::size_t p = at(i * kPairChunk); p < end; ++p) {
            const std::int32_t a = pairs_[p].a, b = pairs_[p].b;
            const bool held = shapes_[at(a)].held >= 0 || shapes_[at(b)].held >= 0;
            const int n =
                touch(shapes_[at(a)], placements_[at(a)], shapes_[at(b)], placements_[at(b)], h,
                      margin, held && filter_.share_host(a, b), to);
            for (int k = 0; k < n; ++k, ++to) {
                to->shape[0] = a;
                to->shape[1] = b;
                to->surface = Materials::surface(shapes_[at(a)].material, shapes_[at(b)].material);
            }
        }
        chunk_size_[at(i)] = static_cast<std::int32_t>(to - begin);
    };
    pool.for_each(tasks, task);
}

void Collider::merge_tasks(ContactSet& out, base::Executor& pool) {
    const int tasks = base::chunks(pairs_.size(), kPairChunk);
    std::size_t total = 0;
    for (int i = 0; i < tasks; ++i) total += at(chunk_size_[at(i)]);
    // Duplicates are still included; they are at most half of the total.
    const auto refuse_beyond = [](std::size_t n, std::size_t most) {
        if (n > most)
            throw LimitError({Bound::contacts, static_cast<double>(n), static_cast<double>(most)});
    };
    refuse_beyond(total / 2, at(most_contacts));
    resize_with_reserve(out.contacts, total);
    auto to = out.contacts.begin();
    for (int i = 0; i < tasks; ++i) to = std::copy_n(chunks_[at(i)].get(), chunk_size_[at(i)], to);
    resize_with_reserve(is_dropped_, total);
    auto mark = [&](int i, int) noexcept {
        const std::size_t end = std::min(total, at((i + 1) * kContactChunk));
        for (std::size_t k = at(i * kContactChunk); k < end; ++k)
            is_dropped_[k] = is_duplicate(out.contacts, k, shapes_) ? 1 : 0;
    };
    pool.for_each(base::chunks(total, kContactChunk), mark);
    std::size_t n = 0;
    for (std::size_t i = 0; i < total; ++i) {
        if (is_dropped_[i] != 0) continue;
        if (n != i) out.contacts[n] = out.contacts[i];
        ++n;
    }
    out.contacts.resize(n);
    refuse_beyond(n, at(most_contacts));
    resize_with_reserve(found_, n);
    auto keep = [&](int i, int) noexcept {
        const std::size_t end = std::min(n, at((i + 1) * kContactChunk));
        for (std::size_t k = at(i * kContactChunk); k < end; ++k) {
            const Contact& c = out.contacts[k];
            found_[k] = {{c.shape[0], c.shape[1]}, c.feature, 0, {}};
            local_point(c, shapes_[at(c.shape[1])], placements_[at(c.shape[1])], found_[k].at);
        }
    };
    pool.for_each(base::chunks(n, kContactChunk), keep);
    match(out.contacts, found_, last_contacts_, last_awake_count_, kMatchMargins * margin,
          is_taken_);
    out.awake = found_awake_ = n;
}

void Collider::remove(std::int32_t shape) noexcept {
    Shape& s = shapes_[at(shape)];
    s = {};
    s.body[0] = s.body[1] = s.owner[0] = s.owner[1] = s.line = s.held = -1;
    data_[at(shape)].reset();
    slots.vacate(shape);
    new_.push_back(shape);
}

void Collider::attach_segment(std::int32_t shape, std::int32_t first, std::int32_t second,
                              const Vec3& point, const model::Bodies& bodies) noexcept {
    Shape& s = shapes_[at(shape)];
    s.body[0] = first;
    s.body[1] = second;
    std::copy_n(point.data(), 3, s.local.x);
    s.held = held_segment_end(s, bodies);
}

void Collider::truncate(std::int32_t kept) noexcept {
    slots.truncate(kept);
    shapes_.erase(shapes_.begin() + kept, shapes_.end());
    data_.erase(data_.begin() + kept, data_.end());
}

void Collider::forget_contacts(const std::vector<std::uint8_t>& stays) noexcept {
    std::size_t n = 0, awake = 0;
    for (std::size_t i = 0; i < last_contacts_.size(); ++i) {
        if (stays[i] == 0) continue;
        if (i < last_awake_count_) ++awake;
        last_contacts_[n++] = last_contacts_[i];
    }
    last_contacts_.resize(n);
    last_awake_count_ = awake;
}

bool Collider::set_aside(ContactSet& out, const base::Array<std::uint8_t>& asleep) noexcept {
    const auto rests = [&](const Contact& c) {
        for (int i = 0; i < c.slots; ++i)
            if (asleep[at(c.body[i])] != 0) return true;
        return false;
    };
    const auto n =
        static_cast<std::size_t>(std::count_if(out.contacts.begin(), out.contacts.end(), rests));
    try {
        resize_with_reserve(sleeping_, n);
        resize_with_reserve(last_set_aside_, n);
    } catch (const std::bad_alloc&) {
        return false;
    }
    std::size_t awake = 0, put = 0;
    for (std::size_t i = 0; i < out.contacts.size(); ++i) {
        const bool aside = rests(out.contacts[i]);
        (aside ? sleeping_[put] : out.contacts[awake]) = out.contacts[i];
        (aside ? last_set_aside_[put] : found_[awake]) = found_[i];
        ++(aside ? put : awake);
    }
    std::copy_n(sleeping_.begin(), n, out.contacts.begin() + static_cast<std::ptrdiff_t>(awake));
    std::copy_n(last_set_aside_.begin(), n, found_.begin() + static_cast<std::ptrdiff_t>(awake));
    out.awake = found_awake_ = awake;
    return true;
}

namespace {

/// @return true if a swept box lies in a range where differences of coordinates are meaningful.
///        Diverging motions reach any position within a step.
bool is_in_range(const Placed& p) noexcept {
    constexpr double kMaxPosition = 1e100;              // [m]: products of three of it are finite
    if (p.swept.low[0] > p.swept.high[0]) return true;  // segment of a parted line
    for (int k = 0; k < 3; ++k)
        if (!(std::fabs(p.swept.low[k]) < kMaxPosition) ||
            !(std::fabs(p.swept.high[k]) < kMaxPosition))
            return false;
    return true;
}

}  // namespace

bool Collider::collide(const model::Bodies& bodies, double h, ContactSet& out,
                       base::Executor& pool) noexcept {
    const auto nothing = [&] {
        out.contacts.clear();
        out.awake = found_awake_ = 0;
        found_.clear();
        return false;
    };
    constexpr std::int64_t kPairsOfContact = 8, kMaxPairs = 1'000'000'000;  // 32 bits count them
    over_ = {};
    finite_ = true;
    try {
        place_shapes(bodies, h, pool);
        // Boxes that are not finite have no order, and the sweep sorts them.
        finite_ = std::all_of(placements_.begin(), placements_.end(), is_in_range);
        if (!finite_) return nothing();
        broad_.find(placements_, filter_, h, margin,
                    std::min(kPairsOfContact * most_contacts, kMaxPairs), pool, pairs_);
        collide_pairs(h, pool);
        merge_tasks(out, pool);
    } catch (const std::bad_alloc&) {
        return nothing();
    } catch (const LimitError& error) {
        over_ = error.met();
        return nothing();
    }
    const std::size_t held = bytes() + base::bytes(out.contacts);
    if (held > held_) ++growth_count_;
    held_ = held;
    return true;
}

std::size_t Collider::bytes() const noexcept {
    std::size_t n = base::bytes(shapes_) + base::bytes(placements_) + base::bytes(pairs_) +
                    base::bytes(last_contacts_) + base::bytes(found_) + base::bytes(is_dropped_) +
                    base::bytes(is_taken_) + base::bytes(sleeping_) + base::bytes(last_set_aside_) +
                    broad_.bytes();
    return n + chunks_.size() * kChunkCapacity * sizeof(Contact);
}

}  // namespace hawser::collide
