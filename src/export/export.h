// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file export.h
/// Convert recordings for other programs: animated glTF 2.0 and VTK XML.
///
/// Both writers read a recording frame by frame and hold up to 64 frames at a time. Their memory
/// does not grow with the number of frames. The recording itself is read completely.

#include <hawser/recording.h>

#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace hawser::exporting {

/// Indices of frames, ascending.
using Frames = std::vector<std::size_t>;

/// Return the first frame of the last branch, which begins at the last return to a saved state; 0
/// if there was none.
[[nodiscard]] inline std::size_t first_frame(const record::Recording& recording) {
    return recording.takes.empty() ? 0 : recording.takes.back().frames;
}

/// Return every `every`-th frame of the last branch with a time in [from, to], and the last such
/// frame. Earlier branches are omitted, because both formats require ascending times.
[[nodiscard]] Frames choose_frames(const record::Recording& recording, std::size_t every,
                                   double from, double to);

/// Callback that receives the number of completed frames.
using Progress = std::function<void(std::size_t)>;

/// Write a binary glTF (Khronos Group, *glTF 2.0 Specification*, 2021), y up; times count from the
/// first frame.
///
/// Bodies: each visible body is a node with the name of the body, its shapes as meshes, and
/// channels of translation and rotation. A body that is absent in some frames has a scale channel,
/// which is 0 while it is absent.
///
/// Wires: each wire is a mesh of three crossed ribbons, skinned to one node for each end of its
/// elements. These nodes are named "NAME@0", "NAME@1", … and have animated translations, so every
/// point has its recorded position. Standard viewers play this. The colour of an element is its
/// largest tension in these frames, divided by the largest tension of all wires. A wire with a
/// varying number of nodes has joints for the largest number; unused joints lie at its end. If an
/// element is broken, both its joints lie at its first end.
/// @throws std::runtime_error if the file cannot be written, or would exceed the 4 GiB of a binary
/// glTF.
void write_gltf(const record::Recording& recording, const Frames& frames,
                const std::filesystem::path& file, const Progress& progress = {});

/// Contact forces of a frame, supplied by a replay of the recording: points [m] and forces on the
/// second shape [N], three values each.
struct ContactForces {
    std::vector<double> points, forces;
};
using ContactSource = std::function<const ContactForces&(const record::Frame&)>;

/// Write VTK XML. `file` (.pvd) lists the times. A folder with the same name holds one PolyData
/// file (.vtp, appended raw) for each frame.
///
/// Cells, in this order: a vertex for each body, a vertex for each contact, a line for each element
/// of a wire, triangles of bodies.
///
/// Cell data, NaN if undefined:
/// 1. `kind`: 0 body, 1 contact, 2 wire, 3 surface.
/// 2. `index`: body of the recording, contact, or wire.
/// 3. `tension` [N], `strain` = T/EA and `parted` of wires.
/// 4. `orientation` (w, x, y, z) of bodies.
/// 5. `force` [N] of contacts.
///
/// Field data: `time`, `step`, `body_names`, `wire_names` (lines of UTF-8).
/// @param contacts  Source of contact forces; contacts are left out if it is empty.
/// @throws std::runtime_error.
void write_vtk(const record::Recording& recording, const Frames& frames,
               const std::filesystem::path& file, const ContactSource& contacts = {},
               const Progress& progress = {});

}  // namespace hawser::exporting
