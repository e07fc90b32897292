// SPDX-License-Identifier: Apache-2.0
#include "validate/data.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <utility>

namespace hawser::validate {
namespace {

std::string& folder() {
    static std::string name;
    return name;
}

}  // namespace

void set_data_folder(std::string name) { folder() = std::move(name); }
const std::string& data_folder() { return folder(); }

std::string data_file(const std::string& name) {
    if (folder().empty())
        throw std::runtime_error("it needs data of others: give their folder with --data");
    const std::filesystem::path path = std::filesystem::path(folder()) / name;
    if (!std::filesystem::exists(path))
        throw std::runtime_error("'" + path.string() + "' is not there");
    return path.string();
}

std::vector<std::vector<double>> data_columns(const std::string& name) {
    std::ifstream in(data_file(name));
    std::vector<std::vector<double>> out;
    for (std::string line; std::getline(in, line);) {
        std::istringstream cells(line);
        std::vector<double> row;
        for (std::string cell; std::getline(cells, cell, '\t');) {
            std::istringstream word(cell);
            double value = 0.0;
            row.push_back(word >> value ? value : std::nan(""));
        }
        if (row.empty() || std::isnan(row[0])) continue;
        out.resize(std::max(out.size(), row.size()));
        for (std::size_t k = 0; k < out.size(); ++k)
            out[k].push_back(k < row.size() ? row[k] : std::nan(""));
    }
    return out;
}

}  // namespace hawser::validate
