// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file material_fields.h
/// Table of the members of MaterialDef, except its name (fields.h). Scenes, documents, checks,
/// recordings and the identity of saved states read it.

#include <hawser/fields.h>
#include <hawser/shapes.h>

#include <array>

namespace hawser {

/// Table of the members, in the order of recordings and of the identity. Recordings store every
/// member, so that a new member needs a new ChangeKind (record/change_fields.h).
inline constexpr auto kMaterialFields = std::to_array<FieldInfo<MaterialDef>>(
    {{"friction", &MaterialDef::friction, "1", "0.5", "Coulomb coefficient.", 0.0, 100.0,
      "a coefficient", kInIdentity},
     {"restitution", &MaterialDef::restitution, "1", "0",
      "Fraction of the speed of an impact that is kept after it.", 0.0, 1.0, "a fraction",
      kInIdentity},
     {"stiffness", &MaterialDef::stiffness, "N/m", "1e8",
      "Stiffness of one contact point, normal to the surface.", 1.0, 1e12, "a stiffness",
      kInIdentity},
     {"tangential", &MaterialDef::tangential, "1", "0.7",
      "Tangential over normal stiffness while sticking.", 0.01, 10.0, "a ratio", kInIdentity},
     {"damping_time", &MaterialDef::damping_time, "s", "two steps", "Damping time of the contact.",
      0.0, 1e3, "a time", kInIdentity},
     {"rolling", &MaterialDef::rolling, "m", "0", "Rolling resistance: moment over normal force.",
      0.0, 10.0, "a length", kInIdentity},
     {"torsional", &MaterialDef::torsional, "m", "0",
      "Resistance to spinning about the normal: moment over normal force.", 0.0, 10.0, "a length",
      kInIdentity}});

}  // namespace hawser
