// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file impl.h
/// What a World owns.

#include <hawser/world.h>

#include "stepper/sleep.h"
#include "stepper/step.h"
#include "world/lookup.h"

#include <string>
#include <vector>

namespace hawser {

struct World::Impl {
    explicit Impl(const WorldDef& def) : ctx(def), material_names{{"default", 0}} {}

    stepper::StepContext ctx;
    std::vector<BodyDef> body_defs;
    /// BodyDef::group, in order of use; "" is none.
    world::Names groups;
    [[nodiscard]] std::int32_t number_of_group(const std::string& name);
    std::vector<ShapeDef> shape_defs;
    std::vector<InputDef> inputs;
    std::vector<double> input_values;
    world::Names body_names, interaction_names, input_names, material_names, shape_names;

    void apply_input(std::size_t index, double value);
    /// What acts at present where an input does: its value, unless something else set it since.
    [[nodiscard]] double applied(const InputDef& input) const;
    /// What an input acts on wakes.
    void disturb(const InputDef& input) noexcept;
};

}  // namespace hawser
