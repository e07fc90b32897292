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
    /// Listen to `world` until this object ends. Writer and world must outlive it.
    RecordingListener(RecordingWriter& writer, World& world) noexcept;
    ~RecordingListener() override;
    RecordingListener(const RecordingListener&) = delete;
    RecordingListener& operator=(const RecordingListener&) = delete;

    /// Do nothing for inputs of a scene: they are commands, which a recording stores separately.
    void set(InputId id, double value) noexcept override;
    /// Store the action of a system. Replays have no systems, only their actions.
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
    /// Return the number of set inputs and of bytes of changes. Allocates no memory, because a step
    /// must not lose changes made before it.
    std::size_t mark() noexcept override;
    void undone(std::size_t mark) noexcept override;

  private:
    /// A set input and its position among the changes.
    struct Set {
        RecordedInput input;
        std::size_t bytes = 0;  ///< Size of the changes before it.
    };
    template <class F>
    void begin_branch(F&& reported) noexcept;

    RecordingWriter& writer_;
    World& world_;
    std::vector<Set> set_;            ///< Not written yet; their changes are in bytes().
    std::vector<RecordedInput> run_;  ///< Scratch: inputs between two changes.
    std::int32_t inputs_;         ///< Number of inputs of the scene; the recording has their names.
    std::int64_t last_step_;      ///< Steps taken when it looked last.
    bool failed_before_ = false;  ///< failed() at the last mark.
    std::exception_ptr fault_;
};

}  // namespace hawser::record
