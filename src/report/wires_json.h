// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file wires_json.h
/// Figures of wires in `--summary` (docs/cli.md).

#include "report/wires.h"

#include <nlohmann/json_fwd.hpp>

#include <vector>

namespace hawser::report {

[[nodiscard]] nlohmann::ordered_json broken_json(const std::vector<BrokenWire>& all);
[[nodiscard]] nlohmann::ordered_json wires_json(const std::vector<WireFigures>& wires);

}  // namespace hawser::report
