// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file timeline.h
/// Perform the operations of a scene's timeline.

#include <hawser/timeline.h>

#include <cstddef>
#include <span>

namespace hawser::session {

/// Return the time up to which all operations were performed before the step that led to the
/// present state [s].
[[nodiscard]] double operations_done_until(const World& world) noexcept;

class Timeline {
  public:
    /// Skip the operations that were performed before the step that led to the present state.
    void skip(std::span<const scene::Operation> all, const World& world) noexcept;
    /// Perform the operations whose time has been reached, in order. @throws DefError with time and
    /// operation if one of them fails.
    void perform_due(std::span<const scene::Operation> all, World& world);
    /// True if a performed operation later than `after` [s] has set the input or signal `name`.
    [[nodiscard]] bool sets(std::span<const scene::Operation> all, const std::string& name,
                            double after) const;
    /// Return the operations that the last perform_due() has performed.
    [[nodiscard]] std::span<const scene::Operation> performed(
        std::span<const scene::Operation> all) const noexcept {
        return all.subspan(begun_, next_ - begun_);
    }

  private:
    std::size_t next_ = 0;   ///< Index of the first operation that is not performed yet.
    std::size_t begun_ = 0;  ///< Value of next_ before the last perform_due().
};

}  // namespace hawser::session
