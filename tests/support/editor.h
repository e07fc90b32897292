// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file editor.h
/// Random edits of several worlds at once, the same in each. They add and remove bodies, joints,
/// wires, shapes, inputs and systems.

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
    /// Each world gets a floor and some boxes. They may differ in threads only.
    Editor(std::uint64_t seed, std::vector<World*> worlds);

    /// One edit that does something, of each world.
    void edit();
    /// So far.
    [[nodiscard]] int edits() const noexcept { return edits_; }
    /// Kinds and how many of each, in one line.
    [[nodiscard]] std::string summary() const;
    /// Bodies that were removed.
    [[nodiscard]] const std::vector<BodyId>& gone() const noexcept { return gone_.bodies; }
    /// Ids of all that was removed, and how many of them a world does not refuse.
    [[nodiscard]] std::size_t gone_count() const noexcept;
    [[nodiscard]] std::size_t not_refused(World& world) const;
    /// Replace one of the worlds by another one.
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
    /// The floor included.
    BodyId any_body() { return any(first().bodies()); }
    // Each returns true if it made a change.
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
    Removed gone_;
    std::vector<WireId> wires_gone_;
    std::vector<InputId> inputs_;
    BodyId floor_;
    int edits_ = 0, names_ = 0;
    std::array<int, static_cast<std::size_t>(Edit::count)> done_{};
};

}  // namespace hawser::test
