// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file editor.h
/// Random edits applied equally to several worlds: bodies, joints, wires, shapes, inputs and
/// systems are added and removed.

#include <hawser/world.h>

#include "support/random.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace hawser::test {

/// Kinds of edits.
enum class Edit { body, joint, wire, shape, input, system, part, remove, set, count };

class Editor {
  public:
    /// Add a floor and some boxes to each world. Worlds may differ only in threads.
    Editor(std::uint64_t seed, std::vector<World*> worlds);

    /// Apply one effective edit to each world.
    void edit();
    /// Return the number of edits since the start.
    [[nodiscard]] int edits() const noexcept { return edits_; }
    /// Return the kinds and counts of edits in one line.
    [[nodiscard]] std::string summary() const;
    /// Return the removed bodies.
    [[nodiscard]] const std::vector<BodyId>& removed_bodies() const noexcept {
        return removed_.bodies;
    }
    /// Return the number of removed ids, and the number of these that a world still accepts.
    [[nodiscard]] std::size_t removed_count() const noexcept;
    [[nodiscard]] std::size_t accepted_removed_count(World& world) const;
    /// Replace one of the worlds.
    void replace(std::size_t index, World& world) noexcept { worlds_[index] = &world; }

  private:
    World& first() noexcept { return *worlds_.front(); }
    BodyId add(const BodyDef& def);
    InteractionId add(const InteractionDef& def);
    void add(const ShapeDef& def);
    template <class T>
    T any(std::span<const T> ids) {
        return ids[static_cast<std::size_t>(random_.integer(0, static_cast<int>(ids.size()) - 1))];
    }
    /// Return any body, including the floor.
    BodyId any_body() { return any(first().bodies()); }
    // Apply an edit of a kind. @return true if it had an effect.
    bool act(Edit kind);
    bool add_box();
    bool add_body();
    bool add_joint();
    bool add_chain();
    bool add_wire();
    bool add_shape();
    bool add_input();
    bool add_system();
    bool part_wire();
    bool remove_any();
    bool remove_body();
    bool remove_wire();
    bool remove_system();
    template <class Id, class F>
    bool remove(Id id, F&& call);
    bool set_any();
    bool set_input();

    Random random_;
    std::vector<World*> worlds_;
    Removed removed_;
    std::vector<WireId> removed_wires_;
    std::vector<InputId> inputs_;
    BodyId floor_;
    int edits_ = 0, names_ = 0;
    std::array<int, static_cast<std::size_t>(Edit::count)> done_{};
};

}  // namespace hawser::test
