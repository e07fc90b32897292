// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file deck_fields.h
/// Numbers and points of deck gear in a scene (hawser/stopper.h, pin.h, hook.h, chaser.h). Format
/// and reader use one table.

#include <hawser/chaser.h>
#include <hawser/fields.h>
#include <hawser/hook.h>
#include <hawser/pin.h>
#include <hawser/stopper.h>

#include <array>

namespace hawser::scene {

inline constexpr double kMaxCoordinate = 1e12;  ///< Limit of coordinates (make_shape.cpp) [m].

inline constexpr auto kStopperFields = std::to_array<FieldInfo<StopperDef>>(
    {{"point", &StopperDef::point, "m", "",
      "Point where cables are to lie, in the frame of the body.", -kMaxCoordinate, kMaxCoordinate,
      "a point"},
     {"outboard", &StopperDef::outboard, "1", "[-1, 0, 0]",
      "The way in which cable pays out, in that frame.", -kMaxCoordinate, kMaxCoordinate,
      "a direction"},
     {"reach", &StopperDef::reach, "m", "0.5",
      "Distance from the point within which it engages cables.", 0.0, 1e3, "a length", kAboveLeast},
     {"rated_load", &StopperDef::rated_load, "N", "", "Load above which the stopper opens.", 0.0,
      1e12, "a force"},
     {"pitch", &StopperDef::pitch, "m", "0, a jaw",
      "Pitch of a chain stopper, which prevents paying out only: length of chain hauled in until "
      "its pawl engages again, at least 0.05 m.",
      0.0, 10.0, "a length"},
     {"closed", &StopperDef::closed, "", "false", "Whether it is at the start."}});

inline constexpr auto kPinFields = std::to_array<FieldInfo<PinDef>>(
    {{"from", &PinDef::from, "m", "", "Foot of its axis when it is up, in the frame of the body.",
      -kMaxCoordinate, kMaxCoordinate, "a point"},
     {"to", &PinDef::to, "m", "", "Its top, in that frame.", -kMaxCoordinate, kMaxCoordinate,
      "a point"},
     {"radius", &PinDef::radius, "m", "", "Radius of the pin.", 0.0, 100.0, "a radius"},
     {"friction", &PinDef::friction, "1", "0", "Friction coefficient of cables that lie on it.",
      0.0, 10.0, "a coefficient"},
     {"efficiency", &PinDef::efficiency, "1", "1",
      "Efficiency of a pin with a roller: lesser tension over greater; above 0.", 0.0, 1.0,
      "an efficiency"},
     {"speed", &PinDef::speed, "m/s", "0.1", "Speed at which it moves up and down.", 0.0, 100.0,
      "a speed", kAboveLeast},
     {"force", &PinDef::force, "N", "2e5", "Largest force of its drive; must exceed its weight.",
      0.0, 1e12, "a force", kAboveLeast},
     {"density", &PinDef::density, "kg/m^3", "7850", "Density of its material; it is solid.", 0.0,
      1e6, "a density", kAboveLeast},
     {"margin", &PinDef::margin, "m", "1", "How near to it cables are watched.", 0.0, 1e3,
      "a length"},
     {"up", &PinDef::up, "", "true", "Whether it is at the start."}});

inline constexpr auto kHookFields = std::to_array<FieldInfo<HookDef>>(
    {{"point", &HookDef::point, "m", "[0, 0, 0]",
      "Point at which slings are attached, in the frame of the body.", -kMaxCoordinate,
      kMaxCoordinate, "a point"},
     {"strength", &HookDef::strength, "N", "none", "Load above which the hook opens by itself.",
      0.0, 1e30, "a force", kAboveLeast},
     {"latch", &HookDef::latch, "N", "none",
      "Load above which the hook does not open when it is ordered to.", 0.0, 1e30, "a force",
      kAboveLeast}});

inline constexpr auto kChaserFields = std::to_array<FieldInfo<ChaserDef>>(
    {{"point", &ChaserDef::point, "m", "[0, 0, 0]",
      "Position of its middle, in the frame of the body.", -kMaxCoordinate, kMaxCoordinate,
      "a point"},
     {"reach", &ChaserDef::reach, "m", "1",
      "Distance from that point within which it engages cables.", 0.0, 1e3, "a length",
      kAboveLeast},
     {"friction", &ChaserDef::friction, "1", "0.3", "Friction coefficient of the cable in it.", 0.0,
      10.0, "a coefficient"},
     {"arrives", &ChaserDef::arrives, "m", "2",
      "Nearer than this to an end of the cable it has arrived.", 0.0, 1e6, "a length"},
     {"element", &ChaserDef::element, "m", "that of the cable",
      "Length of the elements that are added and removed there.", 0.0, 1e6, "a length",
      kAboveLeast},
     {"closed", &ChaserDef::closed, "", "false",
      "Whether it is to be round a cable from the start."}});

}  // namespace hawser::scene
