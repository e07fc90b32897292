// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file data.h
/// External data, from the folder of `hawser validate --data`.

#include <string>
#include <vector>

namespace hawser::validate {

void set_data_folder(std::string folder);
/// Return the folder with measured data for the cases (option --data); "" if the option is absent.
[[nodiscard]] const std::string& data_folder();
/// Return the path of a file in data_folder(). @throws std::runtime_error if there is no folder or
/// no such file.
[[nodiscard]] std::string data_file(const std::string& name);
/// Return the columns of numbers of a text file, separated by tabs or spaces. Lines without numbers
/// are skipped; an entry that is no number becomes NaN. @throws std::runtime_error
[[nodiscard]] std::vector<std::vector<double>> data_columns(const std::string& name);

}  // namespace hawser::validate
