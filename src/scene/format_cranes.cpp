// SPDX-License-Identifier: Apache-2.0
/// Cranes on any body.
#include "scene/cranes.h"
#include "scene/field_shapes.h"
#include "scene/format.h"

#include <span>
#include <string>
#include <utility>
#include <vector>

namespace hawser::scene {
namespace {

using namespace make;

template <class T>
std::vector<Field> crane_fields() {
    using Table = CraneTable<T>;
    std::vector<Field> fields;
    add_fields(fields, Table::kNumbers);
    for (const CranePoint<T>& p : std::span(Table::kPoints).first(Table::kPointCount))
        fields.push_back({p.key, vector3("a point"), *p.fallback == '\0', p.fallback, "m", p.doc});
    return fields;
}

template <class T>
ShapePtr crane_part(const char* id, const char* what, const char* doc,
                    std::vector<Field> more = {}) {
    std::vector<Field> fields = crane_fields<T>();
    for (Field& field : more) fields.push_back(std::move(field));
    return object(id, what, doc, std::move(fields));
}

ShapePtr tackle_shape() {
    return crane_part<CraneTackle>("crane_tackle", "a tackle of a crane",
                                   "Falls between two blocks and their drum.",
                                   {{"falls", integer("a number of falls", 1, 64), true, "", "",
                                     "Number of parts of line that carry the load."}});
}

ShapePtr rating_shape() {
    return crane_part<CraneRating>(
        "crane_rating", "a rating of a crane", "Rated load by radius, and its alarms.",
        {{"curve",
          list("a list of points",
               list("a radius and a mass", number("a number", 0.0, kMaxCraneMass), 2, 2), 1, 1000),
          true, "", "m, kg", "Radii grow, rated loads do not; linear between."},
         {"cut_out", boolean("true or false"), false, "false", "",
          "In step 2 of the alarm no motion goes on that raises the moment."}});
}

/// Return the fields of cranes of all kinds, in the order of the reference.
std::vector<Field> common_fields_of_cranes(const char* kind) {
    return {
        {"kind", literal(word("the kind", {kind})), true, "", "", "The kind."},
        {"name", name("a name"), true, "", "",
         "First part of the names of all that it is made of; its signals are NAME.hoist and so "
         "on."},
        {"on", body_ref(), true, "", "", "Body on which it is mounted."},
        {"point", vector3("a point"), false, "[0, 0, 0]", "m",
         "Position of its slewing bearing, in that body's frame."},
        {"euler_deg",
         list("three angles [roll, pitch, yaw] in degrees", number("an angle", -36000, 36000), 3,
              3),
         false, "[0, 0, 0]", "deg", "Angles of the crane's frame in that body's frame."},
        {"slew", crane_part<CraneSlew>("crane_slew", "a slew drive", "Motor and brake."), true, "",
         "", "Slew drive."},
        {"column",
         crane_part<CraneColumn>("crane_column", "a column", "Slewing part without booms."), true,
         "", "", "Column."},
        {"boom", crane_part<CraneLink>("crane_link", "a boom or jib", "A boom or jib."), true, "",
         "", "Boom."},
        {"hoist", tackle_shape(), true, "", "", "Hoist."},
        {"hook",
         crane_part<CraneHook>("crane_hook", "a hook", "Hook and block, hung from the head."), true,
         "", "", "Hook."},
        {"rating", rating_shape(), false, "nothing is rated", "", "Rated loads and alarms."},
        {"loads", list("a list of loads", crane_load_shape(), 1, 1000), false, "none", "",
         "Loads that the hook can attach. The signal NAME.take is the number of a load, counted "
         "from 1."},
        {"take", body_ref(), false, "none", "", "Body of the load that is attached at the start."},
        {"description", text("a text"), false, "", "", "Source and remarks."}};
}

template <class T>
ShapePtr crane_kind(const char* kind, const char* id, const char* what, const char* doc,
                    std::vector<Field> more) {
    std::vector<Field> fields = common_fields_of_cranes(kind);
    for (Field& field : crane_fields<T>()) fields.push_back(std::move(field));
    for (Field& field : more) fields.push_back(std::move(field));
    return object(id, what, doc, std::move(fields));
}

}  // namespace

ShapePtr crane_load_shape() {
    return crane_part<CraneLoad>(
        "crane_load", "a load of a crane",
        "Load that the hook can attach by slings of equal length.",
        {{"body", body_ref(), true, "", "", "A rigid body or a point mass."},
         {"eyes", list("a list of points", vector3("a point"), 1, 8), false, "[[0, 0, 0]]", "m",
          "Points at which slings are made fast, in its frame."}});
}

ShapePtr crane_shape() {
    const ShapePtr cylinder =
        crane_part<CraneCylinder>("crane_cylinder", "a cylinder", "A hydraulic cylinder.");
    auto shape = std::make_shared<Shape>();
    shape->type = Shape::Type::switched;
    shape->id = "crane";
    shape->what = "a crane";
    shape->doc = "A crane on a body; \"kind\" selects which.";
    shape->key = "kind";
    shape->cases.emplace_back(
        "knuckle_boom",
        crane_kind<KnuckleCraneDef>(
            "knuckle_boom", "crane_knuckle_boom", "a knuckle-boom crane",
            "Two booms and two cylinders.",
            {{"boom_cylinder", cylinder, true, "", "", "Between column and boom."},
             {"jib", crane_part<CraneLink>("crane_link", "a boom or jib", "A boom or jib."), true,
              "", "", "Jib, on the head of the boom."},
             {"jib_cylinder", cylinder, true, "", "", "Between boom and jib."}}));
    shape->cases.emplace_back("lattice",
                              crane_kind<LatticeCraneDef>(
                                  "lattice", "crane_lattice", "a lattice crane",
                                  "A boom on pendants, held by a luffing tackle to a gantry.",
                                  {{"luffing", tackle_shape(), true, "", "", "Luffing tackle."}}));
    return shape;
}

}  // namespace hawser::scene
