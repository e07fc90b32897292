// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file names.h
/// What a scene has that an exercise may name.

#include <hawser/exercise.h>

#include <string>
#include <utility>
#include <vector>

namespace hawser::exercise {

/// Inputs, inputs of signals, and signals of systems.
[[nodiscard]] std::vector<std::string> input_names(const scene::Scene& scene);
[[nodiscard]] std::vector<std::string> output_names(const World& world);

/// What a lever really sets: an input of the world, or a signal, with its value. Two names of one
/// signal come to the same.
[[nodiscard]] std::pair<std::string, double> resolved(const scene::Scene& scene,
                                                      std::string_view input, double value);
/// Of a name that resolved() gave, now.
[[nodiscard]] double present_value(const World& world, const std::string& input);

/// Inputs that a fault bends, as resolved() has them; with what they are multiplied, or the mode
/// of a winch.
struct Bent {
    std::string input;
    bool mode = false;  ///< Modes with a motor become free.
};
/// @param world  In which each parameter that the fault needs has its input.
[[nodiscard]] std::vector<Bent> bent_inputs(const Fault& fault, const World& world);
/// Parameters of an interaction that a fault changes; empty: it is none of the right kind.
[[nodiscard]] std::vector<std::string> fault_params(FaultKind kind, const World& world,
                                                    InteractionId interaction);
/// Input that drives a parameter of an interaction; invalid: none does.
[[nodiscard]] InputId driver_of(const World& world, InteractionId interaction,
                                const std::string& param);
[[nodiscard]] bool is_winch(const World& world, const std::string& name);

}  // namespace hawser::exercise
