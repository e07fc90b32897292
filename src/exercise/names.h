// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file names.h
/// List the names of a scene that an exercise may use.

#include <hawser/exercise.h>

#include <string>
#include <utility>
#include <vector>

namespace hawser::exercise {

/// Return the names of inputs, inputs of signals, and signals of systems.
[[nodiscard]] std::vector<std::string> input_names(const scene::Scene& scene);
[[nodiscard]] std::vector<std::string> output_names(const World& world);

/// Return the target of a control, an input of the world or a signal, and the value for it. Two
/// names of one signal have equal targets.
[[nodiscard]] std::pair<std::string, double> resolve_target(const scene::Scene& scene,
                                                            std::string_view input, double value);
/// Return the present value of a target from resolve_target().
[[nodiscard]] double present_value(const World& world, const std::string& input);

/// Target of a fault, as named by resolve_target(): an input that is scaled, or the mode of a
/// winch.
struct FaultyInput {
    std::string input;
    bool mode = false;  ///< True: modes with a motor become free.
};
/// Return the inputs that a fault modifies. @param world  World in which each parameter that the
/// fault needs has an input.
[[nodiscard]] std::vector<FaultyInput> faulty_inputs(const Fault& fault, const World& world);
/// Return the parameters of an interaction that a fault changes; empty if its kind is not suitable.
[[nodiscard]] std::vector<std::string> fault_params(FaultKind kind, const World& world,
                                                    InteractionId interaction);
/// Return the input that drives a parameter of an interaction; invalid if no input drives it.
[[nodiscard]] InputId driving_input(const World& world, InteractionId interaction,
                                    const std::string& param);
[[nodiscard]] bool is_winch(const World& world, const std::string& name);

}  // namespace hawser::exercise
