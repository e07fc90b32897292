// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file format.h
/// Scene format version 1 as shapes. The keys of an interaction come from the table of kinds
/// (hawser/interactions.h), all others from format.cpp.

#include <hawser/settings.h>

#include "scene/make_shape.h"
#include "scene/section_list.h"
#include "scene/shape.h"

#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace hawser::scene {

/// Latest version of the format. Version 2: the cable key "winch" feeds elements; in version 1 the
/// cable keeps the one element at its drum.
inline constexpr int kFormatVersion = 2;
inline constexpr int kMaxCopies = 1000;
inline constexpr std::size_t kMaxGroups = 32;  ///< Collision groups, "default" included.
inline constexpr int kMaxIncludeDepth = 8;
inline constexpr int kMaxInstanceDepth = 8;
// Limits that detect a wrong unit or a damaged digit; far beyond marine values.
inline constexpr double kMostMass = 1e15;
inline constexpr double kMostLength = 1e6;
inline constexpr double kMaxForce = 1e15;
inline constexpr double kMaxDamping = 1e18;

struct Format {
    ShapePtr scene;  ///< A whole scene file.
    ShapePtr part;   ///< A file that is included.
    ShapePtr state;  ///< A state file.

    ShapePtr operations;  ///< Shape of a timeline, in the scene or in a file of its own.
    ShapePtr line_type;
    std::vector<ShapePtr> lists;  ///< Shapes of list_formats(), in their order.

    /// Return the shape of the list with this key of list_formats().
    [[nodiscard]] const ShapePtr& list(std::string_view key) const;
};

/// Format of a list of a scene and of a template (section_list.h).
struct ListFormat {
    const char* key;      ///< Key of the list.
    const char* entries;  ///< Entries in words.
    const char* doc;
    ShapePtr (*shape)();  ///< Shape of an entry.
};
/// Return all lists, in the order of the reference page.
[[nodiscard]] std::span<const ListFormat> list_formats();
// Shapes of the entries.
#define HAWSER_LIST_SHAPE(key, item, entries, doc) [[nodiscard]] ShapePtr item##_shape();
HAWSER_SCENE_LISTS(HAWSER_LIST_SHAPE)
HAWSER_SCENE_SECTIONS(HAWSER_LIST_SHAPE)
#undef HAWSER_LIST_SHAPE

[[nodiscard]] const Format& format();
/// Return the keys of the outermost object of a scene, a part and a state.
[[nodiscard]] const std::set<std::string>& outermost_keys();

/// Return the shape of the settings of a simulation. See format_settings.cpp.
[[nodiscard]] ShapePtr settings_shape();
/// Return the largest value of a setting in a scene if it is less than the limit of a world.
[[nodiscard]] double largest_scene_value(const SettingInfo& setting);

/// Return the shape of a line type. See format_cables.cpp.
[[nodiscard]] ShapePtr line_type_shape();
/// Return the shape of a load that the hook of a crane may carry. See format_cranes.cpp.
[[nodiscard]] ShapePtr crane_load_shape();
/// Return the shape of the control of a vessel. See format_vessel_control.cpp.
[[nodiscard]] ShapePtr vessel_control_shape();
/// Return the shapes of the data of a ship for DNV-ST-0111, and of a file of them. See
/// format_dp_ship.cpp.
[[nodiscard]] ShapePtr dp_ship_shape();
[[nodiscard]] ShapePtr dp_file_shape();
/// Return the shape of the sea. See format_sea.cpp.
[[nodiscard]] ShapePtr sea_shape();
/// Return the shape of an entry of "hulls" (format_hulls.cpp).
[[nodiscard]] ShapePtr water_hull_shape();
[[nodiscard]] std::vector<Field> line_water_fields();

/// Return the shape of an operation at a given time. See format_timeline.cpp.
[[nodiscard]] ShapePtr operation_shape();

/// Return the shapes (JSON forms) of a shape of a body, a material, a pair of materials, and the
/// contact of a cable. See format_shapes.cpp.
[[nodiscard]] std::vector<Field> surface_fields();  ///< Material and groups of a shape.
[[nodiscard]] ShapePtr shape_of_body();
[[nodiscard]] ShapePtr material();
[[nodiscard]] ShapePtr material_pair();
[[nodiscard]] ShapePtr cable_contact();

/// @return true for a parameter whose default is computed from the pose of the bodies in the scene.
///        Examples are the distance of two points, the height of a ship, and the coordinate of a
///        drum.
[[nodiscard]] bool is_taken_from_pose(const KindInfo& kind, std::string_view param);

}  // namespace hawser::scene
