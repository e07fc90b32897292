// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file cost_study.h
/// Accuracy with which costs known before a factorisation predict its time.

#include <nlohmann/json_fwd.hpp>

#include <string>

namespace hawser::bench {

/// Compare costs with the measured time of a factorisation on one thread. The costs are the paper's
/// c, its form in flops, exact flops, and the vertex weights that METIS balances. The cases are
/// islands of scenes, of the paper's matrix at many sizes, of nets, stars and random graphs.
/// @param picture  SVG to write, empty: none.
nlohmann::json cost_study(const std::string& picture);

}  // namespace hawser::bench
