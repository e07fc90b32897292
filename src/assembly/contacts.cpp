// SPDX-License-Identifier: Apache-2.0
#include "assembly/contacts.h"

#include "base/index.h"
#include "base/small.h"

#include <algorithm>
#include <cmath>

namespace hawser::assembly {
namespace {

using namespace hawser::generic;

}  // namespace

void Contacts::set_bodies(std::span<const std::int32_t> touching, const model::Bodies& bodies) {
    touching_.assign(touching.begin(), touching.end());
    const auto n = static_cast<std::size_t>(bodies.count());
    dof_.resize(n);
    dof_begin_.resize(n);
    for (std::size_t b = 0; b < n; ++b) {
        dof_[b] = bodies.dof(static_cast<int>(b));
        dof_begin_[b] = bodies.dof_begin[b];
    }
    place_.assign(n, -1);
    impulse.assign(at(bodies.dofs) + 8, 0.0);
    std::erase_if(touching_, [&](std::int32_t b) { return dof_[at(b)] == 0; });
    drop_links();
    relink(0);
}

/// Of bodies that touch nothing any more.
void Contacts::drop_links() noexcept {
    const auto touches = [&](std::int32_t b) {
        return std::binary_search(touching_.begin(), touching_.end(), b);
    };
    std::size_t n = 0;
    for (std::size_t i = 0; i < links.size(); ++i) {
        if (!touches(links[i].first) || !touches(links[i].second)) continue;
        links[n] = links[i];
        link_used[n++] = link_used[i];
    }
    links.resize(n);
    link_used.resize(n);
}

void Contacts::forget(const std::vector<std::uint8_t>& stays) noexcept {
    const std::size_t shown = rows.size();
    std::size_t n = 0, kept_rows = 0, place = 0, resistance = 0;
    for (std::size_t i = 0; i < memory.size(); ++i) {
        const bool has_resistance = resistance < resistances.memory.size() &&
                                    at(resistances.memory[resistance].contact) == i;
        if (stays[i] != 0) {
            if (i < shown) {
                rows[kept_rows] = rows[i];
                cones[kept_rows++] = cones[i];
            }
            if (has_resistance) {
                resistances.memory[place] = resistances.memory[resistance];
                resistances.memory[place++].contact = static_cast<std::int32_t>(n);
            }
            memory[n++] = memory[i];
        }
        if (has_resistance) ++resistance;
    }
    memory.resize(n);
    resistances.memory.resize(place);
    rows.resize(kept_rows);
    cones.resize(kept_rows);
    connected_ = false;
}

void Contacts::relink(std::int64_t step) {
    base::make_room(links, missing_.size());
    base::make_room(link_used, missing_.size());
    std::sort(missing_.begin(), missing_.end());
    missing_.erase(std::unique(missing_.begin(), missing_.end()), missing_.end());
    std::size_t kept = 0;
    for (std::size_t i = 0; i < links.size(); ++i) {
        if (step - link_used[i] > kKeepLinks) continue;
        links[kept] = links[i];
        link_used[kept++] = link_used[i];
    }
    // Those that stay move back from the end, and the missing ones, which are none of them,
    // between.
    std::size_t to = kept + missing_.size();
    links.resize(to);
    link_used.resize(to);
    for (std::size_t m = missing_.size(); m > 0;) {
        const bool old = kept > 0 && missing_[m - 1] < links[kept - 1];
        --to;
        links[to] = old ? links[kept - 1] : missing_[m - 1];
        link_used[to] = old ? link_used[kept - 1] : step;
        --(old ? kept : m);
    }
    missing_.clear();
    make_blocks();
}

void Contacts::make_blocks() {
    blocks.clear();
    own_block_.assign(dof_.size(), -1);
    for (const std::int32_t b : touching_) {
        own_block_[at(b)] = static_cast<std::int32_t>(blocks.size());
        blocks.push_back({b, b, 0, 0});
    }
    for (const Link& link : links) blocks.push_back({link.first, link.second, 0, 0});
    connected_ = false;
    block_value.assign(blocks.size() * kContactBlock + 8, 0.0);
    block_used.assign(blocks.size(), 0);
    block_changed.assign(blocks.size(), 0);
    block_skew.assign(blocks.size(), 0);
    cursor_.resize(blocks.size());
}

std::int32_t Contacts::block_of(std::int32_t a, std::int32_t b) const noexcept {
    if (a == b) return own_block_[at(a)];
    const Link link{std::min(a, b), std::max(a, b)};
    const auto found = std::lower_bound(links.begin(), links.end(), link);
    if (found == links.end() || *found != link) return -1;
    return static_cast<std::int32_t>(touching_.size()) +
           static_cast<std::int32_t>(found - links.begin());
}

void Contacts::begin(std::size_t count, std::size_t asleep) {
    rows.resize(count);
    cones.resize(count);
    next_.resize(count + asleep);
    changed.resize(count);
    extra_.resize(count);
    if (bodies_of_.size() != count) connected_ = false;
    bodies_of_.resize(count);
    slot_impulse.resize(24 * count + 8);
    needed_.resize(16 * count);
    terms_.resize(16 * count);
    incident_.resize(4 * count);
    touched_.reserve(4 * count);
    touched_before_.reserve(4 * count);
    incident_begin_.reserve(4 * count + 1);
    missing_.reserve(6 * count);
}

void Contacts::recall_lambda(std::size_t k) noexcept {
    store3(cones[k].lambda, load9(rows[k].axis) * load3(next_[k].lambda));
}

bool Contacts::same_bodies() noexcept {
    bool same = true;
    for (std::size_t k = 0; k < rows.size(); ++k) {
        const ContactRow& row = rows[k];
        std::array<std::int32_t, 4> now{-1, -1, -1, -1};
        for (int i = 0; i < row.slots; ++i) now[static_cast<std::size_t>(i)] = row.slot[i].body;
        same = same && now == bodies_of_[k];
        bodies_of_[k] = now;
    }
    return same;
}

bool Contacts::connect(std::int64_t step) noexcept {
    // Mostly the same bodies touch as in the last step.
    if (same_bodies() && connected_) {
        for (std::size_t i = 0; i < links.size(); ++i)
            if (block_used[touching_.size() + i]) link_used[i] = step;
        return true;
    }
    connected_ = false;
    // Blocks.
    missing_.clear();
    for (ContactBlock& b : blocks) b.begin = b.end = 0;
    for (std::size_t k = 0; k < rows.size(); ++k) {
        const ContactRow& row = rows[k];
        std::fill_n(&needed_[16 * k], 16, -1);
        for (int i = 0; i < row.slots; ++i) {
            for (int j = 0; j < row.slots; ++j) {
                std::int32_t& block =
                    needed_[16 * k + 4 * static_cast<std::size_t>(i) + static_cast<std::size_t>(j)];
                const ContactSlot &a = row.slot[i], &b = row.slot[j];
                if (a.dof == 0 || b.dof == 0 || a.body > b.body) continue;
                block = block_of(a.body, b.body);
                if (block < 0) {
                    missing_.push_back({a.body, b.body});
                    continue;
                }
                ++blocks[at(block)].end;
                if (a.body != b.body) link_used[at(block) - touching_.size()] = step;
            }
        }
    }
    if (!missing_.empty()) return false;
    std::int32_t sum = 0;
    for (std::size_t k = 0; k < blocks.size(); ++k) {
        block_used[k] = blocks[k].end > 0 ? 1 : 0;
        blocks[k].begin = cursor_[k] = sum;
        sum += blocks[k].end;
        blocks[k].end = sum;
    }
    for (std::size_t k = 0; k < rows.size(); ++k)
        for (std::size_t ij = 0; ij < 16; ++ij)
            if (const std::int32_t block = needed_[16 * k + ij]; block >= 0)
                terms_[at(cursor_[at(block)]++)] = {static_cast<std::int32_t>(k),
                                                    static_cast<std::int8_t>(ij / 4),
                                                    static_cast<std::int8_t>(ij % 4)};
    // Slots by body.
    touched_before_.swap(touched_);
    touched_.clear();
    for (const std::int32_t b : touched_before_)
        std::fill_n(&impulse[at(dof_begin_[at(b)])], dof_[at(b)], 0.0);
    auto each_slot = [&](auto&& f) {
        for (std::size_t k = 0; k < rows.size(); ++k)
            for (int i = 0; i < rows[k].slots; ++i)
                if (rows[k].slot[i].dof > 0)
                    f(rows[k].slot[i].body, static_cast<std::int32_t>(24 * k) + 6 * i);
    };
    each_slot([&](std::int32_t b, std::int32_t) {
        if (place_[at(b)] >= 0) return;
        place_[at(b)] = 0;
        touched_.push_back(b);
    });
    std::sort(touched_.begin(), touched_.end());
    for (std::size_t i = 0; i < touched_.size(); ++i)
        place_[at(touched_[i])] = static_cast<std::int32_t>(i);
    incident_begin_.assign(touched_.size() + 1, 0);
    each_slot([&](std::int32_t b, std::int32_t) { ++incident_begin_[at(place_[at(b)]) + 1]; });
    for (std::size_t i = 0; i < touched_.size(); ++i) incident_begin_[i + 1] += incident_begin_[i];
    each_slot([&](std::int32_t b, std::int32_t offset) {
        incident_[at(incident_begin_[at(place_[at(b)])]++)] = offset;
    });
    for (std::size_t i = touched_.size(); i > 0; --i) incident_begin_[i] = incident_begin_[i - 1];
    incident_begin_[0] = 0;
    for (const std::int32_t b : touched_) place_[at(b)] = -1;
    connected_ = true;
    return true;
}

void Contacts::update(const double* v, std::int32_t begin, std::int32_t end) noexcept {
    contact_kernels().update(rows.data(), cones.data(), begin, end, v, slot_impulse.data());
}

void Contacts::update_resistances(const double* v, std::int32_t begin, std::int32_t end) noexcept {
    contact_kernels().turn(rows.data(), cones.data(), resistances.rows.data(),
                           resistances.laws.data(), begin, end, v, slot_impulse.data());
}

void Contacts::gather(std::int32_t begin, std::int32_t end) noexcept {
    for (std::size_t i = at(begin); i < at(end); ++i) {
        const std::int32_t body = touched_[i];
        double sum[6] = {};
        for (std::int32_t k = incident_begin_[i]; k < incident_begin_[i + 1]; ++k)
            for (int j = 0; j < 6; ++j) sum[j] += slot_impulse[at(incident_[at(k)]) + at(j)];
        std::copy_n(sum, dof_[at(body)], &impulse[at(dof_begin_[at(body)])]);
    }
}

void Contacts::scatter(const double* x, double* solution,
                       const std::int32_t* offset) const noexcept {
    for (std::size_t k = 0; k < rows.size(); ++k) {
        const ContactRow& row = rows[k];
        if (x[3 * k] == 0.0 && x[3 * k + 1] == 0.0 && x[3 * k + 2] == 0.0) continue;
        const V3 force = tmul(load9(row.axis), load3(x + 3 * k));
        for (int i = 0; i < row.slots; ++i) {
            const ContactSlot& s = row.slot[i];
            if (s.dof == 0) continue;
            const V3 f = s.weight * force;
            double* to = solution + offset[s.body];
            add3(to, f);
            if (s.dof == 6) add3(to + 3, cross(load3(s.arm), f));
        }
    }
    resistances.scatter(rows, x + 3 * rows.size(), solution, offset);
}

void Contacts::collect(const double* solution, const std::int32_t* offset,
                       double* u) const noexcept {
    for (std::size_t k = 0; k < rows.size(); ++k) {
        const ContactRow& row = rows[k];
        V3 sum{0, 0, 0};
        for (int i = 0; i < row.slots; ++i) {
            const ContactSlot& s = row.slot[i];
            if (s.dof == 0) continue;
            const double* v = solution + offset[s.body];
            V3 at_point = load3(v);
            if (s.dof == 6) at_point = at_point + cross(load3(v + 3), load3(s.arm));
            sum = sum + s.weight * at_point;
        }
        store3(u + 3 * k, load9(row.axis) * sum);
    }
    resistances.collect(rows, solution, offset, u + 3 * rows.size());
}

void Contacts::mark_blocks() noexcept {
    for (std::size_t k = 0; k < blocks.size(); ++k) {
        std::uint8_t change = 0, skew = 0;
        for (std::int32_t t = blocks[k].begin; t < blocks[k].end; ++t) {
            const auto contact = at(terms_[at(t)].contact);
            const nonsmooth::Cone& c = cones[contact];
            change |= changed[contact];
            skew |= c.s[3] != 0.0 || c.s[6] != 0.0 ? 1 : 0;
            if (const std::int32_t r = rows[contact].resistance; r >= 0)
                skew |= any3(resistances.laws[at(r)].column) ? 1 : 0;
        }
        // One that became symmetric is written again as well.
        block_changed[k] = change;
        block_skew[k] = skew;
    }
}

void Contacts::write_blocks(std::int32_t begin, std::int32_t end) noexcept {
    contact_kernels().blocks(rows.data(), cones.data(), resistances.laws.data(), blocks.data(),
                             block_changed.data(), terms_.data(), begin, end, block_value.data());
}

std::size_t Contacts::bytes() const noexcept {
    using base::bytes;
    return bytes(rows) + bytes(cones) + bytes(memory) + bytes(next_) + bytes(blocks) +
           bytes(block_value) + bytes(impulse) + bytes(slot_impulse) + bytes(links) +
           bytes(link_used) + bytes(extra_) + bytes(needed_) + bytes(terms_) + bytes(incident_) +
           bytes(touched_) + bytes(bodies_of_) + bytes(touched_before_) + bytes(incident_begin_) +
           resistances.bytes();
}

}  // namespace hawser::assembly
