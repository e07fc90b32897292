// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file validate.h
/// `hawser validate`: physics against closed and published solutions (docs/validation.md).

#include <string>
#include <vector>

namespace hawser::validate {

/// Run validation cases and print a table.
/// @param cases      Identifiers or names such as "9" or "catenary"; empty: all.
/// @param json_file  File for the results as JSON, "-" for standard output; "": none.
/// @param list       Only list the cases.
/// @param data       Folder with data of others, for cases that read some; "": none.
/// @return 0 if every check passed, 3 if one failed, 1 for an unknown case.
int run_cases(const std::vector<std::string>& cases, const std::string& json_file, bool list,
              const std::string& data = "");

}  // namespace hawser::validate
