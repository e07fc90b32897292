// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file sampled.h
/// Verifies some steps of a run (certificate.h): the first ones, three of every 600, three after an
/// event, and the last ones. Which steps are verified depends on the run alone, never on a clock.
///
/// Left out: loads of the sea, which cost forty times a step, steps that report themselves as not
/// solved, and states. The monitors of the world check those two in every step, and their message
/// has time, place and remedy (docs/limits.md). Momentum and bounds are compared
/// to 1e-5, where `hawser run --verify` compares to 1e-9.

#include "verify/certificate.h"

#include <cstdint>
#include <optional>
#include <string>

namespace hawser::verify {

class SampledVerifier : public Observer {
  public:
    /// @param last  Step with which the run ends.
    SampledVerifier(const World& world, std::int64_t last);
    void before_step(const World& world) override;
    void after_step(const World& world, std::span<const Event> events) override;
    [[nodiscard]] std::string objection() const override { return objection_; }
    [[nodiscard]] std::int64_t steps() const noexcept { return steps_; }

  private:
    std::optional<Verifier> verifier_;  ///< None where groups of bodies may be split.
    std::int64_t last_ = 0, begun_ = 0, steps_ = 0;
    int left_ = 0;  ///< Steps of the present window.
    bool happened_ = false;
    std::string objection_;
};

}  // namespace hawser::verify
