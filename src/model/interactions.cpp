// SPDX-License-Identifier: Apache-2.0
#define HAWSER_KIND_SETUP
#include "model/interactions.h"

#include "model/kinds/all.h"

#include <cmath>
#include <cstring>

namespace hawser::model {
namespace {

/// Write the Data of `def` at `out` (stride bytes).
void write_data(const InteractionDef& def, std::byte* out) {
    generic::with_kind(def.kind, [&]<class K>() {
        const typename K::Data data = K::make(def);
        std::memcpy(out, &data, sizeof data);
    });
}

}  // namespace

void complete(InteractionDef& def, const Vec3* positions, double distance) {
    const KindInfo& info = kind_info(def.kind);
    for (std::size_t i = 0; i < info.params.size(); ++i) {
        if (!std::isnan(def.params[i])) continue;
        if (info.length_from_pose && std::string_view(info.params[i].name) == "length")
            def.params[i] = distance;
        else
            def.params[i] = info.params[i].fallback;
    }
    generic::with_kind(def.kind, [&]<class K>() {
        if constexpr (requires { K::complete(def, positions); }) K::complete(def, positions);
    });
}

int Interactions::add(const InteractionDef& filled, const Bodies& bodies_in, double h) {
    const int id = count();
    const KindInfo& info = kind_info(filled.kind);
    def.push_back(filled);
    InteractionDef& d = def.back();

    generic::RowSpec spec[kMaxInteractionRows];
    std::size_t stride = 0;
    generic::Geometry geometry = generic::Geometry::none;
    generic::with_kind(d.kind, [&]<class K>() {
        K::defaults(d, h, spec);
        stride = sizeof(typename K::Data);
        static_assert(sizeof(typename K::Data) % sizeof(double) == 0);
        geometry = K::kGeometry;
    });

    Pool& p = pool[static_cast<std::size_t>(d.kind)];
    p.stride = stride;
    pool_index.push_back(static_cast<std::int32_t>(p.ids.size()));
    p.ids.push_back(id);
    p.data.resize(p.ids.size() * stride);
    write_data(d, p.data.data() + (p.ids.size() - 1) * stride);

    int width = 0;
    for (int b = 0; b < kMaxInteractionBodies; ++b) {
        const bool used = b < info.bodies;
        const std::int32_t index = used ? d.body[static_cast<std::size_t>(b)].index : -1;
        body.push_back(index);
        if (used) width += bodies_in.dof(index);
    }
    bodies.push_back(static_cast<std::uint8_t>(info.bodies));
    rows.push_back(static_cast<std::uint8_t>(info.rows));
    row_begin.push_back(row_count);
    jac_begin.push_back(jac_size);
    row_count += info.rows;
    jac_size += info.rows * width;

    std::uint8_t flag = 0;
    if (spec[0].one_sided) flag |= kOneSided;
    if (spec[0].range) flag |= kRange;
    if (d.kind == InteractionKind::Stretch || d.kind == InteractionKind::WinchStretch) {
        inv_length.push_back(1.0 / d.get("length"));
        if (d.get("breaking_load") < 1e30) flag |= kBreakable;
    } else {
        inv_length.push_back(0.0);
    }
    flags.push_back(flag);
    geo.push_back(geometry == generic::Geometry::none ? -1 : geo_count++);
    active.push_back(1.0);
    parted.push_back(0);

    for (int r = 0; r < info.rows; ++r) {
        const auto k = static_cast<std::size_t>(r);
        d.compliance[k] = spec[r].compliance;
        d.damping_time[k] = spec[r].damping_time;
        epsilon.push_back(spec[r].compliance);
        tau.push_back(spec[r].damping_time);
        const double ups = spec[r].velocity ? 0.0 : 1.0 / (1.0 + 4.0 * spec[r].damping_time / h);
        upsilon.push_back(ups);
        sigma.push_back(spec[r].velocity ? spec[r].compliance / h
                                         : 4.0 * spec[r].compliance * ups / (h * h));
        row_flags.push_back(static_cast<std::uint8_t>((spec[r].velocity ? kRowVelocity : 0) |
                                                      (spec[r].gap ? kRowGap : 0)));
        for (base::Array<double>* a : {&inv_sigma, &g, &c, &residual, &lambda, &multiplier, &force})
            a->push_back(0.0);
    }
    return id;
}

void Interactions::refresh(int id) {
    const InteractionDef& d = def[static_cast<std::size_t>(id)];
    Pool& p = pool[static_cast<std::size_t>(d.kind)];
    const auto index = static_cast<std::size_t>(pool_index[static_cast<std::size_t>(id)]);
    write_data(d, p.data.data() + index * p.stride);
}

std::size_t Interactions::bytes() const noexcept {
    using base::bytes;
    std::size_t total = bytes(def) + bytes(pool_index) + bytes(body) + bytes(bodies) + bytes(rows) +
                        bytes(flags) + bytes(row_begin) + bytes(jac_begin) + bytes(geo) +
                        bytes(active) + bytes(parted) + bytes(inv_length) + bytes(epsilon) +
                        bytes(tau) + bytes(upsilon) + bytes(sigma) + bytes(inv_sigma) + bytes(g) +
                        bytes(c) + bytes(residual) + bytes(lambda) + bytes(multiplier) +
                        bytes(force) + bytes(row_flags) + bytes(jacobian);
    for (const Pool& p : pool) total += bytes(p.ids) + bytes(p.data);
    return total;
}

}  // namespace hawser::model
