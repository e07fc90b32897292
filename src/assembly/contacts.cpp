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

Contacts::Blocks Contacts::set_bodies(std::span<const std::int32_t> touching,
                                      const model::Bodies& bodies) {
    touching_before_.swap(touching_);
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
    const std::size_t linked = links.size();
    const bool none_missing = missing_.empty();
    drop_links();
    const bool same_links = none_missing && links.size() == linked;
    // The blocks stay, and their content is as old as at the start of any step.
    if (same_links && touching_ == touching_before_ && has_blocks()) {
        list_blocks();
        return Blocks::same;
    }
    relink(0);
    if (!same_links) return Blocks::links;
    return touching_ == touching_before_ ? Blocks::same : Blocks::own;
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

std::size_t Contacts::bytes() const noexcept {
    using base::bytes;
    return bytes(rows) + bytes(cones) + bytes(memory) + bytes(next_) + bytes(blocks) +
           bytes(block_value) + bytes(impulse) + bytes(slot_impulse) + bytes(links) +
           bytes(link_used) + bytes(extra_) + bytes(needed_) + bytes(terms_) + bytes(incident_) +
           bytes(touched_) + bytes(touching_) + bytes(touching_before_) + bytes(bodies_of_) +
           bytes(touched_before_) + bytes(incident_begin_) + resistances.bytes();
}

}  // namespace hawser::assembly
