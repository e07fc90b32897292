// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file lookup.h
/// Lookup of ids and names from callers.

#include "base/index.h"
#include "base/memory.h"
#include "base/places.h"

#include <hawser/def.h>

#include <cstdint>
#include <functional>
#include <initializer_list>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

namespace hawser::world {

/// Return the index of an id. @throws DefError if the id is invalid or its object has been removed.
template <class Id>
std::size_t slot_index_of(const Id& id, const base::Slots& slots, int count, const char* what) {
    if (id.index >= 0 && id.index < count && slots.names(id)) return at(id.index);
    const std::string number = std::to_string(id.index);
    if (id.index < 0 || id.index >= count)
        throw DefError(std::string("there is no ") + what + " with id " + number);
    throw DefError(std::string("the ") + what + " with id " + number + " of generation " +
                   std::to_string(id.generation) + " has been removed" +
                   (slots.holds(id.index) ? "; another object has its index" : ""));
}

/// Hash for lookups without a copy of the name, which would allocate.
struct NameHash {
    using is_transparent = void;
    std::size_t operator()(std::string_view name) const noexcept {
        return std::hash<std::string_view>{}(name);
    }
};

/// Table from names to indices. Entries of released names are reused, so repeated additions and
/// removals allocate nothing.
class Names {
  public:
    using Map = std::unordered_map<std::string, std::int32_t, NameHash, std::equal_to<>>;
    Names() = default;
    /// Copy the names from another world. Spare entries are not copied.
    Names(const Names& from) : map_(from.map_) {}
    Names& operator=(const Names& from) {
        map_ = from.map_;
        ++changes_;
        return *this;
    }
    Names(Names&&) = default;
    Names& operator=(Names&&) = default;
    ~Names() = default;
    Names(std::initializer_list<Map::value_type> list) : map_(list) {}

    /// Copy the names, with capacity to release each of them.
    /// @throws std::bad_alloc.
    void copy(const Names& from) {
        if (known_ && copied_ == from.changes_) return;
        known_ = false;
        map_ = from.map_;
        base::reserve_more(spare_, map_.size() + 1);
        copied_ = from.changes_;
        known_ = true;
    }
    /// Restore the names of a copy. The copy is invalid afterwards.
    void restore_names(Names& to) noexcept {
        if (to.known_ && to.copied_ == changes_) return;
        map_.swap(to.map_);
        spare_.swap(to.spare_);
        to.known_ = false;
        ++changes_;
    }

    [[nodiscard]] std::size_t size() const noexcept { return map_.size(); }
    [[nodiscard]] bool contains(std::string_view name) const noexcept {
        return map_.find(name) != map_.end();
    }
    /// Return the index of a name; −1 if the name is unused.
    [[nodiscard]] std::int32_t find(std::string_view name) const noexcept {
        const auto found = map_.find(name);
        return found == map_.end() ? -1 : found->second;
    }
    /// Add a name.
    /// @return false if it is in use.
    /// @throws std::bad_alloc.
    bool add(const std::string& name, std::int32_t place) {
        if (contains(name)) return false;
        base::reserve_more(spare_, map_.size() + 1);  // for erase()
        ++changes_;
        if (spare_.empty()) {
            map_.emplace(name, place);
            return true;
        }
        Map::node_type& entry = spare_.back();
        entry.key() = name;
        entry.mapped() = place;
        map_.insert(std::move(entry));
        spare_.pop_back();
        return true;
    }
    void erase(std::string_view name) noexcept {
        const auto found = map_.find(name);
        if (found == map_.end()) return;
        spare_.push_back(map_.extract(found));
        ++changes_;
    }
    /// Extract the entry of a name, to assign it to another index; empty if the name is unused.
    [[nodiscard]] Map::node_type extract_name(std::string_view name) noexcept {
        const auto found = map_.find(name);
        if (found == map_.end()) return {};
        ++changes_;
        return map_.extract(found);
    }
    /// Insert an entry from extract_name() for another index. No entry may have been added since.
    void insert_at(Map::node_type entry, std::int32_t place) noexcept {
        if (entry.empty()) return;
        entry.mapped() = place;
        map_.insert(std::move(entry));
    }

  private:
    Map map_;
    std::vector<Map::node_type> spare_;
    std::uint64_t changes_ = 0;  ///< Count of changes; never decreases.
    // Data of a copy.
    std::uint64_t copied_ = 0;  ///< `changes_` of the original.
    bool known_ = false;
};

inline void claim_name(Names& names, const std::string& name, std::int32_t index,
                       const char* what) {
    if (name.empty()) return;
    if (!names.add(name, index))
        throw DefError(std::string(what) + " '" + name +
                       "': the name is in use; names must be unique");
}

/// Claim a name and call f(). Release the claim if f() throws; f() undoes its own changes.
template <class F>
void reserve_name_for(Names& names, const std::string& name, std::int32_t index, const char* what,
                      F&& f) {
    claim_name(names, name, index, what);
    try {
        f();
    } catch (...) {
        if (!name.empty()) names.erase(name);
        throw;
    }
}

/// Remove the name of a removed object from the index of names.
inline void release(Names& names, const std::string& name) noexcept {
    if (!name.empty()) names.erase(name);
}

inline std::int32_t lookup(const Names& names, std::string_view name) noexcept {
    return names.find(name);
}

}  // namespace hawser::world
