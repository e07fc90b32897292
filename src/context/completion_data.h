// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file completion_data.h
/// Which joints hold at the end of a step (completion.h).

#include <cstdint>
#include <vector>

namespace hawser::stepper {

/// Where a joint's impulse and record are.
struct JointPlace {
    std::int32_t row;     ///< Its first row; its force is that of three rows, or of fewer.
    std::int32_t record;  ///< Its swing number's constant in a compact joint's record, else −1.
    std::int32_t rows;    ///< Of its force.
};

/// What the analysis knows of joints, and what the step being taken chose.
struct Completion {
    std::vector<std::int32_t> joints;  ///< Interactions that may be completed, ascending.
    std::vector<JointPlace> places;    ///< One a joint.
    std::vector<std::int32_t> rigid;   ///< Of these, those that give by nothing, ascending.
    std::vector<std::int32_t> looped;  ///< Of the rigid ones, those in closed loops of them.
    std::vector<std::uint8_t>
        coarse_next;                    ///< model::Interactions::coarse after the step, a joint.
    std::vector<std::uint8_t> refused;  ///< 1 a joint: the step being taken does without it.
    std::vector<double> lambda_with;  ///< By row: of whose forces the joints have their stiffness.
    bool any = false;                 ///< The step completes some.
    bool banned = false;              ///< The step is being solved again without.
};

}  // namespace hawser::stepper
