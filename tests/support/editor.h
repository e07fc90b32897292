// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file editor.h
/// Random edits of several worlds at once, the same of each: bodies, joints, wires, shapes and
/// inputs come and go.

#include <hawser/world.h>

#include "support/random.h"

#include <vector>

namespace hawser::test {

class Editor {
  public:
    /// Each world gets a floor and some boxes. They may differ in threads only.
    Editor(std::uint64_t seed, std::vector<World*> worlds);

    /// One edit, of each world.
    void edit();
    /// So far, by what was done.
    [[nodiscard]] int edits() const noexcept { return edits_; }
    /// Ids of bodies that were removed; they are refused for ever.
    [[nodiscard]] const std::vector<BodyId>& gone() const noexcept { return gone_; }
    /// Another world takes the place of one.
    void replace(std::size_t index, World& world) noexcept { worlds_[index] = &world; }

  private:
    World& first() noexcept { return *worlds_.front(); }
    BodyId add(const BodyDef& def);
    InteractionId add(const InteractionDef& def);
    void add(const ShapeDef& def);
    BodyId any_body();
    void add_box();
    void add_joint();
    void add_wire();
    void add_shape();
    void add_input();
    void remove_body();
    void remove_interaction();
    void remove_shape();
    void set_input();

    Random random_;
    std::vector<World*> worlds_;
    std::vector<BodyId> gone_;
    std::vector<InputId> inputs_;
    BodyId floor_;
    int edits_ = 0, names_ = 0;
};

}  // namespace hawser::test
