// SPDX-License-Identifier: Apache-2.0
/// Layout of Jacobians and geometric terms, and their lookup by body.
#include "assembly/system.h"
#include "base/index.h"
#include "model/arms.h"

#include <algorithm>

namespace hawser::assembly {
namespace {

/// Return |r|/I of one body of an interaction, where I is the mean moment of inertia across its arm
/// r (geo.h).
double arm_rate(const model::Bodies& bodies, const model::Interactions& in, int id, int b) {
    const std::int32_t body = in.body[at(kMaxInteractionBodies * id + b)];
    const Vec3& arm = in.def[at(id)].point[at(b)];
    const double length = arm.norm();
    if (bodies.dof(body) != 6 || length == 0.0) return 0.0;
    const Eigen::Map<const Mat3> inertia(&bodies.inertia[at(9 * body)]);
    const double along = arm.dot(inertia * arm) / (length * length);
    return 2.0 * length / (inertia.trace() - along);
}

/// Return the larger rate of the two bodies of a joint; 0 unless both turn.
double vibration_rate(const model::Bodies& bodies, const model::Interactions& in, int id) {
    for (int b = 0; b < 2; ++b)
        if (bodies.dof(in.body[at(kMaxInteractionBodies * id + b)]) != 6) return 0.0;
    return std::max(arm_rate(bodies, in, id, 0), arm_rate(bodies, in, id, 1));
}

/// Return the oscillation rate of a joint or rod, see model::Interactions::vibration: about the
/// centres of mass of its bodies. A rod between point masses also oscillates transversely, with
/// 1/(l m).
double vibration_of(const model::Bodies& bodies, const model::Interactions& in, int id) {
    const KindInfo& kind = kind_info(in.kinds[at(id)]);
    // A sliding joint has no fixed arm on which a force acts.
    if (kind.is(kSlides)) return 0.0;
    double rate = std::max(arm_rate(bodies, in, id, 0), arm_rate(bodies, in, id, 1));
    if (!kind.is(kAlongLine) || kind.is(kElastic)) return rate;
    const double length = in.def[at(id)].params[0];
    for (int b = 0; b < 2; ++b) {
        const std::int32_t body = in.body[at(kMaxInteractionBodies * id + b)];
        if (bodies.dof(body) == 3) rate = std::max(rate, 1.0 / (length * bodies.mass[at(body)]));
    }
    return rate;
}

}  // namespace

void System::lay_out_rows(const model::Bodies& bodies, model::Interactions& in) {
    // Vector loads read up to seven entries past the end.
    constexpr std::size_t kSlack = 8;
    geo_slot_.assign(at(in.count()), {});
    std::int32_t record = 0, force = 0, jacobian = 0;
    // Compact Jacobians come first, one per cache line.
    for (int i = 0; i < in.count(); ++i) {
        const std::int32_t* body = &in.body[at(kMaxInteractionBodies * i)];
        const bool compact = kind_info(in.kinds[at(i)]).is(kCompact) && !rests(i) &&
                             dof_[at(body[0])] == 6 && dof_[at(body[1])] == 6;
        in.arms[at(i)] = compact ? model::kCompactJacobian : 0;
        if (!compact) continue;
        in.jac_begin[at(i)] = jacobian;
        jacobian += model::kArms;
        geo_slot_[at(i)] = {-1, force, 0};
        force += 6;
    }
    for (int i = 0; i < in.count(); ++i) {
        if (in.arms[at(i)]) continue;
        const std::int32_t* body = &in.body[at(kMaxInteractionBodies * i)];
        in.jac_begin[at(i)] = jacobian;
        for (int b = 0; b < in.bodies[at(i)]; ++b) jacobian += in.rows[at(i)] * dof_[at(body[b])];
        if (in.geo[at(i)] < 0 || rests(i)) continue;
        auto is_point = [&](std::int32_t b) { return dof_[at(b)] == 3 || dof_[at(b)] == 1; };
        const bool points = is_point(body[0]) && is_point(body[1]);
        geo_slot_[at(i)] = {record, force, points ? 3 : 6};
        record += points ? kGeoLine : kGeoSize;
        force += points ? 6 : 24;
    }
    among_nodes_.assign(at(in.count()), 0);
    for (int i = 0; i < in.count(); ++i) {
        auto is_far_node = [&](std::int32_t b) {
            constexpr int kReach = 3;  // vector loads of x and v end before this many more
            return dof_[at(b)] == 3 && b + kReach <= bodies.count() &&
                   bodies.dof_begin[at(b)] + static_cast<int>(kSlack) <= bodies.dofs;
        };
        const std::int32_t* body = &in.body[at(kMaxInteractionBodies * i)];
        const bool placed = !in.gone(i) && (in.geo[at(i)] < 0 || geo_slot_[at(i)].record >= 0);
        among_nodes_[at(i)] = placed && std::all_of(body, body + in.bodies[at(i)], is_far_node);
    }
    place_masses(in);
    in.jacobian.assign(at(jacobian) + kSlack, 0.0);
    geo_record_.assign(at(record) + kSlack, 0.0);
    geo_force_.assign(at(force) + kSlack, 0.0);
    for (int i = 0; i < in.count(); ++i) {
        in.vibration[at(i)] = model::may_ever_complete(in, i) ? vibration_of(bodies, in, i) : 0.0;
        const GeoSlot& place = geo_slot_[at(i)];
        if (in.arms[at(i)])
            in.jacobian[at(in.jac_begin[at(i)] + model::kArmsVibration)] =
                vibration_rate(bodies, in, i);
        else if (place.dof == 6 && place.record >= 0)
            geo_record_[at(place.record + kGeoVibration)] = vibration_rate(bodies, in, i);
    }
}

/// Find the elements between point masses whose consistent mass is in their geometric terms. The
/// masses of all other elements are lumped at the point masses.
void System::place_masses(const model::Interactions& in) {
    pair_mass_.clear();
    if (!consistent_mass) return;
    const auto counts = [&](std::size_t i) {
        const std::int32_t* body = &in.body[kMaxInteractionBodies * i];
        return in.pair_mass[i] > 0.0 && geo_slot_[i].record >= 0 && dof_[at(body[0])] == 3 &&
               dof_[at(body[1])] == 3;
    };
    for (std::size_t i = 0; i < at(in.count()); ++i) {
        if (!counts(i)) continue;
        if (pair_mass_.empty()) pair_mass_.assign(at(in.count()), 0.0);
        pair_mass_[i] = in.pair_mass[i];
    }
}

void System::build_incidence(const model::Bodies& bodies, const model::Interactions& in) {
    incident_begin_.assign(at(bodies.count()) + 1, 0);
    for (int i = 0; i < in.count(); ++i)
        for (int b = 0; b < in.bodies[at(i)]; ++b)
            ++incident_begin_[at(in.body[at(kMaxInteractionBodies * i + b)]) + 1];
    for (int b = 0; b < bodies.count(); ++b) incident_begin_[at(b) + 1] += incident_begin_[at(b)];
    incident_.resize(at(incident_begin_.back()));
    incident_of_.resize(incident_.size());
    cursor_.assign(incident_begin_.begin(), incident_begin_.end() - 1);
    for (int i = 0; i < in.count(); ++i) {
        const std::int32_t* body = &in.body[at(kMaxInteractionBodies * i)];
        int width = 0;
        for (int b = 0; b < in.bodies[at(i)]; ++b) width += dof_[at(body[b])];
        std::int32_t column = in.jac_begin[at(i)];
        for (int b = 0; b < in.bodies[at(i)]; ++b) {
            const bool geo = in.geo[at(i)] >= 0 && b < 2;
            const GeoSlot& place = geo_slot_[at(i)];
            const std::int32_t k = cursor_[at(body[b])]++;
            Incidence& incidence = incident_[at(k)];
            incident_of_[at(k)] = i;
            const std::uint8_t rows = rests(i) ? std::uint8_t{0} : in.rows[at(i)];
            incidence = {column,
                         in.row_begin[at(i)],
                         -1,
                         -1,
                         rows,
                         static_cast<std::uint8_t>(width),
                         static_cast<std::uint8_t>(b)};
            if (in.arms[at(i)]) {
                incidence.jacobian = in.jac_begin[at(i)] + 3 * b;
                incidence.width = 0;
                incidence.geo_force = place.force;
                incidence.geo_arm = i;
                continue;
            }
            if (geo && !rests(i)) incidence.geo_force = place.slot(b);
            if (geo && !rests(i) && place.dof == 6) incidence.geo_arm = place.record + 10 + 6 * b;
            column += dof_[at(body[b])];
        }
    }
    find_links(bodies);
}

void System::find_links(const model::Bodies& bodies) {
    constexpr int kMaximum = 255;
    links_.assign(at(bodies.count()), 0);
    auto joint = [&](int body, int k) -> const Incidence& {
        return incident_[at(incident_begin_[at(body)] + k)];
    };
    for (int b = bodies.count(); b-- > 0;) {
        if (dof_[at(b)] != 6 || incident_begin_[at(b) + 1] - incident_begin_[at(b)] != 2) continue;
        const Incidence &in = joint(b, 0), &out = joint(b, 1);
        if (in.rows != 3 || in.width != 0 || in.slot != 1 || out.rows != 3 || out.width != 0 ||
            out.slot != 0 || out.row != in.row + 3 || out.jacobian != in.jacobian + 5 ||
            out.geo_force != in.geo_force + 6)
            continue;
        const bool goes_on = b + 1 < bodies.count() && links_[at(b) + 1] > 0 &&
                             joint(b + 1, 0).row == out.row &&
                             bodies.dof_begin[at(b) + 1] == bodies.dof_begin[at(b)] + 6;
        links_[at(b)] =
            static_cast<std::uint8_t>(goes_on ? std::min(kMaximum, links_[at(b) + 1] + 1) : 1);
    }
}

}  // namespace hawser::assembly
