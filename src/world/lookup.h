// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file lookup.h
/// Ids and names that a caller gives.

#include "base/index.h"

#include <hawser/def.h>

#include <cstdint>
#include <string>
#include <string_view>
#include <unordered_map>

namespace hawser::world {

/// Look up an index and refuse one that names nothing.
inline std::size_t index_of(std::int32_t index, int count, const char* what) {
    if (index < 0 || index >= count)
        throw DefError(std::string("there is no ") + what + " with id " + std::to_string(index));
    return at(index);
}

inline void claim(std::unordered_map<std::string, std::int32_t>& names, const std::string& name,
                  std::int32_t index, const char* what) {
    if (name.empty()) return;
    if (!names.emplace(name, index).second)
        throw DefError(std::string(what) + " '" + name + "': the name is taken; names are unique");
}

inline std::int32_t lookup(const std::unordered_map<std::string, std::int32_t>& names,
                           std::string_view name) {
    const auto found = names.find(std::string(name));
    return found == names.end() ? -1 : found->second;
}

}  // namespace hawser::world
