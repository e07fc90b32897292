// SPDX-License-Identifier: Apache-2.0
#include "solve/contact_rows.h"

#include "context/sweeps.h"

namespace hawser::solve {

void update_slots(context::Model& model, runtime::Pool& pool, const double* v) noexcept {
    assembly::Contacts& c = model.system.contacts;
    context::over(pool, static_cast<std::int32_t>(c.count()),
                  [&](std::int32_t a, std::int32_t b) { c.update(v, a, b); });
    context::over(pool, static_cast<std::int32_t>(c.resistances.count()),
                  [&](std::int32_t a, std::int32_t b) { c.update_resistances(v, a, b); });
}

void update_contacts(context::Model& model, runtime::Pool& pool, const double* v) noexcept {
    update_slots(model, pool, v);
    assembly::Contacts& c = model.system.contacts;
    context::over(pool, static_cast<std::int32_t>(c.touched()),
                  [&](std::int32_t a, std::int32_t b) { c.gather(a, b); });
}

}  // namespace hawser::solve
