// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file checks.h
/// What a world refuses, with the reason and the remedy.

#include <hawser/def.h>
#include <hawser/interactions.h>
#include <hawser/shapes.h>

#include "model/bodies.h"

#include <span>
#include <string>
#include <vector>

namespace hawser::world {

/// Whom a message is about: put into words only where something is refused. What it was made of
/// must live as long.
class Where {
  public:
    /// "body 'bob'" or "body (unnamed)".
    Where(const char* what, const std::string& name) noexcept : what_(what), name_(&name) {}
    /// In words already.
    Where(const std::string& text) noexcept : name_(&text) {}
    [[nodiscard]] std::string text() const;

  private:
    const char* what_ = nullptr;
    const std::string* name_;
};

/// Refuses `where` with a reason. @throws DefError
[[noreturn]] void refuse(const Where& where, const std::string& what);

/// Whether what an element leaves free has a mass. @param mass  Of its end [kg]. @param carried  Of
/// what a drum has paid out [kg]; below 0: it has hauled in more. @throws DefError
void check_end(const std::string& where, double mass, double carried);

/// @throws DefError
void check(const WorldDef& def);
/// @throws DefError
void check(const BodyDef& def);
/// Checks bodies, points, frames and row constants. @param count  Bodies of the user.
/// @param before  Interactions of the user. @param places  Theirs. @throws DefError
void check(const InteractionDef& def, const model::Bodies& bodies, int count,
           std::span<const InteractionDef> before, const base::Places& places);
/// Checks a load of `def` by what it is the force of. @throws DefError
void check_load(const InteractionDef& def, const FrictionLoad& load, const InteractionDef& other);
/// Checks parameters once defaults have been filled in. @throws DefError
void check_params(const InteractionDef& def);
/// @param method  Not all of them have every resistance. @throws DefError
void check(const MaterialDef& def, Nonsmooth method);
/// @param materials  That there are. @throws DefError
void check(const MaterialPairDef& def, int materials, Nonsmooth method);
/// @throws DefError
void check(const ShapeDef& def, const model::Bodies& bodies, int count, int materials);

/// The ranges of a definition for what changes later. @throws DefError
void check_pose(const Where& where, const Vec3& position, const Quat& orientation);
void check_velocity(const Where& where, const Vec3& linear, const Vec3& angular);
void check_force(const Where& where, const Vec3& force, const Vec3& torque);

/// Why a kind has none, and which have.
[[nodiscard]] std::string no_coordinate(const KindInfo& kind);
[[nodiscard]] std::string no_motor(const KindInfo& kind);

/// For messages: as short as it may be, 1e+300 has 301 digits else.
[[nodiscard]] std::string number(double value);
/// "body 'bob'" or "body (unnamed)" for messages.
[[nodiscard]] std::string label(const char* what, const std::string& name);

}  // namespace hawser::world
