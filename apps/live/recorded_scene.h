// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file recorded_scene.h
/// The scene of a recording in the form for clients, and frames of it.
///
/// The recording contains the text of its scene. The world built from it provides shapes, joints
/// and names; poses and tensions come from the recording. If there is no text, or this program
/// cannot read it, the recording's own list of bodies and outlines is used.

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
    /// Read the scene. @param recording  Must outlive this object. @throws RecordingError if it has
    /// no frame.
    explicit RecordedScene(const record::Recording& recording);

    /// Return the message `scene` of the protocol: bodies, shapes and cables that frames move.
    [[nodiscard]] nlohmann::json json() const;
    /// Write a recorded frame in single precision. Forces of contacts and joints, outputs and times
    /// of stages are not in recordings.
    void write(std::size_t index, std::uint16_t flags, std::uint32_t number, Bytes& out) const;
    /// Return the fault of the scene's text; "": none.
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

    /// Source of the tensions and points of a wire of the plan.
    struct Source {
        std::int32_t cable = -1;  ///< Cable of the recording.
        std::int32_t joint = -1;  ///< Joint of the recording, for a line or rod of the scene.
    };

    const record::Recording& recording_;
    scene::Scene scene_;
    FramePlan plan_;
    bool uses_recorded_list_ = false;  ///< True if bodies and outlines are those of the recording.
    std::vector<Source> sources_;
    std::vector<std::int32_t> input_of_;  ///< Input of the plan for each input of the recording.
    Vec3 origin_{0.0, 0.0, 0.0};
    std::string fault_;
};

}  // namespace hawser::live
