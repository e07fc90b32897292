// SPDX-License-Identifier: Apache-2.0
/// Pairs in contact: links, the blocks of the matrix that contacts add to, and the slots of bodies.
#include "assembly/contacts.h"

#include "base/index.h"
#include "base/small.h"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

namespace hawser::assembly {

/// Remove the matrix links of pairs of bodies that are no longer in contact.
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

void Contacts::relink(std::int64_t step) {
    base::reserve_more(links, missing_.size());
    base::reserve_more(link_used, missing_.size());
    std::sort(missing_.begin(), missing_.end());
    missing_.erase(std::unique(missing_.begin(), missing_.end()), missing_.end());
    std::size_t kept = 0;
    for (std::size_t i = 0; i < links.size(); ++i) {
        if (step - link_used[i] > kKeepLinks) continue;
        links[kept] = links[i];
        link_used[kept++] = link_used[i];
    }
    // Merge from the end: move the links that stay back, with the missing ones, which are disjoint,
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

void Contacts::list_blocks() {
    blocks.clear();
    own_block_.assign(dof_.size(), -1);
    for (const std::int32_t b : touching_) {
        own_block_[at(b)] = static_cast<std::int32_t>(blocks.size());
        blocks.push_back({b, b, 0, 0});
    }
    for (const Link& link : links) blocks.push_back({link.first, link.second, 0, 0});
    connected_ = false;
}

bool Contacts::has_blocks() const noexcept {
    const std::size_t own = touching_.size(), count = own + links.size();
    // An allocation may have failed between any two of them.
    if (blocks.size() != count || block_value.size() != count * kContactBlock + 8 ||
        block_used.size() != count || block_changed.size() != count || block_skew.size() != count ||
        cursor_.size() != count)
        return false;
    for (std::size_t k = 0; k < count; ++k) {
        const Link pair = k < own ? Link{touching_[k], touching_[k]} : links[k - own];
        if (blocks[k].a != pair.first || blocks[k].b != pair.second) return false;
    }
    return true;
}

void Contacts::make_blocks() {
    list_blocks();
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

/// Find the block of each pair of slots, and count the contacts of each block. @return false if
/// pairs without a block exist; these are then missing links.
bool Contacts::find_blocks(std::int64_t step) noexcept {
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
    return missing_.empty();
}

/// List, for each block, the contacts that add to it. Call after find_blocks().
void Contacts::list_terms() noexcept {
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
}

/// List, for each body with contacts, the contact slots that refer to it.
void Contacts::list_slots() noexcept {
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
}

bool Contacts::connect(std::int64_t step) noexcept {
    // Usually the same bodies touch as in the last step.
    if (same_bodies() && connected_) {
        for (std::size_t i = 0; i < links.size(); ++i)
            if (block_used[touching_.size() + i]) link_used[i] = step;
        return true;
    }
    connected_ = false;
    if (!find_blocks(step)) return false;
    list_terms();
    list_slots();
    connected_ = true;
    return true;
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
                skew |= generic::any3(resistances.laws[at(r)].column) ? 1 : 0;
        }
        // A block that became symmetric is written again as well.
        block_changed[k] = change;
        block_skew[k] = skew;
    }
}

void Contacts::write_blocks(std::int32_t begin, std::int32_t end) noexcept {
    contact_kernels().blocks(rows.data(), cones.data(), resistances.laws.data(), blocks.data(),
                             block_changed.data(), terms_.data(), begin, end, block_value.data());
}

}  // namespace hawser::assembly
