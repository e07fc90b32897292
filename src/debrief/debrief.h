// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file debrief.h
/// Write the report on an exercise: one HTML file without scripts, with score, events, plots and
/// pictures.

#include <hawser/exercise.h>
#include <hawser/recording.h>

#include <string>

namespace hawser::debrief {

/// Return the report. All text of the exercise is escaped. The page forbids all external content
/// (Content-Security-Policy).
/// @param recording  Recording of the run, for pictures; null: no pictures.
/// @param people  Names and date for the heading; "": none.
[[nodiscard]] std::string to_html(const exercise::Exercise& exercise,
                                  const exercise::Result& result, const exercise::Curves& curves,
                                  const record::Recording* recording,
                                  const std::string& people = {});

}  // namespace hawser::debrief
