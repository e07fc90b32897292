// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file analysis.h
/// The analysis of a system: its symbolic factorisation, and room for what a step writes by row,
/// strip and body. Splits choose before what belongs to it (split/split.h).

#include "context/context.h"

namespace hawser::stepper {

/// Keep the poses that an analysis is made at, and what drag does to each body then.
void begin_analysis(Model& model, State& state);
/// Analyse what is not left out, at the poses at hand. @param state  Of the analysis of a saved
/// world, to go on from. @throws std::bad_alloc, LimitError.
void analyse_system(Model& model, Work& work, runtime::Pool& pool,
                    const factor::AnalysisState* state);
/// The statistics of an analysis.
void count_analysis(Model& model, StepStats& stats) noexcept;
/// Memory beyond what the model and its system ever held is one growth.
void count_growth(Model& model, StepStats& stats) noexcept;
/// What has been added or removed is in the system: room for a step of it, and figures of the
/// model.
/// @throws std::bad_alloc.
void finish_preparation(StepContext& ctx);
/// Analyse a system without shapes, splits and sleep. Where it fails the system is as it was.
/// @throws std::bad_alloc, LimitError.
void prepare_alone(StepContext& ctx);

}  // namespace hawser::stepper
