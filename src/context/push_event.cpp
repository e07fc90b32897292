// SPDX-License-Identifier: Apache-2.0
#include "context/push_event.h"

namespace hawser::context {

void push_event(StepContext& ctx, EventKind kind, std::int32_t id, double value) noexcept {
    ctx.state.events.push({ctx.state.time, kind, ctx.model.interactions.id(id), value});
    ++ctx.work.stats.event_count[static_cast<std::size_t>(kind)];
}

}  // namespace hawser::context
