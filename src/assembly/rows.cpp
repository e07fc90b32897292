// SPDX-License-Identifier: Apache-2.0
#include "assembly/rows.h"

namespace hawser::assembly {

double row_speed(const assembly::View& v, std::int32_t id) noexcept {
    double buffer[model::kArmBufferSize];
    const double* jac = packed_rows(v, id, buffer);
    return along_row(v, id, jac, v.v_new, v.dof_begin);
}

}  // namespace hawser::assembly
