// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file lay_on.h
/// A guide's element is divided (hawser/guide.h), for guides and for posts.

#include <hawser/guide.h>

#include <array>

namespace hawser::wire {

/// Slide, parts and friction of a guide, all or nothing but for memory that ends. @param def  What
/// was left to defaults is filled in. @param speed  Of the wire running through [m/s]. @param
/// material  Of the parts [m]. @throws DefError
[[nodiscard]] Guide lay_on(World& world, GuideDef& def, double speed,
                           std::array<double, 2>& material);
/// The force of its friction beside that of the angle.
InputId add_stop(World& world, const GuideDef& def, const Guide& guide);

}  // namespace hawser::wire
