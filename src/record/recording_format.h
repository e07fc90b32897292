// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file recording_format.h
/// Constants of the recording format (docs/recording.md).

#include <hawser/def.h>

#include <cstddef>
#include <cstdint>

namespace hawser::record {

inline constexpr char kMagic[8] = {'H', 'A', 'W', 'S', 'E', 'R', 'R', 'C'};
inline constexpr std::uint32_t kFormatVersion = 3;
/// Version whose LOAD chunks contain the loads of all bodies, without their sources.
inline constexpr std::uint32_t kAllLoadsVersion = 2;

/// Four characters name a chunk; its length follows in 4 bytes, the CRC-32 of all of it last.
inline constexpr char kSceneChunk[] = "SCEN";
inline constexpr char kSettingsChunk[] = "CONF";
inline constexpr char kLayoutChunk[] = "LAYT";
inline constexpr char kSnapshotChunk[] = "SNAP";
inline constexpr char kInputNamesChunk[] = "INAM";
inline constexpr char kOutlineChunk[] = "SHAP";
inline constexpr char kFrameChunk[] = "FRAM";
inline constexpr char kChangesChunk[] = "CHNG";
inline constexpr char kBodiesChunk[] = "BODS";
inline constexpr char kWiresChunk[] = "WIRE";
inline constexpr char kPullsChunk[] = "PULL";
inline constexpr char kLinesChunk[] = "LINE";
inline constexpr char kLinePullsChunk[] = "LPUL";
inline constexpr char kOutputNamesChunk[] = "ONAM";
inline constexpr char kOutputsChunk[] = "OUTP";
inline constexpr char kLoadsChunk[] = "LOAD";
inline constexpr char kLineSeaChunk[] = "LSEA";
inline constexpr char kNoteChunk[] = "NOTE";
inline constexpr char kWaterChunk[] = "WATR";
inline constexpr char kInputsChunk[] = "INPT";
inline constexpr char kCutChunk[] = "CUTS";
inline constexpr char kEventChunk[] = "EVNT";
inline constexpr char kTakeChunk[] = "TAKE";
inline constexpr char kEndChunk[] = "DONE";

/// Bits of the sources of a recorded load.
enum LoadSource : std::uint8_t { kNoSource = 0, kOtherSource = 1, kWaterSource = 2 };

inline constexpr std::size_t kChunkOverhead = 12;
inline constexpr std::size_t kFrameHeadBytes = 6 * 8;
/// Largest number of freedoms of a body, and of numbers of a load.
inline constexpr std::size_t kMaxFreedom = 6, kMaxLoadNumbers = 69;
/// Return the number of entries of a load: force and three symmetric matrices.
[[nodiscard]] constexpr std::size_t load_numbers(std::size_t freedom) noexcept {
    return freedom + 3 * (freedom * (freedom + 1) / 2);
}
static_assert(load_numbers(kMaxFreedom) == kMaxLoadNumbers);
/// Step, sea, its inputs and number of bodies of a LOAD chunk; index, generation, freedom and
/// sources of one body.
inline constexpr std::size_t kLoadHeadBytes = 8 + 4 + 3 * 8 + 4, kLoadBodyBytes = 4 + 4 + 1 + 1;
inline constexpr std::size_t kMaxChunk = 0xFFFFFF00u;

}  // namespace hawser::record
