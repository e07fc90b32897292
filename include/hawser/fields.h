// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file fields.h
/// Rows of the tables of definitions: one row for each member. The reader of scenes, the JSON
/// Schema, the reference page, the checks of a world, recordings and the identity of saved states
/// read the properties of a member here.
///
/// Tables: hawser/body_fields.h, hawser/material_fields.h, and src/scene for definitions of
/// systems.

#include <hawser/math.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <type_traits>
#include <variant>

namespace hawser {

/// Pointer to a member of a definition.
template <class Def>
using FieldMember =
    std::variant<double Def::*, Vec3 Def::*, bool Def::*, int Def::*, std::uint64_t Def::*,
                 Quat Def::*, Mat3 Def::*, std::string Def::*>;

/// Properties of a row, as bits of FieldInfo::traits.
enum FieldTrait : std::uint8_t {
    kMayBeMissing = 1,  ///< Scenes may leave it out although `fallback` is empty.
    kAboveLeast = 2,    ///< The value `least` itself is rejected.
    kPerAxis = 4,       ///< Scenes give one number for all axes, or three.
    kOwnReader = 8,     ///< Scenes read and describe it by code of their own.
    kInIdentity = 16,   ///< Worlds with different values reject each other's saved states.
    kLeastToo = 32,     ///< A required value may be 0.
};

/// Member of a definition. Ranges apply to each component of a vector.
///
/// A row without a default in words is required, and then a range from 0 excludes 0. A key that
/// ends in "_deg" is in degrees here and in scenes, and in radians in the definition.
template <class Def>
struct FieldInfo {
    const char* key = "";       ///< Key in scene files; also the name in messages.
    FieldMember<Def> member{};  ///< Member that it sets.
    const char* unit = "";      ///< SI unit, or degrees; "": none, "1": a ratio.
    const char* fallback = "";  ///< Default in words; "": required.
    const char* doc = "";       ///< Description, one or two sentences.
    double least = -std::numeric_limits<double>::infinity();  ///< Least value [unit].
    double most = std::numeric_limits<double>::infinity();    ///< Largest value [unit].
    const char* what = "a number";                            ///< Noun for messages.
    unsigned traits = 0;                                      ///< Bits of FieldTrait.
    /// Bits 1 << kind of the kinds for which the key has no meaning (bodies).
    unsigned without = 0;

    /// True if the row has a property.
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

/// True if two values of a member are equal. NaN equals NaN.
template <class T>
[[nodiscard]] bool same_value(const T& a, const T& b) {
    if constexpr (std::is_same_v<T, double>)
        return a == b || (std::isnan(a) && std::isnan(b));
    else if constexpr (std::is_same_v<T, Quat>)
        return a.coeffs() == b.coeffs();
    else
        return a == b;
}

/// True if a definition has the default value of a member.
template <class Def>
[[nodiscard]] bool has_default(const Def& def, const FieldInfo<Def>& row) {
    static const Def kUsual{};
    return std::visit([&](auto member) { return same_value(def.*member, kUsual.*member); },
                      row.member);
}

}  // namespace hawser
