// SPDX-License-Identifier: Apache-2.0
#include "coupling_stiffness.h"

#include "linear/timing.h"
#include "verify/coupling.h"

#include <hawser/experimental/splits.h>

#include <algorithm>

namespace hawser::bench::split {
namespace {

/// Return a world in the same state in which the cut interactions are stiffer by a factor.
World stiffened(const World& from, const std::vector<InteractionId>& cuts, double factor,
                const std::vector<Coupling>& coupling) {
    World out(from.settings());
    for (std::int32_t b = 0; b < from.body_count(); ++b) out.add_body(from.body_def(BodyId{b}));
    for (std::int32_t m = 1; m < from.material_count(); ++m)
        out.add_material(from.material_def(MaterialId{m}));
    for (const MaterialPairDef& pair : from.material_pairs()) out.add_material_pair(pair);
    for (std::int32_t s = 0; s < from.shape_count(); ++s) out.add_shape(from.shape_def(ShapeId{s}));
    for (std::int32_t i = 0; i < from.interaction_count(); ++i) {
        InteractionDef d = from.interaction_def(InteractionId{i});
        if (std::find(cuts.begin(), cuts.end(), InteractionId{i}) != cuts.end())
            for (double& compliance : d.compliance) compliance /= factor;
        out.add_interaction(d);
    }
    for (std::int32_t i = 0; i < from.input_count(); ++i) out.add_input(from.input_def(InputId{i}));
    for (std::size_t i = 0; i < coupling.size(); ++i)
        if (out.splits().coupling(InteractionId{static_cast<std::int32_t>(i)}) != coupling[i])
            out.splits().set_coupling(InteractionId{static_cast<std::int32_t>(i)}, coupling[i]);
    out.state().copy_from(from);
    return out;
}

}  // namespace

Stiffness largest_stable(const World& world, const std::vector<InteractionId>& cuts,
                         double seconds) {
    std::vector<Coupling> coupling;
    for (std::int32_t i = 0; i < world.interaction_count(); ++i)
        coupling.push_back(world.splits().coupling(InteractionId{i}));
    const double start = thread_seconds();
    auto stable = [&](double exponent) {
        const World w = stiffened(world, cuts, std::pow(10.0, exponent), coupling);
        return verify::spectral_radius(w) <= kGrowth;
    };
    double low = -8.0, high = 2.0;
    if (stable(high)) return {std::pow(10.0, high), 0.0};
    if (!stable(low)) return {0.0, std::pow(10.0, low)};
    while (high - low > 0.1 && thread_seconds() - start < seconds) {
        const double middle = 0.5 * (low + high);
        (stable(middle) ? low : high) = middle;
    }
    return {std::pow(10.0, low), std::pow(10.0, high)};
}

}  // namespace hawser::bench::split
