// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file sea_fields.h
/// Numbers of the sea in a scene (hawser/sea.h). Format and reader use one table. Directions have a
/// reader of their own.

#include <hawser/fields.h>
#include <hawser/sea.h>

#include <array>

namespace hawser::scene {

inline constexpr auto kWaveFields = std::to_array<FieldInfo<WaveDef>>(
    {{"height", &WaveDef::height, "m", "", "Crest to trough; of a spectrum significant, Hs.", 0.0,
      100.0, "a height"},
     {"period", &WaveDef::period, "s", "",
      "Period of a regular wave, or of the peak of a spectrum, Tp.", 0.0, 1e4, "a period"},
     {"direction_deg", &WaveDef::direction, "deg", "0",
      "Direction to which the waves run, from x towards y.", -360.0, 360.0, "an angle", kOwnReader},
     {"phase_deg", &WaveDef::phase, "deg", "0",
      "Phase of a regular wave; with 0 its crest is at the origin at 0 s.", -360.0, 360.0,
      "an angle", kOwnReader},
     {"gamma", &WaveDef::gamma, "1", "3.3", "Peak enhancement of JONSWAP.", 1.0, 20.0, "a factor"},
     {"spreading", &WaveDef::spreading, "1", "0: one direction",
      "s of the directions' cos^2s of half the angle.", 0.0, 200.0, "a power"},
     {"components", &WaveDef::components, "", "200",
      "Number of components of a spectrum; at most 400 over all waves.", 1.0, kMaxWaveComponents,
      "a number"},
     {"seed", &WaveDef::seed, "", "1", "Seed of the random phases, frequencies and directions.",
      0.0, 2147483647.0, "a seed"},
     {"lowest", &WaveDef::lowest, "1", "0.5", "Lowest frequency over that of the peak.", 1e-3, 1.0,
      "a ratio"},
     {"highest", &WaveDef::highest, "1", "4", "Highest frequency over that of the peak.", 1.001,
      20.0, "a ratio"}});

inline constexpr auto kWindFields = std::to_array<FieldInfo<WindDef>>(
    {{"speed", &WindDef::speed, "m/s", "", "Mean of an hour at 10 m.", 0.0, 100.0, "a speed",
      kLeastToo},
     {"direction_deg", &WindDef::direction, "deg", "0",
      "Direction to which the wind blows, from x towards y.", -360.0, 360.0, "an angle",
      kOwnReader},
     {"gusts", &WindDef::gusts, "", "false",
      "True: with those of the NPD spectrum, 1/600 to 0.5 Hz."},
     {"components", &WindDef::components, "", "100", "Number of components of gusts.", 1.0,
      kMaxWaveComponents, "a number"},
     {"seed", &WindDef::seed, "", "1", "Seed of the random phases of gusts.", 0.0, 2147483647.0,
      "a seed"},
     {"density", &WindDef::density, "kg/m^3", "1.225", "Density of air.", 0.0, 1e3, "a density",
      kAboveLeast}});

/// Coefficients of slender members in water. The key "diameter" is apart: a line type has it, too.
inline constexpr auto kLineWaterFields = std::to_array<FieldInfo<LineWater>>(
    {{"cd_normal", &LineWater::cd_normal, "1", "1.2", "Drag across, on the diameter.", 0.0, 1e3,
      "a coefficient"},
     {"cd_tangential", &LineWater::cd_tangential, "1", "0", "Drag along, on the circumference.",
      0.0, 1e3, "a coefficient"},
     {"ca_normal", &LineWater::ca_normal, "1", "1",
      "Added mass across the axis, as a fraction of the displaced water's mass.", 0.0, 1e3,
      "a coefficient"},
     {"ca_tangential", &LineWater::ca_tangential, "1", "0", "Added mass along.", 0.0, 1e3,
      "a coefficient"},
     {"displaced_area", &LineWater::volume, "m^2", "of the diameter",
      "Volume of water displaced per length; 0 in a hull, which displaces it already.", 0.0, 1e6,
      "an area"}});

}  // namespace hawser::scene
