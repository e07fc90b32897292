// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file recording_listener.h
/// Records all that is done to a world, whoever does it, in the order in which it is done.

#include <hawser/recording.h>
#include "record/changes.h"
#include "record/recording_writer.h"

#include <exception>
#include <vector>

namespace hawser::record {

class RecordingListener final : public ChangeBytes {
  public:
    /// Listens to `world` until it ends; both have to outlive it.
    RecordingListener(RecordingWriter& writer, World& world) noexcept;
    ~RecordingListener() override;
    RecordingListener(const RecordingListener&) = delete;
    RecordingListener& operator=(const RecordingListener&) = delete;

    /// Inputs of a scene are commands, which a recording stores separately.
    void set(InputId id, double value) noexcept override;
    /// Replays have no systems, only their actions.
    void detached(InteractionId element, int end) noexcept override;
    void restored(std::span<const std::byte> bytes) noexcept override;
    void restored(const Structure& made_of, std::span<const std::byte> bytes) noexcept override;
    /// Write the changes. Call before each step.
    /// @throws RecordingError, also for failures since the last call.
    void flush();
    /// Write the changes made during a step.
    /// @param step  Number of steps before that one; a replay makes the changes before it.
    /// @throws RecordingError
    void flush(std::int64_t step);
    std::size_t mark() noexcept override;
    void undone(std::size_t mark) noexcept override;

  private:
    /// Inputs, and then changes, that are not written yet.
    struct Part {
        std::vector<RecordedInput> set;
        std::vector<std::byte> changes;
        bool other_bodies = false;
    };
    void close_part();
    template <class F>
    void begin_take(F&& told) noexcept;

    RecordingWriter& writer_;
    World& world_;
    std::vector<Part> parts_;         ///< Closed ones that are not written yet, in order.
    std::vector<RecordedInput> set_;  ///< Since the last change; not written yet.
    std::int32_t inputs_;  ///< Number of inputs of the scene: the recording has their names.
    std::int64_t now_;     ///< Number of steps at the last call.
    std::exception_ptr fault_;
};

}  // namespace hawser::record
