// SPDX-License-Identifier: Apache-2.0
#include "session/timeline.h"

#include <hawser/hawser.h>

#include <fmt/format.h>

namespace hawser::session {
namespace {

constexpr double kSlack = 1e-6;  ///< Times are multiples of the step up to rounding.

/// Listens in place of whoever does, for as long as it lives.
class Ear {
  public:
    Ear(World& world, record::ChangeBytes& to) : world_(world) { world.set_change_listener(&to); }
    ~Ear() { world_.set_change_listener(nullptr); }
    Ear(const Ear&) = delete;
    Ear& operator=(const Ear&) = delete;

  private:
    World& world_;
};

}  // namespace

void Timeline::skip(std::span<const scene::Operation> all, const World& world) noexcept {
    const double last = world.time() - (1.0 - kSlack) * world.settings().step;
    while (world.step_count() > 0 && next_ < all.size() && all[next_].at <= last) ++next_;
}

void Timeline::take(std::span<const scene::Operation> all, World& world,
                    record::ChangeBytes* recorder) {
    const double now = world.time() + kSlack * world.settings().step;
    for (; next_ < all.size() && all[next_].at <= now; ++next_) {
        const scene::Operation& operation = all[next_];
        try {
            operation.kind == scene::OperationKind::set
                ? scene::perform(operation, world)
                : change_structure(operation, world, recorder);
        } catch (const DefError& error) {
            throw DefError(fmt::format("timeline, {:.6g} s, {}: {}", operation.at,
                                       scene::to_string(operation), error.what()));
        }
    }
}

void Timeline::change_structure(const scene::Operation& operation, World& world,
                                record::ChangeBytes* recorder) {
    record::ChangeBytes told;
    told.restored(world.save());
    const auto add = [&](std::span<const std::byte> bytes) {
        history_.insert(history_.end(), bytes.begin(), bytes.end());
    };
    if (recorder == nullptr) {
        {
            const Ear ear(world, told);
            scene::perform(operation, world);
        }
        return add(told.bytes());
    }
    const std::size_t before = recorder->bytes().size();
    scene::perform(operation, world);
    add(told.bytes());
    add(recorder->bytes().subspan(before));
}

}  // namespace hawser::session
