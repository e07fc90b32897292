// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file lookup.h
/// Ids and names that a caller gives.

#include "base/index.h"
#include "base/places.h"

#include <hawser/def.h>

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <unordered_map>

namespace hawser::world {

/// The place that an id names; refuses one of nothing, and one of what has been removed.
template <class Id>
std::size_t place_of(const Id& id, const base::Places& places, int count, const char* what) {
    if (id.index >= 0 && id.index < count && places.names(id)) return at(id.index);
    const std::string number = std::to_string(id.index);
    if (id.index < 0 || id.index >= count)
        throw DefError(std::string("there is no ") + what + " with id " + number);
    throw DefError(std::string("the ") + what + " with id " + number + " of generation " +
                   std::to_string(id.generation) + " has been removed" +
                   (places.holds(id.index) ? "; another one has its place" : ""));
}

/// To be looked up without a copy of the name, which would need memory.
struct NameHash {
    using is_transparent = void;
    std::size_t operator()(std::string_view name) const noexcept {
        return std::hash<std::string_view>{}(name);
    }
};
using Names = std::unordered_map<std::string, std::int32_t, NameHash, std::equal_to<>>;

inline void claim(Names& names, const std::string& name, std::int32_t index, const char* what) {
    if (name.empty()) return;
    if (!names.emplace(name, index).second)
        throw DefError(std::string(what) + " '" + name + "': the name is taken; names are unique");
}

/// A claim is given back where f() throws; what f() did it takes back itself.
template <class F>
void claim_for(Names& names, const std::string& name, std::int32_t index, const char* what, F&& f) {
    claim(names, name, index, what);
    try {
        f();
    } catch (...) {
        if (!name.empty()) names.erase(name);
        throw;
    }
}

/// What had the name is gone.
inline void release(Names& names, const std::string& name) noexcept {
    if (!name.empty()) names.erase(name);
}

inline std::int32_t lookup(const Names& names, std::string_view name) noexcept {
    const auto found = names.find(name);
    return found == names.end() ? -1 : found->second;
}

}  // namespace hawser::world
