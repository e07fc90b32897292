// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file protocol.h
/// Offsets in a frame's header and the order of its statistics: docs/live.md, "Frames".

#include <cstddef>
#include <cstdint>

namespace hawser::live {

inline constexpr int kProtocolVersion = 1;
inline constexpr std::uint32_t kFrameMagic = 0x564C5748;  ///< "HWLV"
inline constexpr std::size_t kFrameHeader = 128;          ///< Size of the header [bytes].
inline constexpr std::size_t kMaxContacts = 4096;  ///< Largest number of contacts in a frame.

/// Layout of the header in a frame; little-endian, as all machines on which Hawser runs.
struct FrameHeader {
    std::uint32_t magic = kFrameMagic;
    std::uint16_t version = kProtocolVersion, flags = 0;
    std::uint32_t length = 0, epoch = 0, number = 0, skipped = 0;
    std::int64_t step = 0;
    double time = 0.0;   ///< Time [s].
    double clock = 0.0;  ///< clock_now() when it was complete [s].
    std::uint32_t rigid = 0, lumps = 0, scalars = 0;
    std::uint32_t wires = 0, points = 0, pieces = 0;
    std::uint32_t contacts = 0, joints = 0, outputs = 0, inputs = 0, stats = 0;
    std::uint32_t contacts_left = 0;
    std::uint32_t bits = 0;
    std::int32_t iterations = 0;
    std::uint64_t cuts = 0;
    std::int32_t coarser = 0;
    std::uint32_t hasty = 0;
    std::uint64_t reserved = 0;

    [[nodiscard]] std::size_t floats() const noexcept {
        return std::size_t{7} * rigid + std::size_t{3} * lumps + scalars + wires +
               std::size_t{3} * points + pieces + std::size_t{6} * contacts +
               std::size_t{3} * joints + outputs + inputs + stats;
    }
};
static_assert(sizeof(FrameHeader) == kFrameHeader);

enum FrameFlag : std::uint16_t { kPaused = 1, kOfRecording = 2, kFailed = 4, kDragged = 8 };
enum FrameBit : std::uint32_t { kCertified = 1, kEndedEarly = 2, kMissedDeadline = 4 };

/// Statistics of a frame, in their order.
inline constexpr const char* kStatNames[] = {"step_ms",
                                             "stage_prestep_ms",
                                             "stage_collide_ms",
                                             "stage_graph_ms",
                                             "stage_analyse_ms",
                                             "stage_assemble_ms",
                                             "stage_factor_ms",
                                             "stage_nonsmooth_ms",
                                             "stage_integrate_ms",
                                             "solver_cpu_ms",
                                             "deadline_ms",
                                             "momentum_residual",
                                             "constraint_residual",
                                             "violation_m",
                                             "natural_map",
                                             "contacts",
                                             "newton_iterations",
                                             "islands",
                                             "asleep",
                                             "energy",
                                             "late_ms",
                                             "frame_us"};
inline constexpr std::size_t kStatCount = sizeof kStatNames / sizeof kStatNames[0];

}  // namespace hawser::live
