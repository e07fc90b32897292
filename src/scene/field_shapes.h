// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file field_shapes.h
/// Describe the members of a definition in the format by its table (hawser/fields.h).

#include <hawser/fields.h>

#include "scene/make_shape.h"

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
[[nodiscard]] Field field_from_row(const FieldInfo<Def>& row, ShapePtr shape) {
    return {row.key, std::move(shape), row.required(), row.fallback, row.unit, row.doc};
}

/// Append the fields of a table.
template <class Rows>
void add_fields(std::vector<Field>& to, const Rows& rows) {
    for (const auto& row : rows) to.push_back(field_from_row(row, shape_of_field(row)));
}

}  // namespace hawser::scene
