// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file findings.h
/// Findings of each monitor in a state (monitor.h): value relative to its limits, and location.
/// Values come from a sample of the state (measures.h). Data that last between samples are in
/// `memory`.

#include "context/context.h"
#include "context/monitor_data.h"
#include "monitor/energy_account.h"

namespace hawser::monitor {

/// Return the works of forces, drives, drag, friction, contacts and rows since the start, in the
/// order of WorkBy.
[[nodiscard]] context::Works works(const context::State& state) noexcept;

/// Check for mechanical energy that appears or disappears without a recorded work. @param time
/// Time since the last sample [s].
[[nodiscard]] Finding energy_finding(const context::Model& model, const context::State& state,
                                     const context::MonitorPart& p, context::MonitorState& memory,
                                     double time) noexcept;
/// Check for joints that are open beyond the limit.
[[nodiscard]] Finding open_finding(const context::Model& model, const context::State& state,
                                   const context::MonitorPart& p, context::MonitorState& memory,
                                   double time) noexcept;
/// Check for violated ranges. The excess of a coordinate that was forced beyond an end decreases by
/// the factor 4/9 in each step, so that 5 % remain after six samples. The least of six samples is
/// therefore checked.
[[nodiscard]] Finding range_finding(const context::Model& model, const context::State& state,
                                    const context::MonitorPart& p,
                                    context::MonitorState& memory) noexcept;
/// Check for bodies that penetrate each other in six consecutive samples. Return the thinner body.
[[nodiscard]] Finding depth_finding(const context::Model& model, const context::State& state,
                                    const context::MonitorPart& p,
                                    context::MonitorState& memory) noexcept;
/// Check the residuals of the contact law and of the momentum.
[[nodiscard]] Finding solved_finding(const context::StepContext& ctx, context::MonitorState& state,
                                     double time) noexcept;
/// Check the cable law. A line that tightens deviates from it briefly; a line that vibrates does so
/// in every sample.
[[nodiscard]] Finding stretch_finding(const context::Model& model, const context::State& state,
                                      const context::MonitorPart& p,
                                      context::MonitorState& memory) noexcept;
/// Check for bodies or elements with a large rotation in a step.
[[nodiscard]] Finding turn_finding(const context::Model& model, const context::State& state,
                                   const context::MonitorPart& p) noexcept;

}  // namespace hawser::monitor
