// SPDX-License-Identifier: Apache-2.0
#include "live/event_reports.h"

#include "record/event_input.h"
#include "record/scene_info.h"
#include "record/units.h"
#include "record/verdict_words.h"
#include "record/wire_position.h"

#include <fmt/format.h>

#include <array>
#include <cmath>

namespace hawser::live {
namespace {

struct EventText {
    const char* words;  ///< Words after the place.
    const char* unit;   ///< Unit of the value; "": none, "-": not shown, "%": value × 100.
};

/// In the order of EventKind.
constexpr std::array<EventText, kEventKindCount> kEventWords{{
    {"broke at", "N"},
    {"went slack", "-"},
    {"became taut at", "N"},
    {"reached the limit of its drive:", ""},
    {"passed the end of its range by", ""},
    {"was limited to its range; requested:", ""},
    {"the step is less accurate than 1e-8; relative error", ""},
    {"gained mechanical energy without a cause:", "J"},  // a loss: event_words()
    {"is open by", ""},
    {"has a tension that does not match its length; relative error", ""},
    {"the contacts of a step are inaccurate; relative error", ""},
    {"turned too far in one step, by", "rad"},
    {"wire changes to layer", ""},
    {"brake slips at", "N m"},
    {"was released at", "N"},
    {"fastening of the wire broke at", "N"},
    {"drum is empty; tension", "N"},
    {"was cut at a tension of", "N"},
    {"was joined over a distance of", "m"},
    {"was let go at a tension of", "N"},
    {"chain jumped a pocket at", "N"},
    {"has no space for another node; length of the element", "m"},
    {"needs more nodes than its limit; nodes", ""},
    {"yields to the load at", "N"},
    {"load alarm; fraction of the rated load:", "%"},
    {"load alarm ended; fraction of the rated load:", "%"},
    {"opened above its rated load, at", "N"},
    {"found nothing within reach; nearest at", "m"},
    {"has the end of its wire at the fairlead; tension", "N"},
    {"left its guide at", "N"},
    {"returned to its guide at", "N"},
    {"joints were solved approximately; steps so far", ""},
    {"lacks power; withheld", "W"},
    {"has a part that failed; failure mode", ""},
    {"control refused the requested mode", ""},
    {"lost its position; offset", "m"},
    {"would lose its position after the worst single failure; shortfall", ""},
}};
static_assert(kEventWords.back().words != nullptr, "each kind of event has its words");

bool frequent(EventKind kind) { return kind == EventKind::slack || kind == EventKind::taut; }

std::string status_remedy(Status status) {
    switch (status) {
        case Status::wrong_pivot:
            return "inconsistent joints, or a mass near zero: `hawser check` names them; go back "
                   "to a "
                   "restore point";
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
        return record::energy_change(value, "") + "; use a smaller step (settings.step)";
    const EventText& saying = kEventWords[static_cast<std::size_t>(kind)];
    const std::string_view unit = saying.unit;
    std::string out = where.empty() || where == "-" ? std::string(saying.words)
                                                    : fmt::format("{} {}", where, saying.words);
    if (unit == "-") return out;
    if (unit == "%") return fmt::format("{} {:.0f} %", out, 100.0 * value);
    return out + " " +
           (unit.empty() ? fmt::format("{:.4g}", value + 0.0)
                         : record::with_unit(value, std::string(unit)));
}

void send_events(const World& world, std::span<const Event> events, Outbox& out) {
    constexpr int kMaxFrequent = 8, kMaxEvents = 64;
    int reported = 0, often = 0, more = 0;
    const auto tell = [&](const Event& event) {
        if (reported >= kMaxEvents || (frequent(event.kind) && often >= kMaxFrequent)) {
            ++more;
            return;
        }
        ++reported;
        often += frequent(event.kind) ? 1 : 0;
        const std::string where = record::event_label(world, event);
        out.event(
            event.time, to_string(event.kind), where, event.value,
            event_words(where, event.kind, event.value) + record::describe_breaking(world, event));
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
        out.reason = record::finding_sentence(world, verdict.judge, worst, out.element);
        out.remedy = record::remedy_for(world, verdict.judge);
    }
    return out;
}

}  // namespace hawser::live
