// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file analysis.h
/// Analysis of a system: its symbolic factorisation, and memory for the data that a step writes by
/// row, row block and body. Splits make their choices before (split/split.h).

#include "context/context.h"

namespace hawser::solve {

/// Store the poses at which the system is analysed, and the drag on each body there.
void begin_analysis(context::Model& model, context::State& state);
/// Analyse the active part of the model at the current poses.
/// @param state  Analysis of a saved world to continue from, or null.
/// @throws std::bad_alloc, LimitError.
void analyse_system(context::Model& model, context::Work& work, runtime::Pool& pool,
                    const factor::AnalysisState* state);
/// Write the figures of an analysis into the statistics.
void count_analysis(context::Model& model, StepStats& stats) noexcept;
/// Count one growth if the model and its system need more memory than in any earlier step.
void count_growth(context::Model& model, StepStats& stats) noexcept;
/// Finish the preparation after additions or removals: memory for a step, and figures of the model.
/// @throws std::bad_alloc.
void finish_preparation(context::StepContext& ctx);
/// Analyse a system without shapes, splits and sleep. If it fails, the system is unchanged.
/// @throws std::bad_alloc, LimitError.
void prepare_alone(context::StepContext& ctx);

}  // namespace hawser::solve
