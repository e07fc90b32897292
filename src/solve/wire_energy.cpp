// SPDX-License-Identifier: Apache-2.0
#include "solve/wire_energy.h"

#include "base/index.h"
#include "context/view.h"
#include "context/wires_data.h"

#include <algorithm>
#include <cmath>
#include <span>

namespace hawser::solve {
namespace {

using assembly::View;

/// Value of h² T/(l m) of an element up to which its wire is not checked: a transverse wave passes
/// a seventh of an element in a step. Beyond ¼ the step damps its vibration (assembly/geo.h). An
/// element that becomes taut may gain energy below that.
constexpr double kResolvedRatio = 0.02;

bool is_fast(const context::Model& model, const context::Before& kept, const View& v,
             std::int32_t id) noexcept {
    const double rest = v.rest_length[id];
    const double length = rest > 0.0 ? rest : model.interactions.def[at(id)].params[0];
    const double impulse = std::max(-v.lambda[v.row_begin[id]], -kept.lambda[at(v.row_begin[id])]);
    return v.h * impulse * v.lightness[id] > kResolvedRatio * length;
}

/// Return Σ ½ m |v₊² − v²| of the nodes [begin, end): the kinetic energy that they exchange in the
/// step [J].
double kinetic_exchange(const context::Model& model, const View& v, std::int32_t begin,
                        std::int32_t end) noexcept {
    double sum = 0.0;
    for (std::int32_t i = begin; i < end; ++i) {
        const std::int32_t body = model.wires.lump[at(i)];
        const double *a = v.v + v.dof_begin[body], *b = v.v_new + v.dof_begin[body];
        double change = 0.0;
        for (int k = 0; k < 3; ++k) change += (b[k] - a[k]) * (b[k] + a[k]);
        sum += 0.5 * v.mass[body] * std::fabs(change);
    }
    return sum;
}

}  // namespace

bool may_touch(const context::Model& model, std::int32_t wire) noexcept {
    const std::span<const std::int32_t> touching = model.system.contacts.touching();
    if (touching.empty()) return false;
    for (const context::WirePart& p : model.wires.parts) {
        if (p.wire != wire) continue;
        for (std::int32_t i = p.node_elements_begin; i < p.node_elements_end; ++i)
            if (std::binary_search(touching.begin(), touching.end(), model.wires.lump[at(i)]))
                return true;
    }
    return false;
}

bool find_fast_wires(context::Model& model, const context::Before& kept) noexcept {
    context::Wires& w = model.wires;
    const View v = context::row_view(model);
    bool any = false;
    for (const context::WirePart& p : w.parts) {
        std::uint8_t& fast = w.fast[at(p.wire)];
        for (std::int32_t i = p.element_begin; i < p.element_end && !fast; ++i)
            fast = is_fast(model, kept, v, w.element[at(i)]) ? 1 : 0;
        any |= fast != 0;
    }
    return any;
}

void measure_wires(context::Model& model, runtime::Pool& pool) noexcept {
    context::Wires& w = model.wires;
    const View v = context::row_view(model);
    auto part = [&](int i, int) noexcept {
        const context::WirePart& p = w.parts[at(i)];
        if (!w.fast[at(p.wire)]) return;
        assembly::LineGain sum;
        assembly::kernels().line_gains(v, w.element.data() + p.element_begin,
                                       p.element_end - p.element_begin, &sum);
        sum.exchanged += kinetic_exchange(model, v, p.node_elements_begin, p.node_elements_end);
        w.part_gain[at(i)] = {sum.gain, sum.exchanged, sum.noise, sum.unbooked};
    };
    pool.for_each(static_cast<int>(w.parts.size()), part);
    std::fill(w.gain.begin(), w.gain.end(), context::WireGain{});
    for (std::size_t i = 0; i < w.parts.size(); ++i) {
        if (!w.fast[at(w.parts[i].wire)]) continue;
        context::WireGain& g = w.gain[at(w.parts[i].wire)];
        g.gain += w.part_gain[i].gain;
        g.exchanged += w.part_gain[i].exchanged;
        g.noise += w.part_gain[i].noise;
        g.unbooked += w.part_gain[i].unbooked;
    }
    // Leave out the part along the rows, which the energy account counts as damped.
    for (std::size_t k = 0; k < w.count(); ++k)
        if (w.fast[k] && may_touch(model, static_cast<std::int32_t>(k)))
            w.gain[k].gain = -w.gain[k].unbooked;
}

}  // namespace hawser::solve
