// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file line_types.h
/// Read the line types of a cable.

#include <hawser/fields.h>

#include "scene/cable_parts.h"
#include "scene/format.h"

namespace hawser::scene {

/// Members of a line type that sections of a cable have. The rest of a line type follows in
/// kLayoutFields.
inline constexpr auto kSectionFields = std::to_array<FieldInfo<CableSection>>(
    {{"mass_per_length", &CableSection::mass_per_length, "kg/m", "",
      "Mass per length; the buoyancy of water is not subtracted.", 0.0, 1e9, "a mass per length"},
     {"EA", &CableSection::EA, "N", "", "Axial stiffness; needed by cables of lumps.", 0.0,
      kMaxForce, "a stiffness", kMayBeMissing | kAboveLeast},
     {"EI", &CableSection::EI, "N m^2", "0",
      "Bending stiffness; 0: perfectly flexible. Cables of links bend freely.", 0.0, kMaxForce,
      "a stiffness"},
     {"diameter", &CableSection::diameter, "m", "",
      "Diameter for pictures and for forces of the water.", 0.0, 1e3, "a length",
      kMayBeMissing | kAboveLeast},
     {"breaking_load", &CableSection::breaking_load, "N", "never",
      "An element breaks above this tension.", 0.0, kMaxForce, "a force", kAboveLeast},
     {"link", &CableSection::link, "m", "it is no chain",
      "Pitch of a link of chain: elements of lumps have a whole number of links each, and no EI.",
      0.0, 100.0, "a length", kAboveLeast}});
inline constexpr auto kLayoutFields = std::to_array<FieldInfo<LayoutSection>>(
    {{"axial_damping", &LayoutSection::axial_damping, "1", "two steps of damping time",
      "Fraction of critical of the highest axial mode of an element.", 0.0, 10.0, "a fraction"},
     {"drag", &LayoutSection::drag, "N s/m^2", "0", "Linear drag per length.", 0.0, kMaxDamping,
      "a damping per length"},
     {"submerged_factor", &LayoutSection::submerged_factor, "1", "1",
      "Weight in water divided by weight in air.", -1.0, 1.0, "a factor"}});

/// Read "line_type" or "sections": all properties of the sections except the lengths of elements.
/// @throws SceneError.
void read_line_types(CableLayout& c, const Json& cable, const Document& document,
                     const SourceLocation& location);

/// Read the water coefficients of a line type or a rod, except the diameter. Missing keys keep the
/// defaults.
void read_line_water(const Json& json, LineWater& water);

/// Compute the lengths of all elements from the length of the cable.
void measure_elements(CableLayout& c) noexcept;

/// True if a length is a whole number of links, up to the decimals of a file.
[[nodiscard]] bool rounded_to_links(double length, double link) noexcept;

/// Check that each element between nodes of a chain has a whole number of links. @throws
/// SceneError.
void check_links(const CableLayout& c, const Json& cable, const SourceLocation& location);

}  // namespace hawser::scene
