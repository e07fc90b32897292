// SPDX-License-Identifier: Apache-2.0
#include "assembly/resistances.h"

#include "base/index.h"
#include "base/small.h"

#include <hawser/row_constants.h>

#include <algorithm>
#include <cmath>

namespace hawser::assembly {
namespace {

using namespace hawser::generic;
using nonsmooth::Resistance;
using nonsmooth::Touch;

/// A rotation beyond this [rad] about an axis without resistance resets the reference.
constexpr double kMaxReferenceAngle = 1e-2;

/// Quaternion: scalar part w, vector part v.
struct Q {
    double w;
    V3 v;
};
Q load4(const double* q) { return {q[0], load3(q + 1)}; }
Q operator*(const Q& a, const Q& b) {
    return {a.w * b.w - dot(a.v, b.v), a.w * b.v + b.w * a.v + cross(a.v, b.v)};
}
Q conjugate(const Q& a) { return {a.w, -a.v}; }
/// Return the quaternion of a small rotation vector g by the Cayley map.
Q turn_by(const V3& g) {
    const double s = 1.0 / std::sqrt(1.0 + 0.25 * dot(g, g));
    return {s, (0.5 * s) * g};
}

bool resists(const collide::Surface& s) { return s.rolling > 0.0 || s.torsional > 0.0; }

/// Return the mean inverse moment of inertia of a body over its axes.
double rotation_mobility(const model::Bodies& b, std::int32_t body) {
    const double* i = &b.inv_inertia[9 * at(body)];
    return (i[0] + i[4] + i[8]) / 3.0;
}

}  // namespace

void Resistances::begin(const collide::ContactSet& set, base::Array<ContactRow>& contacts,
                        const model::Bodies& bodies, double h) {
    rows.clear();
    laws.clear();
    next_.clear();
    if (std::none_of(set.surfaces.begin(), set.surfaces.end(), resists)) return;
    for (std::size_t k = 0; k < contacts.size(); ++k) {
        const collide::Contact& in = set.contacts[k];
        const collide::Surface& surface = set.surfaces[at(in.surface)];
        ContactRow& contact = contacts[k];
        if (!resists(surface) || in.slots != 2 || in.side_0 != 1) continue;
        if (!bodies.turns(in.body[0]) || !bodies.turns(in.body[1])) continue;
        contact.resistance = static_cast<std::int32_t>(laws.size());
        ResistanceRow row{};
        Resistance a{};
        row.contact = static_cast<std::int32_t>(k);
        double inverse_mass = 0.0;
        V3 carried{0, 0, 0};
        for (int i = 0; i < 2; ++i) {
            const ContactSlot& s = contact.slot[i];
            if (s.dof == 6) {
                inverse_mass += 1.0 / bodies.mass[at(s.body)];
                a.mobility += rotation_mobility(bodies, s.body);
            } else if (bodies.kind[at(s.body)] == BodyKind::kinematic) {
                carried = carried + s.weight * load3(&bodies.v_fixed[6 * at(s.body) + 3]);
            }
        }
        store3(row.carried, load9(contact.axis) * carried);
        row.epsilon = surface.tangential_compliance * a.mobility / inverse_mass;
        a.torsional = surface.torsional;
        a.rolling = surface.rolling;
        const double upsilon = row_upsilon(surface.damping_time, h);
        const double scale = row_sigma(1.0, upsilon, h);
        a.sigma = std::max(scale * row.epsilon, kMinSigma * a.mobility);
        row.epsilon = a.sigma / scale;
        rows.push_back(row);
        laws.push_back(a);
        next_.emplace_back();
        recall_turn(laws.size() - 1, in.previous, contact, bodies);
        for (std::size_t i = 0; i < 3; ++i)
            laws.back().b[i] = -4.0 / h * upsilon * rows.back().gap[i];
    }
    // Sleeping contacts keep their memory.
    for (std::size_t k = contacts.size(); k < set.contacts.size(); ++k) {
        const ResistanceMemory* m = find(set.contacts[k].previous);
        if (m == nullptr) continue;
        next_.push_back(*m);
        next_.back().contact = static_cast<std::int32_t>(k);
    }
}

const ResistanceMemory* Resistances::find(std::int32_t contact) const noexcept {
    const auto found = std::lower_bound(
        memory.begin(), memory.end(), contact,
        [](const ResistanceMemory& a, std::int32_t wanted) { return a.contact < wanted; });
    return contact >= 0 && found != memory.end() && found->contact == contact ? &*found : nullptr;
}

/// Compute the rotation g of a contact in this step, and the reference orientation that measures
/// it.
void Resistances::recall_turn(std::size_t index, std::int32_t previous, const ContactRow& contact,
                              const model::Bodies& bodies) noexcept {
    ResistanceMemory& m = next_[index];
    const ResistanceMemory* last = find(previous);
    m = last != nullptr ? *last : ResistanceMemory{0, 1, {}, {}, {}};
    m.contact = rows[index].contact;
    const std::int32_t side0 = contact.slot[0].body, side1 = contact.slot[1].body;
    const M3 frame = load9(&bodies.r[9 * at(side0)]);
    const Q between = conjugate(load4(&bodies.q[4 * at(side0)])) * load4(&bodies.q[4 * at(side1)]);
    V3 g = load3(m.turned);
    if (m.renewed == 0) {
        const Q since = between * conjugate(load4(m.reference));
        const bool far = norm(since.v) > 0.5 * kMaxReferenceAngle * std::fabs(since.w);
        if (far)
            m.renewed = 1;
        else
            g = frame * ((2.0 / since.w) * since.v);
    }
    if (m.renewed != 0) {
        const Q reference = conjugate(turn_by(tmul(frame, g))) * between;
        m.reference[0] = reference.w;
        store3(m.reference + 1, reference.v);
        m.renewed = 0;
    }
    store3(rows[index].gap, load9(contact.axis) * g);
}

void Resistances::recall(const base::Array<ContactRow>& contacts) noexcept {
    for (std::size_t k = 0; k < laws.size(); ++k)
        store3(laws[k].lambda, load9(contacts[at(rows[k].contact)].axis) * load3(next_[k].lambda));
}

void Resistances::scatter(const base::Array<ContactRow>& contacts, const double* x,
                          double* solution, const std::int32_t* offset) const noexcept {
    for (std::size_t k = 0; k < laws.size(); ++k) {
        const ContactRow& contact = contacts[at(rows[k].contact)];
        const V3 torque = tmul(load9(contact.axis), load3(x + 3 * k));
        for (int i = 0; i < 2; ++i) {
            const ContactSlot& s = contact.slot[i];
            if (s.dof == 6) add3(solution + offset[s.body] + 3, s.weight * torque);
        }
    }
}

void Resistances::collect(const base::Array<ContactRow>& contacts, const double* solution,
                          const std::int32_t* offset, double* u) const noexcept {
    for (std::size_t k = 0; k < laws.size(); ++k) {
        const ContactRow& contact = contacts[at(rows[k].contact)];
        V3 sum{0, 0, 0};
        for (int i = 0; i < 2; ++i) {
            const ContactSlot& s = contact.slot[i];
            if (s.dof == 6) sum = sum + s.weight * load3(solution + offset[s.body] + 3);
        }
        store3(u + 3 * k, load9(contact.axis) * sum);
    }
}

void Resistances::remember(const base::Array<ContactRow>& contacts, double h) noexcept {
    for (std::size_t k = 0; k < laws.size(); ++k) {
        const Resistance& a = laws[k];
        const ResistanceRow& row = rows[k];
        ResistanceMemory& m = next_[k];
        const M3 e = load9(contacts[at(row.contact)].axis);
        const bool part[3] = {a.torsional > 0.0, a.rolling > 0.0, a.rolling > 0.0};
        const Touch touch[3] = {a.spins, a.rolls, a.rolls};
        double g[3] = {};
        for (int i = 0; i < 3; ++i) {
            if (!part[i]) continue;
            if (touch[i] == Touch::stick) {
                g[i] = row.gap[i] + h * a.u[i];
                continue;
            }
            m.renewed = 1;
            if (touch[i] == Touch::slip) g[i] = -row.epsilon / h * a.lambda[i];
        }
        store3(m.turned, tmul(e, V3{g[0], g[1], g[2]}));
        store3(m.lambda, tmul(e, load3(a.lambda)));
    }
    memory.swap(next_);
}

std::size_t Resistances::bytes() const noexcept {
    using base::bytes;
    return bytes(rows) + bytes(laws) + bytes(memory) + bytes(next_);
}

}  // namespace hawser::assembly
