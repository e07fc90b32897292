// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file curves.h
/// Sample the displays over time, for reports.

#include <hawser/exercise.h>

#include <cstddef>
#include <span>

namespace hawser::exercise {

/// Largest number of samples. When it is reached, every second sample is removed and the sampling
/// interval doubles.
inline constexpr std::size_t kMaxSamples = 8192;

/// Add a sample if the sampling interval has passed.
/// @param every   Sampling interval of the curves [steps]; in and out.
/// @param seen    Number of steps since the start; in and out.
/// @param values  Values of channels. Those of the displays come first, without duplicates.
inline void add_sample(Curves& curves, std::size_t& every, std::size_t& seen, double time,
                       std::span<const double> values) {
    if (seen++ % every != 0) return;
    curves.time.push_back(time);
    for (std::size_t k = 0; k < curves.values.size(); ++k)
        curves.values[k].push_back(k < values.size() ? values[k] : kDefault);
    if (curves.time.size() < kMaxSamples) return;
    const auto thin = [](std::vector<double>& list) {
        for (std::size_t i = 0; 2 * i < list.size(); ++i) list[i] = list[2 * i];
        list.resize((list.size() + 1) / 2);
    };
    thin(curves.time);
    for (std::vector<double>& list : curves.values) thin(list);
    every *= 2;
}

}  // namespace hawser::exercise
