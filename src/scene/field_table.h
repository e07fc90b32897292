// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file field_table.h
/// Read and describe the members of a definition by its table (hawser/fields.h).

#include <hawser/fields.h>

#include "scene/description.h"
#include "scene/format.h"

#include <cstdint>
#include <numbers>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

namespace hawser::scene {

/// Return the shape of a number of a row.
template <class Def>
[[nodiscard]] ShapePtr number_of_field(const FieldInfo<Def>& row) {
    if (row.above_least() && row.least == 0.0) return make::positive(row.what, row.most);
    return make::number(row.what, row.least, row.most);
}

/// Return the shape of the value of a row whose reader is not its own (kOwnReader).
template <class Def>
[[nodiscard]] ShapePtr shape_of_field(const FieldInfo<Def>& row) {
    return std::visit(
        [&]<class T>(T Def::*) -> ShapePtr {
            if constexpr (std::is_same_v<T, double>) {
                return number_of_field(row);
            } else if constexpr (std::is_same_v<T, bool>) {
                return make::boolean("true or false");
            } else if constexpr (std::is_integral_v<T>) {
                return make::integer(row.what, row.least, row.most);
            } else if constexpr (std::is_same_v<T, std::string>) {
                return make::text(row.what);
            } else {
                if (!row.is(kPerAxis)) return make::vector3(row.what);
                const ShapePtr one = number_of_field(row);
                const std::string what = row.what;
                return make::choice(what + ", or [x, y, z] of them",
                                    {one, make::list("three numbers [x, y, z]", one, 3, 3)});
            }
        },
        row.member);
}

/// Return the field of a row.
template <class Def>
[[nodiscard]] Field field_of(const FieldInfo<Def>& row, ShapePtr shape) {
    return {row.key, std::move(shape), row.required(), row.fallback, row.unit, row.doc};
}

/// Append the fields of a table.
template <class Rows>
void add_fields(std::vector<Field>& to, const Rows& rows) {
    for (const auto& row : rows) to.push_back(field_of(row, shape_of_field(row)));
}

/// Set the member of a row from its value in a scene.
template <class Def>
void read_field(Def& def, const FieldInfo<Def>& row, const Json& value) {
    constexpr double kDegree = std::numbers::pi / 180.0;
    std::visit(
        [&]<class T>(T Def::* member) {
            if constexpr (std::is_same_v<T, double>)
                def.*member = value.get<double>() * (row.degrees() ? kDegree : 1.0);
            else if constexpr (std::is_same_v<T, Vec3>)
                def.*member =
                    value.is_array() ? vector_of(value) : Vec3(Vec3::Constant(value.get<double>()));
            else if constexpr (std::is_arithmetic_v<T> || std::is_same_v<T, std::string>)
                def.*member = value.get<T>();
        },
        row.member);
}

/// Set the members that an object gives, except those with a reader of their own (kOwnReader).
template <class Def, class Rows>
void read_fields(Def& def, const Json& json, const Rows& rows) {
    for (const FieldInfo<Def>& row : rows)
        if (const auto value = json.find(row.key); value != json.end() && !row.is(kOwnReader))
            read_field(def, row, *value);
}

}  // namespace hawser::scene
