// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file checks.h
/// Errors of definitions, with the reason and the remedy.

#include <hawser/def.h>
#include <hawser/interactions.h>
#include <hawser/shapes.h>

#include "model/bodies.h"

#include <span>
#include <string>
#include <vector>

namespace hawser::world {

/// Subject of an error message. The text is built only if a definition is rejected. The arguments
/// must outlive this object.
class Where {
  public:
    /// Name a subject: "body 'bob'" or "body (unnamed)".
    Where(const char* what, const std::string& name) noexcept : kind_(what), name_(&name) {}
    /// Use a ready text.
    Where(const std::string& text) noexcept : name_(&text) {}
    [[nodiscard]] std::string text() const;

  private:
    const char* kind_ = nullptr;
    const std::string* name_;
};

/// Reject a definition.
/// @throws DefError with the subject and a reason.
[[noreturn]] void throw_def_error(const Where& where, const std::string& what);

/// Check that the free end of an element has a mass.
/// @param mass  Mass of its end [kg].
/// @param carried  Mass of the wire that a drum has paid out [kg]; negative: it has hauled in more.
/// @throws DefError
void check_end(const std::string& where, double mass, double carried);

/// Check the settings of a world.
/// @throws DefError
void check(const WorldDef& def);
/// Check a body.
/// @throws DefError
void check(const BodyDef& def);
/// Check bodies, points, frames and row constants of an interaction.
/// @param count  Number of user bodies.
/// @param before  User interactions.
/// @param places  Their index table.
/// @throws DefError
void check(const InteractionDef& def, const model::Bodies& bodies, int count,
           std::span<const InteractionDef> before, const base::Slots& slots);
/// Check a load of `def` against the interaction whose force it uses.
/// @throws DefError
void check_load(const InteractionDef& def, const FrictionLoad& load, const InteractionDef& other);
/// Check parameters after defaults have been filled in.
/// @throws DefError
void check_params(const InteractionDef& def);
/// Check a material.
/// @param method  Some methods lack some resistances.
/// @throws DefError
void check(const MaterialDef& def, Nonsmooth method);
/// Check a pair of materials.
/// @param materials  Number of existing materials.
/// @throws DefError
void check(const MaterialPairDef& def, int materials, Nonsmooth method);
/// Check a shape.
/// @throws DefError
void check(const ShapeDef& def, const model::Bodies& bodies, int count, int materials);

/// Check later changes against the ranges of a definition.
/// @throws DefError
void check_pose(const Where& where, const Vec3& position, const Quat& orientation);
void check_velocity(const Where& where, const Vec3& linear, const Vec3& angular);
void check_force(const Where& where, const Vec3& force, const Vec3& torque);

/// Return the error message for a kind without coordinate or motor. It lists the kinds that have
/// one.
[[nodiscard]] std::string no_coordinate(const KindInfo& kind);
[[nodiscard]] std::string no_motor(const KindInfo& kind);

/// Format a number for messages, as short as possible (1e+300 would have 301 digits).
[[nodiscard]] std::string number(double value);
/// Return "body 'bob'" or "body (unnamed)" for messages.
[[nodiscard]] std::string label(const char* what, const std::string& name);

}  // namespace hawser::world
