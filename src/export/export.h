// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file export.h
/// Recordings for other programs: animated glTF 2.0 and VTK XML.
///
/// Both go through a recording frame by frame and hold some tens of frames at a time, so that what
/// they take of memory does not grow with its length; the recording itself is read whole.

#include <hawser/recording.h>

#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace hawser::exporting {

/// Which frames, ascending.
using Frames = std::vector<std::size_t>;

/// Of the last take, to which the run went back last; 0: it never did.
[[nodiscard]] inline std::size_t first_frame(const record::Recording& recording) {
    return recording.takes.empty() ? 0 : recording.takes.back().frames;
}

/// Every `every`-th frame of the last take whose time is in [from, to], of these the last one too.
/// Earlier takes, which the run left by going back to another state, are left out: in both formats
/// times ascend.
[[nodiscard]] Frames choose_frames(const record::Recording& recording, std::size_t every,
                                   double from, double to);

/// Called with the number of frames done.
using Progress = std::function<void(std::size_t)>;

/// A binary glTF (Khronos Group, *glTF 2.0 Specification*, 2021), y up, times from the first frame
/// on. A node a body with its shapes as meshes and channels for translation and rotation; of bodies
/// that come and go the scale is 0 while they are not there. A node of a body is called as the body
/// is. A wire is a mesh of three crossed ribbons, skinned to a node per end of its elements,
/// "NAME@0" and on, whose translation is animated: standard viewers play it, and each point is
/// where the recording has it. Its colour is the largest tension of each element in these frames
/// over that of all. Wires of which nodes come and go have as many joints as they ever need; those
/// that are too many lie on its end. Where an element has parted both of its joints lie at its
/// first end.
/// @throws std::runtime_error where the file cannot be written, or would exceed the 4 GiB of a
///         binary glTF.
void write_gltf(const record::Recording& recording, const Frames& frames,
                const std::filesystem::path& file, const Progress& progress = {});

/// Contact forces of frames, from who repeats the recording: points and forces on the second shape,
/// three numbers each [m], [N].
struct ContactForces {
    std::vector<double> points, forces;
};
using ContactSource = std::function<const ContactForces&(const record::Frame&)>;

/// VTK XML: `file` (.pvd) lists the times, a folder of its name has one PolyData (.vtp, appended
/// raw) a frame. Cells in this order: a vertex a body, a vertex a contact, a line an element of a
/// wire, triangles of bodies. Cell data: `kind` (0 body, 1 contact, 2 wire, 3 surface), `index`
/// (body of the recording, contact, wire), `tension` [N] and `strain` = T/EA of wires, `parted`,
/// `orientation` (w, x, y, z), `force` [N]; where something has none, NaN.
/// Field data: `time`, `step`, `body_names`, `wire_names` (lines of UTF-8).
/// @param contacts  Empty: contacts are left out. @throws std::runtime_error.
void write_vtk(const record::Recording& recording, const Frames& frames,
               const std::filesystem::path& file, const ContactSource& contacts = {},
               const Progress& progress = {});

}  // namespace hawser::exporting
