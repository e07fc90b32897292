// SPDX-License-Identifier: Apache-2.0
/// Compute the coordinates of kinds: the angle of hinge_row(), the travel of travel_row(), the
/// first coordinate of a scalar body.
#define HAWSER_KIND_SETUP
#include "base/index.h"
#include "model/interactions.h"
#include "model/kinds/all.h"

#include <cstring>
#include <type_traits>

namespace hawser::model {
namespace {

/// Return the points and frames in the data of a kind; null if the kind has none.
template <class Data>
const generic::JointData* joint_in(const Data& data) {
    if constexpr (std::is_same_v<Data, generic::JointData>)
        return &data;
    else if constexpr (requires { data.joint; })
        return &data.joint;
    else
        return nullptr;
}

}  // namespace

Coordinate Interactions::coordinate(int id, const Bodies& b) const noexcept {
    Coordinate out;
    const InteractionKind kind = def[at(id)].kind;
    const KindCoordinate which = kind_info(kind).coordinate;
    const std::int32_t* of = &body[at(kMaxInteractionBodies * id)];
    if (which == KindCoordinate::none) return out;
    if (which == KindCoordinate::scalar) {
        out.value = b.x[3 * at(of[0])];
        out.rate = b.v[at(b.dof_begin[at(of[0])])];
        if (kind_info(kind).bodies == 2) {  // coordinate of the second body minus that of the first
            out.value = b.x[3 * at(of[1])] - out.value;
            out.rate = b.v[at(b.dof_begin[at(of[1])])] - out.rate;
        }
        return out;
    }
    generic::BodyRef refs[2];
    for (int k = 0; k < 2; ++k) {
        const double* x = &b.x[3 * at(of[k])];
        refs[k] = {{x[0], x[1], x[2]}, &b.r[9 * at(of[k])], b.dof(of[k]) == 6 || b.dof(of[k]) == 0};
    }
    generic::Rows<2, 1> row{};
    const Pool& p = pool[static_cast<std::size_t>(kind)];
    const std::byte* bytes = p.data.data() + at(pool_index[at(id)]) * p.stride;
    generic::with_kind(kind, [&]<class K>() {
        typename K::Data data;
        std::memcpy(&data, bytes, sizeof data);
        if (const generic::JointData* joint = joint_in(data); joint != nullptr) {
            if (which == KindCoordinate::about)
                generic::kinds::hinge_row(*joint, refs, row);
            else
                generic::kinds::travel_row(*joint, refs, row);
        }
    });
    out.value = row.g[0];
    for (int k = 0; k < 2; ++k) {
        const int dof = b.dof(of[k]);
        const double* v = dof > 0 ? &b.v[at(b.dof_begin[at(of[k])])] : &b.v_fixed[6 * at(of[k])];
        for (int j = 0; j < (dof > 0 ? dof : 6); ++j) out.rate += row.J[k][0][j] * v[j];
    }
    return out;
}

}  // namespace hawser::model
