// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file guide_on_off.h
/// Guides that are added and removed during the run: a wire on a bollard (hawser/post.h), the eye
/// of a chaser (hawser/chaser.h).

#include "wire/guide_system.h"

#include <memory>

namespace hawser::wire {

/// Return a guide system to which no wire belongs yet.
/// @param def  Values that apply to all wires of the guide.
[[nodiscard]] std::unique_ptr<GuideSystem> guide_without_wire(GuideDef def);

/// Engage def.element with a guide. Its mass is divided between the parts on both sides, except the
/// mass that nodes keep.
/// @param speed  Speed of the wire through the guide, from its first end [m/s].
/// @return null if it was rejected and nothing has changed.
/// @throws std::bad_alloc, but not again when the step is retried.
[[nodiscard]] std::unique_ptr<GuideSystem> engage_guide(NodeEdits& nodes, GuideDef def,
                                                        double speed);

/// Join both parts of a guide to one element, lifted_element() (lift.h). A long element is divided
/// by a node. The system of the guide must not refer to the parts any more.
/// @param made  Out, unless null: the element.
/// @return false if it was rejected.
[[nodiscard]] bool disengage_guide(NodeEdits& nodes, const GuideSystem& guide,
                                   const InteractionDef& element, InteractionId* made = nullptr);

}  // namespace hawser::wire
