// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file field_reader.h
/// Read the members of a definition by its table (hawser/fields.h).

#include <hawser/fields.h>

#include "scene/description.h"

#include <numbers>
#include <string>
#include <type_traits>
#include <variant>

namespace hawser::scene {

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

/// Set the members that a JSON object defines, except members with a special reader (kOwnReader).
template <class Def, class Rows>
void read_fields(Def& def, const Json& json, const Rows& rows) {
    for (const FieldInfo<Def>& row : rows)
        if (const auto value = json.find(row.key); value != json.end() && !row.is(kOwnReader))
            read_field(def, row, *value);
}

}  // namespace hawser::scene
