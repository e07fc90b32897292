// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file cable_starts.h
/// With what tension the cables of a scene start.

#include "record/scene_info.h"

#include <hawser/hawser.h>

#include <string>
#include <vector>

namespace hawser::report::start {

/// Of one cable. Elements of lumps pull by how they are stretched; the joints of links by a step
/// from rest (start_forces.h), known to the size and not to the third digit.
struct CableStart {
    std::string name;
    bool known = false;          ///< What follows is; of links it may not be.
    double first = 0.0;          ///< Tension of the element at the first end [N].
    double last = 0.0;           ///< And at the last end [N].
    double largest = 0.0;        ///< Of all elements [N].
    std::string where;           ///< The element or joint that has it; "" where all are slack.
    double breaking_load = 0.0;  ///< [N]; 0: not given.
    /// Material coordinates between which it lies on its seabed [m]; NaN: it does not.
    double laid_from = kDefault, laid_to = kDefault;
};

/// In the order of the scene. @throws std::bad_alloc.
[[nodiscard]] std::vector<CableStart> cable_starts(const record::SceneInfo& scene,
                                                   const World& world);

/// A line each in words; of more than `most` those with the largest tensions, and how many more.
[[nodiscard]] std::string to_text(const std::vector<CableStart>& starts, std::size_t most);

}  // namespace hawser::report::start
