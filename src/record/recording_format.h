// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file recording_format.h
/// Constants of the recording format (docs/recording.md).

#include <cstddef>
#include <cstdint>

namespace hawser::record {

inline constexpr char kMagic[8] = {'H', 'A', 'W', 'S', 'E', 'R', 'R', 'C'};
inline constexpr std::uint32_t kFormatVersion = 2;

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
inline constexpr char kLoadsChunk[] = "LOAD";
inline constexpr char kNoteChunk[] = "NOTE";
inline constexpr char kWaterChunk[] = "WATR";
inline constexpr char kInputsChunk[] = "INPT";
inline constexpr char kCutChunk[] = "CUTS";
inline constexpr char kEventChunk[] = "EVNT";
inline constexpr char kTakeChunk[] = "TAKE";
inline constexpr char kEndChunk[] = "DONE";

inline constexpr std::size_t kChunkOverhead = 12;
inline constexpr std::size_t kFrameHeadBytes = 6 * 8;
inline constexpr std::size_t kMaxChunk = 0xFFFFFF00u;

}  // namespace hawser::record
