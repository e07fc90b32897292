// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file debrief.h
/// The report on an exercise: one HTML file without scripts, with score, events, plots and
/// pictures.

#include <hawser/exercise.h>
#include <hawser/recording.h>

#include <string>

namespace hawser::debrief {

/// @param recording  Of the run, for pictures; null: none. All text of the exercise is escaped, and
/// the page forbids itself everything from elsewhere (Content-Security-Policy).
[[nodiscard]] std::string to_html(const exercise::Exercise& exercise,
                                  const exercise::Result& result, const exercise::Curves& curves,
                                  const record::Recording* recording);

}  // namespace hawser::debrief
