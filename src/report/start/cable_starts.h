// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file cable_starts.h
/// Compute the tensions with which the cables of a scene start.

#include "record/scene_info.h"

#include <hawser/hawser.h>

#include <string>
#include <vector>

namespace hawser::report::start {

/// Tensions of one cable at the start. Elements between nodes pull by their stretch. Joints of
/// links pull by a step from rest (start_forces.h), which gives the magnitude of the force, not
/// three digits.
struct CableStart {
    std::string name;
    bool known = false;  ///< True if the following values are valid; they may be invalid for links.
    double first = 0.0;  ///< Tension of the element at the first end [N].
    double last = 0.0;   ///< Tension at the last end [N].
    double largest = 0.0;  ///< Largest tension of all elements [N].
    std::string where;     ///< Element or joint with the largest tension; "" if all are slack.
    double breaking_load = 0.0;  ///< Breaking load [N]; 0: unspecified.
    /// Material coordinates of the part on its seabed [m]; NaN: no such part.
    double laid_from = kDefault, laid_to = kDefault;
};

/// Return the tensions of all cables in the order of the scene. @throws std::bad_alloc.
[[nodiscard]] std::vector<CableStart> cable_starts(const record::SceneInfo& scene,
                                                   const World& world);

/// Return one line of text for each cable, for at most `most` cables. If there are more, return
/// those with the largest tensions and the number of the others.
[[nodiscard]] std::string to_text(const std::vector<CableStart>& starts, std::size_t most);

}  // namespace hawser::report::start
