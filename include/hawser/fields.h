// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file fields.h
/// Tables that describe the members of definitions such as BodyDef.
///
/// A table has one row (FieldInfo) for each member: key in scene files, pointer to the member,
/// unit, default, range and description. Its readers are the reader of scenes, the JSON Schema, the
/// reference page, the checks of a world, recordings and the identity of saved states. A new member
/// therefore needs one row. Tables: hawser/body_fields.h, hawser/material_fields.h, and src/scene
/// for definitions of systems.

#include <hawser/math.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <type_traits>
#include <variant>

namespace hawser {

/// Pointer to a member of a definition, of one of the permitted types.
template <class Def>
using FieldMember =
    std::variant<double Def::*, Vec3 Def::*, bool Def::*, int Def::*, std::uint64_t Def::*,
                 Quat Def::*, Mat3 Def::*, std::string Def::*>;

/// Properties of a member, as bits of FieldInfo::traits.
enum FieldTrait : std::uint8_t {
    kMayBeMissing = 1,  ///< Scenes may omit the key although `fallback` is empty.
    kAboveLeast = 2,    ///< The value `least` itself is rejected.
    kPerAxis = 4,       ///< Scenes give one number for all axes, or three numbers.
    kOwnReader = 8,     ///< The scene reader has separate code for the key and its description.
    kInIdentity = 16,   ///< Worlds with different values reject each other's saved states.
    kLeastToo = 32,     ///< The value may be `least`, also if the key is required and `least` is 0.
};

/// Description of a member of a definition. Ranges apply to each component of a vector.
///
/// An empty `fallback` makes the key required. A required key with `least` 0 excludes 0. A key that
/// ends in "_deg" is in degrees here and in scenes, and in radians in the definition.
template <class Def>
struct FieldInfo {
    const char* key = "";       ///< Key in scene files; also the name in messages.
    FieldMember<Def> member{};  ///< Member that the key sets.
    const char* unit = "";      ///< SI unit, or degrees; "": none, "1": a ratio.
    const char* fallback = "";  ///< Default in words; "": required.
    const char* doc = "";       ///< Description, one or two sentences.
    double least = -std::numeric_limits<double>::infinity();  ///< Least value [unit].
    double most = std::numeric_limits<double>::infinity();    ///< Largest value [unit].
    const char* what = "a number";                            ///< Noun for messages: "a length".
    unsigned traits = 0;                                      ///< Bits of FieldTrait.
    /// Kinds of bodies for which the key has no meaning: bits bit_of(kind), body_fields.h.
    unsigned without = 0;

    /// True if the member has a property.
    [[nodiscard]] constexpr bool is(FieldTrait trait) const noexcept {
        return (traits & trait) != 0;
    }
    /// True if scenes must give the key.
    [[nodiscard]] constexpr bool required() const noexcept {
        return *fallback == '\0' && !is(kMayBeMissing);
    }
    /// True if the value `least` is rejected.
    [[nodiscard]] constexpr bool above_least() const noexcept {
        return is(kAboveLeast) || (required() && least == 0.0 && !is(kLeastToo));
    }
    /// True if scenes give the value in degrees.
    [[nodiscard]] constexpr bool degrees() const noexcept {
        return std::string_view(key).ends_with("_deg");
    }
};

/// True if two values of a member are equal. Numbers that are both NaN count as equal.
template <class T>
[[nodiscard]] bool same_value(const T& a, const T& b) {
    if constexpr (std::is_same_v<T, double>)
        return a == b || (std::isnan(a) && std::isnan(b));
    else if constexpr (std::is_same_v<T, Quat>)
        return a.coeffs() == b.coeffs();
    else
        return a == b;
}

/// True if a member of `def` has its default value, that of Def{}.
template <class Def>
[[nodiscard]] bool has_default(const Def& def, const FieldInfo<Def>& row) {
    static const Def kUsual{};
    return std::visit([&](auto member) { return same_value(def.*member, kUsual.*member); },
                      row.member);
}

}  // namespace hawser
