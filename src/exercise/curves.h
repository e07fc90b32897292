// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file curves.h
/// Displays over time, for reports.

#include <hawser/exercise.h>

#include <cstddef>
#include <span>

namespace hawser::exercise {

/// Beyond this number of samples every other one goes, and only every other one is added from then
/// on.
inline constexpr std::size_t kMostSamples = 8192;

/// @param every, seen  Of the curves: steps from sample to sample, steps seen. @param values  Of
/// channels; those of the displays come first, one for each that is named for the first time.
inline void add_sample(Curves& curves, std::size_t& every, std::size_t& seen, double time,
                       std::span<const double> values) {
    if (seen++ % every != 0) return;
    curves.time.push_back(time);
    for (std::size_t k = 0; k < curves.values.size(); ++k)
        curves.values[k].push_back(k < values.size() ? values[k] : kDefault);
    if (curves.time.size() < kMostSamples) return;
    const auto thin = [](std::vector<double>& list) {
        for (std::size_t i = 0; 2 * i < list.size(); ++i) list[i] = list[2 * i];
        list.resize((list.size() + 1) / 2);
    };
    thin(curves.time);
    for (std::vector<double>& list : curves.values) thin(list);
    every *= 2;
}

}  // namespace hawser::exercise
