// SPDX-License-Identifier: Apache-2.0
/// Parts of random block patterns: no block joins two parts.
#include "assembly/pattern_parts.h"
#include "factor/analyse.h"
#include "factor/ordering.h"
#include "graph/hypergraph.h"
#include "support/random.h"
#include "support/tier.h"

#include <gtest/gtest.h>

namespace hawser::test {
namespace {

TEST(PatternParts, NoBlockJoinsTwoParts) {
    for (const std::uint32_t seed : seeds(1, 100, 500, 5000)) {
        SCOPED_TRACE(seed);
        Random random(seed);
        const int bodies = random.integer(1, 80), rows = random.integer(0, 120);
        std::vector<std::int8_t> size, sign;
        std::vector<std::int32_t> from, to;
        for (int v = 0; v < bodies + rows; ++v) {
            size.push_back(static_cast<std::int8_t>(random.integer(1, 6)));
            sign.push_back(v < bodies ? 1 : -1);
            // Bodies couple to bodies of nearby index, rows to two or three of these.
            const int centre = v < bodies ? v : random.integer(0, bodies - 1);
            for (int k = v < bodies ? random.integer(0, 1) : random.integer(1, 3); k > 0; --k) {
                from.push_back(v);
                to.push_back(std::min(bodies - 1, centre + random.integer(0, 3)));
            }
        }
        const factor::Pattern pattern = factor::make_pattern(size, sign, from, to);
        const factor::Symbolic known = factor::analyse(pattern, factor::order_nodes(pattern));
        const int parts = random.integer(1, 5);
        for (const factor::Symbolic* exact :
             {static_cast<const factor::Symbolic*>(nullptr), &known}) {
            const std::vector<std::int32_t> part = assembly::pattern_parts(pattern, exact, parts);
            for (int v = 0; v < pattern.nodes(); ++v) {
                const std::int32_t p = part[static_cast<std::size_t>(v)];
                ASSERT_TRUE(p == graph::kSeparator || (p >= 0 && p < parts));
                for (const std::int32_t u : pattern.neighbours(v)) {
                    const std::int32_t q = part[static_cast<std::size_t>(u)];
                    ASSERT_TRUE(p < 0 || q < 0 || p == q) << v << " " << u;
                }
            }
        }
    }
}

}  // namespace
}  // namespace hawser::test
