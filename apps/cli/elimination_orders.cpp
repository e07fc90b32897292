// SPDX-License-Identifier: Apache-2.0
#include "elimination_orders.h"

#if HAWSER_HAVE_METIS
#include <metis.h>
#endif

#include <numeric>
#include <stdexcept>

namespace hawser::cli {
namespace {

#if HAWSER_HAVE_METIS
std::vector<std::int32_t> nested_dissection(const BlockPattern& pattern) {
    const std::size_t nodes = pattern.size.size();
    std::vector<std::vector<idx_t>> near(nodes);
    for (const BlockEdge& e : pattern.edges) {
        near[static_cast<std::size_t>(e.row)].push_back(e.column);
        near[static_cast<std::size_t>(e.column)].push_back(e.row);
    }
    std::vector<idx_t> start{0}, adjacent, order(nodes), place(nodes);
    for (const auto& list : near) {
        adjacent.insert(adjacent.end(), list.begin(), list.end());
        start.push_back(static_cast<idx_t>(adjacent.size()));
    }
    auto n = static_cast<idx_t>(nodes);
    idx_t options[METIS_NOPTIONS];
    METIS_SetDefaultOptions(options);
    options[METIS_OPTION_SEED] = 1;
    if (METIS_NodeND(&n, start.data(), adjacent.data(), nullptr, options, order.data(),
                     place.data()) != METIS_OK)
        throw std::runtime_error("METIS_NodeND failed");
    return {order.begin(), order.end()};
}
#else
std::vector<std::int32_t> nested_dissection(const BlockPattern&) {
    throw std::runtime_error("built without METIS; install libmetis-dev and build again");
}
#endif

}  // namespace

const char* name_of(Ordering ordering) {
    switch (ordering) {
        case Ordering::natural:
            return "natural";
        case Ordering::amd:
            return "AMD";
        case Ordering::metis:
            return "METIS";
    }
    return "?";
}

bool metis_available() { return HAWSER_HAVE_METIS != 0; }

std::vector<std::int32_t> elimination_order(const BlockPattern& pattern, Ordering ordering) {
    if (ordering == Ordering::amd) return minimum_degree_order(pattern);
    std::vector<std::int32_t> order(pattern.size.size());
    std::iota(order.begin(), order.end(), 0);
    if (ordering == Ordering::metis && order.size() > 1) order = nested_dissection(pattern);
    rows_after_bodies(pattern, order);
    return order;
}

}  // namespace hawser::cli
