// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file guide_on_off.h
/// Guides that come and go while the world runs: what a wire lies on as long as it lies on a post
/// (hawser/post.h), the eye of a chaser (hawser/chaser.h).

#include "wire/guide_system.h"

#include <memory>

namespace hawser::wire {

/// One that no wire lies on. @param def  What is the same for all wires.
[[nodiscard]] std::unique_ptr<GuideSystem> bare_guide(GuideDef def);

/// Lays def.element over a guide. All of its mass is on one side or the other from then on, but for
/// what lumps keep. @param speed  Of the wire running through, from its first end [m/s].
/// @return null: it was refused, and nothing has changed. @throws std::bad_alloc, which a step that
/// is tried again does not meet.
[[nodiscard]] std::unique_ptr<GuideSystem> lay_on_guide(NodeEdits& nodes, GuideDef def,
                                                        double speed);

/// Makes one element of both parts, lifted_element() (lift.h); a long one is divided by a node. The
/// system that has the guide may not hold the parts any more. @param made  Out, unless null: the
/// element. @return false: it was refused.
[[nodiscard]] bool lift_off_guide(NodeEdits& nodes, const GuideSystem& guide,
                                  const InteractionDef& element, InteractionId* made = nullptr);

}  // namespace hawser::wire
