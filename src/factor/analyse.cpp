// SPDX-License-Identifier: Apache-2.0
#include "factor/analyse.h"

#include "factor/columns.h"
#include "factor/layout.h"

#include <utility>

namespace hawser::factor {

Symbolic analyse(const Pattern& pattern, std::vector<std::int32_t> order) {
    return analyse(pattern, Elimination{std::move(order), {}});
}

Symbolic analyse(const Pattern& pattern, Elimination plan) {
    Symbolic s;
    s.order = std::move(plan.order);
    s.position.resize(s.order.size());
    for (std::size_t k = 0; k < s.order.size(); ++k)
        s.position[static_cast<std::size_t>(s.order[k])] = static_cast<std::int32_t>(k);
    Columns columns;
    columns.build(pattern, s.order, s.position);
    Layout().run(pattern, columns, plan.chains, s);
    return s;
}

}  // namespace hawser::factor
