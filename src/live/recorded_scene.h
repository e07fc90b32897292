// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file recorded_scene.h
/// What a recording shows: its scene as clients know scenes, and frames of it.
///
/// The recording has the text of its scene; the world that it builds tells shapes, joints and
/// names, while poses and tensions are those that were recorded. Where there is no text, or this
/// program does not read it, the recording's own list of bodies and outlines has to do.

#include "live/frame_plan.h"
#include "live/frame_swap.h"
#include "live/protocol.h"

#include <hawser/recording.h>
#include <nlohmann/json_fwd.hpp>

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace hawser::live {

class RecordedScene {
  public:
    /// @param recording  Has to outlive it. @throws RecordingError where it has no frame.
    explicit RecordedScene(const record::Recording& recording);

    /// The message `scene` of the protocol: bodies, shapes and cables that frames move.
    [[nodiscard]] nlohmann::json json() const;
    /// A frame as it was recorded, in single precision: forces of contacts and joints, outputs and
    /// times of stages are not in recordings.
    void write(std::size_t index, std::uint16_t flags, std::uint32_t number, Bytes& out) const;
    /// What was wrong with the text of the scene; "": nothing.
    [[nodiscard]] const std::string& fault() const noexcept { return fault_; }

  private:
    void build_world();
    void build_from_list();
    void find_wires();
    void follow_inputs();
    [[nodiscard]] std::vector<float> inputs_at(std::size_t index, std::int64_t step) const;
    [[nodiscard]] std::int32_t joint_of(const WireSource& wire) const;
    bool add_recorded(const record::Frame& frame, std::string_view name,
                      const std::vector<record::RecordedWire>* wires,
                      const std::vector<float>& pulls, std::vector<float>& points,
                      std::vector<float>& tensions) const;
    void add_wire(const record::Frame& frame, std::size_t wire, std::vector<float>& points,
                  std::vector<float>& tensions) const;

    /// Where tensions and points of a wire of the plan come from.
    struct Source {
        std::int32_t cable = -1;  ///< Of the recording.
        std::int32_t joint = -1;  ///< Of the recording, that a line or rod of the scene is.
    };

    const record::Recording& recording_;
    scene::Scene scene_;
    FramePlan plan_;
    bool own_list_ = false;  ///< Bodies and outlines are those of the recording.
    std::vector<Source> sources_;
    std::vector<std::int32_t> input_of_;  ///< Of the recording's inputs, which of the plan's.
    Vec3 origin_{0.0, 0.0, 0.0};
    std::string fault_;
};

}  // namespace hawser::live
