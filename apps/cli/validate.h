// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file validate.h
/// The command `hawser validate`: cases with a known answer.

#include <string>
#include <vector>

/// Run validation cases and print a table.
/// @param cases     Names of cases; empty = all.
/// @param json_file Where to write the results as JSON; empty = nowhere.
/// @param list      Only print the names of the cases.
/// @return 0 when all are within tolerance, 1 for an unknown case, 3 when one is not.
int run_validate(const std::vector<std::string>& cases, const std::string& json_file, bool list);
