// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file judge_start.h
/// The judge's ledger where a world begins.

namespace hawser::stepper {

struct JudgeState;

/// Velocities at the start have been put half a step back: what kinetic energy that gained is work
/// done by the time of the start, which no account has [J]. Of a body at rest under a force F it is
/// ½ m (F h/2m)²: the works of the first step, from half a step before the start to half a step
/// after it, are zero, and the body moves all the same.
void excuse_start(double gained, JudgeState& state) noexcept;

}  // namespace hawser::stepper
