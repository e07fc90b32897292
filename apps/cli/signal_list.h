// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file signal_list.h
/// Inputs and outputs of a scene, as `check` and `inspect` list them.

#include <hawser/world.h>

#include <nlohmann/json_fwd.hpp>

#include <string>

namespace hawser::cli {

/// Return one line for each signal, inputs first. Columns are name, unit, and the target with its
/// range (inputs) or the source (outputs).
[[nodiscard]] std::string signal_lines(const World& world);

/// Return {"inputs": [{name, unit, min, max, value, sets}], "outputs": [{name, unit, kind,
/// component}]}
[[nodiscard]] nlohmann::ordered_json signal_report(const World& world);

}  // namespace hawser::cli
