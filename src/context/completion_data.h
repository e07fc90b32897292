// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file completion_data.h
/// Joints that hold at the end of a step (completion.h).

#include <cstdint>
#include <vector>

namespace hawser::context {

/// Offsets of the impulse and the record of a joint.
struct JointSlot {
    std::int32_t row;  ///< Its first row; its force is that of three rows, or fewer.
    /// Offset of the vibration rate in the record of a compact joint, else −1.
    std::int32_t record;
    std::int32_t rows;  ///< Number of rows of its force.
};

/// Joint data of the analysis, and the choice of the present step.
struct Completion {
    std::vector<std::int32_t> joints;    ///< Interactions that may be completed, ascending.
    std::vector<JointSlot> joint_slots;  ///< One per joint.
    std::vector<std::int32_t> rigid;     ///< Rigid joints among these, ascending.
    std::vector<std::int32_t> looped;    ///< Rigid joints in closed loops of rigid joints.
    std::vector<std::uint8_t>
        coarse_next;                    ///< model::Interactions::coarse after the step, by joint.
    std::vector<std::uint8_t> refused;  ///< By joint, 1: not completed in the present step.
    /// By row: forces from which the stiffness of joints is computed.
    std::vector<double> lambda_with;
    bool any = false;            ///< True if the step completes some joints.
    bool any_compliant = false;  ///< True if the step completes some compliant joints.
    bool banned = false;         ///< True if the step is being solved again without completion.
};

}  // namespace hawser::context
