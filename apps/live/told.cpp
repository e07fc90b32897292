// SPDX-License-Identifier: Apache-2.0
#include "live/told.h"

#include "record/event_input.h"
#include "record/scene_info.h"
#include "record/units.h"
#include "record/verdict_words.h"
#include "record/wire_place.h"

#include <fmt/format.h>

#include <array>
#include <cmath>

namespace hawser::live {
namespace {

struct Saying {
    const char* words;  ///< Words after the place.
    const char* unit;   ///< Unit of the value; "": none, "-": the value is not shown.
};

/// In the order of EventKind.
constexpr std::array<Saying, kEventKindCount> kSayings{{
    {"parted at", "N"},
    {"went slack", "-"},
    {"came taut at", "N"},
    {"is driven with all its force,", ""},
    {"reached the end of its range, beyond by", ""},
    {"was asked for a value outside its range:", ""},
    {"left a residual of", ""},
    {"gained mechanical energy without a cause:", "J"},  // a loss: event_words()
    {"stands open by", ""},
    {"has a tension that is not that of its length, off by", ""},
    {"contacts are not solved, residual", ""},
    {"turned too far in a step, by", "rad"},
    {"wire changes to layer", ""},
    {"brake slips at", "N m"},
    {"was released at", "N"},
    {"fastening of the wire parted at", "N"},
    {"drum is empty; tension", "N"},
    {"was cut at", "N"},
    {"was joined over", "m"},
    {"was let go at", "N"},
    {"chain jumped at", "N"},
    {"has no room for another node; element", "m"},
    {"is coarser than asked for, nodes", ""},
    {"gives way at", "N"},
    {"load alarm, share of the rated load", ""},
    {"load alarm over, share of the rated load", ""},
    {"opened above its rated load, at", "N"},
    {"has nothing in reach, the nearest at", "m"},
    {"has the end of its wire at the fairlead; tension", "N"},
    {"left its guide at", "N"},
    {"came back onto its guide at", "N"},
    {"joints were linearised; failed steps", ""},
    {"sheds load, power withheld", "W"},
    {"has a part that failed, mode", ""},
    {"control refused the mode", ""},
    {"lost its position, off by", "m"},
    {"would lose its position by the worst failure, shortfall", ""},
}};
static_assert(kSayings.back().words != nullptr, "each kind of event has its words");

bool frequent(EventKind kind) { return kind == EventKind::slack || kind == EventKind::taut; }

std::string status_remedy(Status status) {
    switch (status) {
        case Status::wrong_pivot:
            return "joints that contradict each other, or a mass next to nothing: `hawser check` "
                   "names them; go back to a restore point";
        case Status::not_finite:
            return "a force or an input is too large; go back to a restore point and use a smaller "
                   "one";
        case Status::out_of_memory:
            return "close other programs, or make the scene smaller";
        case Status::cancelled:
            return "resume";
        default:
            return "go back to a restore point";
    }
}

}  // namespace

std::string event_words(const std::string& where, EventKind kind, double value) {
    if (kind == EventKind::energy_created)
        return record::energy_change(value, "") + "; take a smaller step (settings.step)";
    const Saying& saying = kSayings[static_cast<std::size_t>(kind)];
    const std::string_view unit = saying.unit;
    std::string out = where.empty() || where == "-" ? std::string(saying.words)
                                                    : fmt::format("{} {}", where, saying.words);
    if (unit == "-") return out;
    return out + " " +
           (unit.empty() ? fmt::format("{:.4g}", value + 0.0)
                         : record::with_unit(value, std::string(unit)));
}

void send_events(const World& world, std::span<const Event> events, Outbox& out) {
    constexpr int kMaxFrequent = 8, kMaximum = 64;
    int reported = 0, often = 0, more = 0;
    const auto tell = [&](const Event& event) {
        if (reported >= kMaximum || (frequent(event.kind) && often >= kMaxFrequent)) {
            ++more;
            return;
        }
        ++reported;
        often += frequent(event.kind) ? 1 : 0;
        const std::string where = record::event_label(world, event);
        out.event(event.time, to_string(event.kind), where, event.value,
                  event_words(where, event.kind, event.value));
    };
    for (const Event& event : events)
        if (!frequent(event.kind)) tell(event);
    for (const Event& event : events)
        if (frequent(event.kind)) tell(event);
    if (more > 0)
        out.event(world.time(), "more", "", more, fmt::format("and {} more events", more));
}

Failure failure_of(const World& world, Status status) {
    Failure out{.time = world.time(),
                .status = to_string(status),
                .element = {},
                .reason = to_string(status),
                .remedy = status_remedy(status)};
    const StepStats& stats = world.stats();
    if (status == Status::over_bound) out.reason = to_string(stats.bound_met);
    if (status == Status::bad_load || status == Status::bad_edit) {
        const BadLoad& load = world.bad_load();
        out.element =
            load.body.valid() ? record::body_label(world, load.body) : std::string(load.system);
        out.reason = to_string(load, world);
    }
    if (status == Status::diverged) {
        const Verdict verdict = world.verdict();
        const Finding& worst = verdict.of(verdict.judge);
        if (worst.interaction.valid() || worst.body.valid())
            out.element = record::position_label(world, worst.interaction, worst.body);
        out.reason = record::sentence(world, verdict.judge, worst, out.element);
        out.remedy = record::remedy_for(world, verdict.judge);
    }
    return out;
}

}  // namespace hawser::live
