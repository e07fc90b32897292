// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file guide_on_off.h
/// Guides that are added and removed during the run: a wire on a bollard (hawser/post.h), the eye
/// of a chaser (hawser/chaser.h).

#include "wire/guide_system.h"

#include <memory>

namespace hawser::wire {

/// Return a guide without a wire.
/// @param def  Values that hold for all wires.
[[nodiscard]] std::unique_ptr<GuideSystem> bare_guide(GuideDef def);

/// Engage def.element with a guide. All of its mass is then on one side or the other, except the
/// mass that nodes keep.
/// @param speed  Speed of the wire through the guide, from its first end [m/s].
/// @return null if it was rejected and nothing has changed.
/// @throws std::bad_alloc, but not again when the step is retried.
[[nodiscard]] std::unique_ptr<GuideSystem> engage_guide(NodeEdits& nodes, GuideDef def,
                                                        double speed);

/// Join both parts to one element, lifted_element() (lift.h). Divide a long one by a node. The
/// system of the guide must no longer refer to the parts.
/// @param made  Out, unless null: the element.
/// @return false if it was rejected.
[[nodiscard]] bool disengage_guide(NodeEdits& nodes, const GuideSystem& guide,
                                   const InteractionDef& element, InteractionId* made = nullptr);

}  // namespace hawser::wire
