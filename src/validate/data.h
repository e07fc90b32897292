// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file data.h
/// Data of others, from the folder of `hawser validate --data`.

#include <string>
#include <vector>

namespace hawser::validate {

void set_data_folder(std::string folder);
/// "": none was given.
[[nodiscard]] const std::string& data_folder();
/// A file in it. @throws std::runtime_error where there is no folder or no such file.
[[nodiscard]] std::string data_file(const std::string& name);
/// Columns of numbers of a text file, tabs or spaces between them, lines without numbers passed
/// over; an entry that is no number is NaN. @throws std::runtime_error
[[nodiscard]] std::vector<std::vector<double>> data_columns(const std::string& name);

}  // namespace hawser::validate
