// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file queued_edits.h
/// Edits that systems request during a step, until they are made.

#include <hawser/system.h>

#include <cstddef>
#include <string_view>
#include <variant>
#include <vector>

namespace hawser::world {

/// Definitions and ids in the order of the requests. An addition returns a placeholder with an
/// index below −1: −2 is the first queued body, −3 the second, …
class QueuedEdits final : public Edits::Hands {
  public:
    BodyId add(const BodyDef& def) noexcept override;
    InteractionId add(const InteractionDef& def) noexcept override;
    ShapeId add(const ShapeDef& def) noexcept override;
    WireId add(const WireDef& def) noexcept override;
    void remove(BodyId id) noexcept override { queue_edit(id); }
    void remove(InteractionId id) noexcept override { queue_edit(id); }
    void remove(ShapeId id) noexcept override { queue_edit(id); }
    void remove(WireId id) noexcept override { queue_edit(id); }
    void part(InteractionId id) noexcept override { queue_edit(Part{id}); }

    /// Set the system that requests the following edits.
    void begin_system(std::string_view name) noexcept { system_ = name; }
    void clear() noexcept;
    [[nodiscard]] std::size_t size() const noexcept { return list_.size(); }
    [[nodiscard]] std::size_t left() const noexcept { return list_.size() - done_; }
    [[nodiscard]] bool out_of_memory() const noexcept { return out_of_memory_; }
    /// Return the name of the system that requested the next edit.
    [[nodiscard]] std::string_view next_system() const noexcept { return list_[done_].system; }
    /// Make the next edit.
    /// @throws the exceptions of the function of World. The edit then remains queued.
    void make_next(World& world);

  private:
    struct Part {
        InteractionId id;
    };
    using Edit = std::variant<BodyDef, InteractionDef, ShapeDef, WireDef, BodyId, InteractionId,
                              ShapeId, WireId, Part>;
    struct Entry {
        Edit edit;
        std::string_view system;
    };
    /// Ids of the additions made.
    struct Made {
        std::vector<BodyId> bodies;
        std::vector<InteractionId> interactions;
        std::vector<ShapeId> shapes;
        std::vector<WireId> wires;
    };
    template <class T>
    bool queue_edit(const T& edit) noexcept;
    static void make(const Edit& edit, World& world, Made& made);

    std::vector<Entry> list_;
    std::size_t done_ = 0;
    Made added_ids_;
    /// Numbers of queued additions.
    std::int32_t bodies_ = 0, interactions_ = 0, shapes_ = 0, wires_ = 0;
    std::string_view system_;
    bool out_of_memory_ = false;
};

}  // namespace hawser::world
