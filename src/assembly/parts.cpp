// SPDX-License-Identifier: Apache-2.0
#include "assembly/parts.h"

#include "base/index.h"
#include "model/arms.h"

#include <algorithm>
#include <cmath>

namespace hawser::assembly {
namespace {

/// Maximum number of interactions of a body with a row that may be cut. A link of a wire has fewer:
/// two joints, three bending, two twist.
constexpr std::int32_t kMaxOfLink = 8;
constexpr double kReferenceSpeed = 0.1;       // v₀ [m/s]
constexpr double kReferenceViolation = 0.01;  // g₀ [m]
constexpr double kMeanFraction = 0.01;        // fraction of the mean row force in F

}  // namespace

std::int32_t thousandths(double weight) noexcept {
    constexpr double kMaxThousandths = 1e6;
    if (!(weight < kMaxThousandths / 1000.0)) return static_cast<std::int32_t>(kMaxThousandths);
    return weight > 0.0 ? static_cast<std::int32_t>(std::lround(1000.0 * weight)) : 0;
}

void PartGraph::build(const model::Bodies& bodies, std::int32_t body_count,
                      const model::Interactions& in, std::int32_t interaction_count,
                      std::span<const Contacts::Link> links) {
    const auto n = at(body_count);
    size.resize(n);
    for (int b = 0; b < body_count; ++b)
        size[at(b)] = static_cast<std::uint8_t>(bodies.asleep[at(b)] ? 0 : bodies.dof(b));
    begin.assign(1, 0);
    members.clear();
    degree_.assign(n, 0);
    for (int i = 0; i < interaction_count; ++i) {
        for (int b = 0; b < in.bodies[at(i)]; ++b) {
            const std::int32_t body = in.body[at(kMaxInteractionBodies * i + b)];
            members.push_back(body);
            ++degree_[at(body)];
        }
        begin.push_back(static_cast<std::int32_t>(members.size()));
    }
    for (const Contacts::Link& l : links) {
        members.insert(members.end(), {l.first, l.second});
        begin.push_back(static_cast<std::int32_t>(members.size()));
    }
    whole_.assign(begin.size() - 1, 1);
    for (int i = 0; i < interaction_count; ++i) {
        if (!kind_info(in.def[at(i)].kind).is(kOfWires)) continue;
        bool same = true;
        std::uint8_t first = 0;
        for (std::int32_t k = begin[at(i)]; k < begin[at(i) + 1]; ++k) {
            const std::size_t b = at(members[at(k)]);
            if (size[b] == 0) continue;
            same &= degree_[b] <= kMaxOfLink && (first == 0 || size[b] == first);
            first = size[b];
        }
        whole_[at(i)] = same ? 0 : 1;
    }
    edge_weight.assign(whole_.size(), 0);
    for (std::size_t e = 0; e < whole_.size(); ++e)
        if (whole_[e]) edge_weight[e] = graph::kNeverCut;
    node_weight.assign(n, 0);
    repair_weight.assign(whole_.size(), 0);
    net_force.assign(n, 0.0);
    speed.assign(at(interaction_count), 0.0);
    violation.assign(at(interaction_count), 0.0);
}

void PartGraph::keep_whole(std::int32_t i) noexcept {
    whole_[at(i)] = 1;
    edge_weight[at(i)] = graph::kNeverCut;
}

void PartGraph::add_contact_weight(std::int32_t body) noexcept {
    std::int32_t& w = node_weight[at(body)];
    if (size[at(body)] > 0 && w < kTouchWeight) w += kTouchWeight;
}

void PartGraph::compute_weights(const model::Bodies& bodies, const model::Interactions& in,
                                std::span<const std::int32_t> cut, const WorldDef& def) {
    net_.assign(3 * size.size(), 0.0);
    double squares = 0.0;
    int rows = 0;
    for (std::size_t k = 0; k < speed.size(); ++k) {
        const auto i = static_cast<std::int32_t>(k);
        rows += in.rows[k];
        const std::int32_t* body = &in.body[at(kMaxInteractionBodies * i)];
        int width = 0;
        bool rests = false;
        for (int b = 0; b < in.bodies[at(i)]; ++b) {
            width += size[at(body[b])];
            rests |= bodies.asleep[at(body[b])] != 0;
        }
        if (rests || in.jacobian.empty()) continue;
        double sum = 0.0, off = 0.0;
        double buffer[model::kArmBufferSize];
        const double* packed =
            model::packed_rows(&in.jacobian[at(in.jac_begin[at(i)])], in.arms[at(i)] != 0, buffer);
        for (int r = 0; r < in.rows[at(i)]; ++r) {
            const std::size_t row = at(in.row_begin[at(i)] + r);
            const double* jac = packed + static_cast<std::ptrdiff_t>(r) * width;
            const double lambda = in.lambda[row];
            double rate = 0.0;
            for (int b = 0; b < in.bodies[at(i)]; ++b) {
                const std::size_t id = at(body[b]);
                const int dof = size[id];
                const double* v = dof > 0 ? &bodies.v[at(bodies.dof_begin[id])] : nullptr;
                for (int j = 0; j < dof; ++j) rate += jac[j] * v[j];
                for (int j = 0; j < dof && j < 3; ++j) net_[3 * id + at(j)] += jac[j] * lambda;
                jac += dof;
            }
            sum += std::abs(rate);
            squares += lambda * lambda;
            if ((in.row_flags[row] & model::kRowVelocity) == 0) off += std::abs(in.g[row]);
        }
        speed[at(i)] = sum;
        violation[at(i)] = off;
        const bool is_cut = std::binary_search(cut.begin(), cut.end(), i);
        const std::int32_t displaced = thousandths(off / kReferenceViolation);
        if (is_cut) repair_weight[at(i)] = displaced;
        if (!whole_[at(i)])
            edge_weight[at(i)] = thousandths(sum / kReferenceSpeed) + (is_cut ? 0 : displaced);
    }
    const double per_h = 1.0 / def.step;
    const double mean = rows > 0 ? per_h * std::sqrt(squares / rows) : 0.0;
    const double gravity = def.gravity.norm();
    for (std::size_t b = 0; b < size.size(); ++b) {
        if (size[b] == 0) continue;
        const double* p = &net_[3 * b];
        net_force[b] = per_h * std::sqrt(p[0] * p[0] + p[1] * p[1] + p[2] * p[2]);
        const double usual = bodies.mass[b] * gravity + kMeanFraction * mean + 1e-300;
        node_weight[b] = thousandths(net_force[b] / usual);
    }
}

}  // namespace hawser::assembly
