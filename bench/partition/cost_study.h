// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file cost_study.h
/// Accuracy of costs known before a factorisation as predictions of its time.

#include <nlohmann/json_fwd.hpp>

#include <string>

namespace hawser::bench {

/// Compare costs with the measured time of a factorisation on one thread. Costs: the paper's c, its
/// form in flops, exact flops, and the vertex weights that METIS balances. Cases: islands of
/// scenes, the paper's matrix at many sizes, nets, stars and random graphs. @param picture  SVG to
/// write; empty: none.
nlohmann::json cost_study(const std::string& picture);

}  // namespace hawser::bench
