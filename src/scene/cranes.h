// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file cranes.h
/// Numbers and points of a crane in a scene. Format and reader use one table. Keys that end in _deg
/// are degrees here and radians in definitions.

#include <hawser/crane.h>
#include <hawser/fields.h>

namespace hawser::scene {

template <class T>
struct CranePoint {
    const char* key;
    Vec3 T::* value;
    const char* fallback;  ///< Default in words; "" if the key is required.
    const char* doc;
};

inline constexpr double kMaxCraneLength = 1e4, kMaxCraneMass = 1e12, kMaxCraneForce = 1e15,
                        kMaxCraneSpeed = 100.0;

/// Tables of one part of a definition.
template <class T>
struct CraneTable;

template <>
struct CraneTable<CraneSlew> {
    static constexpr FieldInfo<CraneSlew> kNumbers[] = {
        {"torque", &CraneSlew::torque, "N m", "", "Largest of the motor.", 0.0, kMaxCraneForce},
        {"brake", &CraneSlew::brake, "N m", "", "Torque above which the brake slips.", 0.0,
         kMaxCraneForce},
        {"friction", &CraneSlew::friction, "N m", "0",
         "Friction torque of the bearing while it turns.", 0.0, kMaxCraneForce},
        {"speed", &CraneSlew::speed, "rad/s", "", "Largest.", 0.0, 10.0},
        {"angle_deg", &CraneSlew::angle, "deg", "0", "Angle at the start.", -180.0, 180.0}};
    static constexpr CranePoint<CraneSlew> kPoints[1] = {};
    static constexpr int kPointCount = 0;
};

template <>
struct CraneTable<CraneColumn> {
    static constexpr FieldInfo<CraneColumn> kNumbers[] = {
        {"mass", &CraneColumn::mass, "kg", "", "Counterweight included.", 0.0, kMaxCraneMass}};
    static constexpr CranePoint<CraneColumn> kPoints[] = {
        {"centre", &CraneColumn::centre, "[0, 0, 0]", "Centre of mass, in the column's frame."},
        {"half_size", &CraneColumn::half_size, "",
         "Half sizes of a solid box, for inertia and picture."}};
    static constexpr int kPointCount = 2;
};

template <>
struct CraneTable<CraneLink> {
    static constexpr FieldInfo<CraneLink> kNumbers[] = {
        {"length", &CraneLink::length, "m", "", "Length from the foot pin to the head.", 0.0,
         kMaxCraneLength},
        {"mass", &CraneLink::mass, "kg", "", "Mass.", 0.0, kMaxCraneMass},
        {"centre", &CraneLink::centre, "m", "half the length",
         "Distance of the centre of mass from the foot pin.", 0.0, kMaxCraneLength},
        {"width", &CraneLink::width, "m", "", "Width of a solid box, for inertia and picture.", 0.0,
         kMaxCraneLength},
        {"height", &CraneLink::height, "m", "", "Height of this box.", 0.0, kMaxCraneLength}};
    static constexpr CranePoint<CraneLink> kPoints[1] = {};
    static constexpr int kPointCount = 0;
};

template <>
struct CraneTable<CraneCylinder> {
    static constexpr FieldInfo<CraneCylinder> kNumbers[] = {
        {"min_length", &CraneCylinder::min_length, "m", "", "Between the pins, rod in.", 0.0,
         kMaxCraneLength},
        {"max_length", &CraneCylinder::max_length, "m", "", "Rod out.", 0.0, kMaxCraneLength},
        {"push", &CraneCylinder::push, "N", "", "Largest force.", 0.0, kMaxCraneForce},
        {"pull", &CraneCylinder::pull, "N", "", "Largest force the other way.", 0.0,
         kMaxCraneForce},
        {"speed", &CraneCylinder::speed, "m/s", "", "Largest.", 0.0, kMaxCraneSpeed},
        {"stiffness", &CraneCylinder::stiffness, "N/m", "", "Stiffness of oil and pins.", 0.0,
         kMaxCraneForce},
        {"mass", &CraneCylinder::mass, "kg", "", "Mass of the rod and the oil that move.", 0.0,
         kMaxCraneMass}};
    static constexpr CranePoint<CraneCylinder> kPoints[] = {
        {"foot", &CraneCylinder::foot, "", "Pin nearer the column, in the frame of that link."},
        {"head", &CraneCylinder::head, "", "Pin on the link that it moves, in its frame."}};
    static constexpr int kPointCount = 2;
};

template <>
struct CraneTable<CraneTackle> {
    static constexpr FieldInfo<CraneTackle> kNumbers[] = {
        {"EA", &CraneTackle::EA, "N", "", "Axial stiffness EA of the line.", 0.0, kMaxCraneForce},
        {"efficiency", &CraneTackle::efficiency, "1", "1",
         "Efficiency of each sheave: lesser tension over greater; above 0.", 0.0, 1.0},
        {"sheave_radius", &CraneTackle::sheave_radius, "m", "0.3",
         "Radius of the sheaves of hoists; luffing tackles run over eyes.", 0.0, 1e3},
        {"sheave_inertia", &CraneTackle::sheave_inertia, "kg m^2", "0",
         "Moment of inertia of each sheave at the head of a hoist.", 0.0, kMaxCraneMass},
        {"drum_radius", &CraneTackle::drum_radius, "m", "", "Radius.", 0.0, 1e3},
        {"drum_inertia", &CraneTackle::drum_inertia, "kg m^2", "",
         "Moment of inertia of the drum with motor and gear.", 0.0, kMaxCraneMass},
        {"pull", &CraneTackle::pull, "N", "", "Line pull of the motor.", 0.0, kMaxCraneForce},
        {"brake", &CraneTackle::brake, "N", "", "Line pull above which the brake slips.", 0.0,
         kMaxCraneForce},
        {"speed", &CraneTackle::speed, "m/s", "", "Largest, of hook or bridle.", 0.0,
         kMaxCraneSpeed},
        {"breaking_load", &CraneTackle::breaking_load, "N", "never", "Breaking load of the line.",
         0.0, kMaxCraneForce},
        {"damping_time", &CraneTackle::damping_time, "s", "two steps", "Damping time of the line.",
         0.0, 1e12}};
    static constexpr CranePoint<CraneTackle> kPoints[] = {
        {"drum", &CraneTackle::drum, "",
         "Where the line leaves: on the column, of a knuckle boom's hoist on its boom."}};
    static constexpr int kPointCount = 1;
};

template <>
struct CraneTable<CraneHook> {
    static constexpr FieldInfo<CraneHook> kNumbers[] = {
        {"mass", &CraneHook::mass, "kg", "", "Mass, its block included.", 0.0, kMaxCraneMass},
        {"height", &CraneHook::height, "m", "",
         "Height of the hook's point below the axis of its sheaves.", 0.0, kMaxCraneLength},
        {"hang", &CraneHook::hang, "m", "",
         "Distance from the sheaves of the boom head to those of the hook at the start.", 0.0,
         kMaxCraneLength},
        {"least_hang", &CraneHook::least_hang, "m", "0",
         "Distance of the hook below the head at which hauling is cut out.", 0.0, kMaxCraneLength},
        {"angular_damping", &CraneHook::angular_damping, "N m s", "0",
         "Damping coefficient of its rotation.", 0.0, kMaxCraneForce}};
    static constexpr CranePoint<CraneHook> kPoints[] = {
        {"half_size", &CraneHook::half_size, "[0.3, 0.3, 0.5]", "Inertia and picture."}};
    static constexpr int kPointCount = 1;
};

template <>
struct CraneTable<CraneRating> {
    static constexpr FieldInfo<CraneRating> kNumbers[] = {
        {"warning", &CraneRating::warning, "1", "0.9", "Utilisation of step 1 of the alarm.", 0.0,
         10.0},
        {"overload", &CraneRating::overload, "1", "1", "Utilisation of step 2.", 0.0, 10.0},
        {"hold", &CraneRating::hold, "s", "0.5",
         "Time that the condition lasts before the step changes.", 0.0, 1e3},
        {"filter", &CraneRating::filter, "s", "0.5", "Time constant of the load that is shown.",
         0.0, 1e3}};
    static constexpr CranePoint<CraneRating> kPoints[1] = {};
    static constexpr int kPointCount = 0;
};

template <>
struct CraneTable<CraneLoad> {
    static constexpr FieldInfo<CraneLoad> kNumbers[] = {
        {"sling_length", &CraneLoad::sling_length, "m", "",
         "Length of a sling from the hook's point to an eye.", 0.0, kMaxCraneLength},
        {"sling_EA", &CraneLoad::sling_EA, "N", "", "Axial stiffness EA of each sling.", 0.0,
         kMaxCraneForce},
        {"reach", &CraneLoad::reach, "m", "0",
         "Additional distance at which the hook can still attach an eye.", 0.0, kMaxCraneLength},
        {"breaking_load", &CraneLoad::breaking_load, "N", "never", "Breaking load of each sling.",
         0.0, kMaxCraneForce}};
    static constexpr CranePoint<CraneLoad> kPoints[1] = {};
    static constexpr int kPointCount = 0;
};

template <>
struct CraneTable<KnuckleCraneDef> {
    static constexpr FieldInfo<KnuckleCraneDef> kNumbers[] = {
        {"boom_angle_deg", &KnuckleCraneDef::boom_angle, "deg", "",
         "Angle of the boom above the horizontal at the start.", -90.0, 90.0},
        {"jib_angle_deg", &KnuckleCraneDef::jib_angle, "deg", "",
         "Angle of the jib against the boom at the start; below 0: folded down.", -180.0, 180.0},
        {"ramp", &KnuckleCraneDef::ramp, "s", "2", "Time from rest to the largest speed.", 0.0,
         1e3}};
    static constexpr CranePoint<KnuckleCraneDef> kPoints[] = {
        {"boom_foot", &KnuckleCraneDef::boom_foot, "", "Foot pin, in the column's frame; y = 0."}};
    static constexpr int kPointCount = 1;
};

template <>
struct CraneTable<LatticeCraneDef> {
    static constexpr FieldInfo<LatticeCraneDef> kNumbers[] = {
        {"boom_angle_deg", &LatticeCraneDef::boom_angle, "deg", "",
         "Angle of the boom above the horizontal at the start.", -90.0, 90.0},
        {"least_angle_deg", &LatticeCraneDef::least_angle, "deg", "5.73",
         "Smallest angle of the boom.", -85.0, 85.0},
        {"most_angle_deg", &LatticeCraneDef::most_angle, "deg", "83.1",
         "Angle at which the boom meets its back stop.", -85.0, 89.0},
        {"bridle_mass", &LatticeCraneDef::bridle_mass, "kg", "",
         "Mass of the bridle, a point mass.", 0.0, kMaxCraneMass},
        {"pendant_length", &LatticeCraneDef::pendant_length, "m", "",
         "Length of the pendants from boom head to bridle at the start.", 0.0, kMaxCraneLength},
        {"pendant_EA", &LatticeCraneDef::pendant_EA, "N", "",
         "Axial stiffness EA of each of the two pendants.", 0.0, kMaxCraneForce},
        {"pendant_breaking_load", &LatticeCraneDef::pendant_breaking_load, "N", "never",
         "Breaking load of each pendant.", 0.0, kMaxCraneForce},
        {"ramp", &LatticeCraneDef::ramp, "s", "2", "Time from rest to the largest speed.", 0.0,
         1e3}};
    static constexpr CranePoint<LatticeCraneDef> kPoints[] = {
        {"boom_foot", &LatticeCraneDef::boom_foot, "", "Foot pin, in the column's frame; y = 0."},
        {"gantry", &LatticeCraneDef::gantry, "", "Its head, in the column's frame; y = 0."}};
    static constexpr int kPointCount = 2;
};

}  // namespace hawser::scene
