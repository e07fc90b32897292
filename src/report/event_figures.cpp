// SPDX-License-Identifier: Apache-2.0
#include <hawser/anchor.h>

#include "record/event_input.h"
#include "record/units.h"
#include "report/summary.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

namespace hawser::report {

namespace {

/// Return the importance of an event for the reader of a report.
int event_importance(EventKind kind) {
    switch (kind) {
        case EventKind::line_break:
        case EventKind::weak_link:
        case EventKind::drum_empty:
        case EventKind::chain_jump:
        case EventKind::overload:
        case EventKind::hauled_in:
        case EventKind::lift_off:
        case EventKind::position_lost:
            return 0;
        case EventKind::energy_created:
        case EventKind::joint_open:
        case EventKind::cable_law:
        case EventKind::uncertified:
        case EventKind::warning:
        case EventKind::incomplete:
            return 1;
        case EventKind::fast:
            return 5;
        case EventKind::saturation:
        case EventKind::brake_slip:
        case EventKind::release:
        case EventKind::cut:
        case EventKind::join:
        case EventKind::detach:
        case EventKind::no_node:
        case EventKind::node_limit:
        case EventKind::render:
        case EventKind::alarm:
        case EventKind::missed:
        case EventKind::lay_on:
        case EventKind::shed:
        case EventKind::failure:
        case EventKind::mode_refused:
        case EventKind::failure_critical:
            return 2;
        case EventKind::range:
            return 3;
        case EventKind::input_clamped:
            return 4;
        case EventKind::layer:
        case EventKind::alarm_end:
            return 6;
        case EventKind::taut:
        case EventKind::slack:
            break;
    }
    return 9;
}

const char* unit_of(const World& world, const Event& event) {
    const bool known = event.interaction.valid();
    const auto is = [&](InteractionKind kind) {
        return known && world.interaction_def(event.interaction).kind == kind;
    };
    switch (event.kind) {
        case EventKind::line_break:
        case EventKind::taut:
        case EventKind::release:
        case EventKind::weak_link:
        case EventKind::drum_empty:
        case EventKind::cut:
        case EventKind::detach:
        case EventKind::chain_jump:
        case EventKind::render:
        case EventKind::overload:
        case EventKind::hauled_in:
        case EventKind::lift_off:
        case EventKind::lay_on:
            return "N";
        case EventKind::brake_slip:
            return "N m";
        case EventKind::shed:
            return "W";
        case EventKind::saturation:
            // For the actuator of a vessel a rate or a power.
            if (!known) return "";
            return is(InteractionKind::HingeMotor) ? "N m" : "N";
        case EventKind::range:
            return is(InteractionKind::HingeRange) ? "rad" : "m";
        case EventKind::energy_created:
            return "J";
        case EventKind::joint_open:
        case EventKind::join:
        case EventKind::no_node:
        case EventKind::missed:
        case EventKind::position_lost:
            return "m";
        case EventKind::fast:
            return "rad";
        case EventKind::slack:
        case EventKind::input_clamped:
        case EventKind::warning:
        case EventKind::cable_law:
        case EventKind::uncertified:
        case EventKind::layer:
        case EventKind::node_limit:
        case EventKind::alarm:
        case EventKind::alarm_end:
        case EventKind::incomplete:
        case EventKind::failure:
        case EventKind::mode_refused:
        case EventKind::failure_critical:
            break;
    }
    return "";
}

std::string plural(std::int64_t count, const char* one, const char* many) {
    return fmt::format("{} {}", count, count == 1 ? one : many);
}

/// Return the number of events, for kinds without a figure of their own.
std::string occurrence_text(const EventFigures& e) {
    const char* what = e.kind == EventKind::lift_off ? "wires left their guides "
                       : e.kind == EventKind::lay_on ? "wires returned to their guides "
                                                     : "joints were solved approximately ";
    return what + plural(e.count, "time", "times");
}

/// Return the text for events of anchors. Anchors use the event kinds of winches and wires.
std::string of_anchors(const EventFigures& e) {
    if (e.kind == EventKind::render)
        return "anchors dragged or winches yielded to the load " + plural(e.count, "time", "times");
    return e.kind == EventKind::join
               ? "anchors were set or wires joined " + plural(e.count, "time", "times")
               : "anchors broke out or wires were released " + plural(e.count, "time", "times");
}

/// Return a text with an event and its number of occurrences.
std::string event_text(const EventFigures& e) {
    if (e.anchors) return of_anchors(e);
    switch (e.kind) {
        case EventKind::line_break:
            return plural(e.count, "line broke", "lines broke");
        case EventKind::slack:
            return "lines went slack " + plural(e.count, "time", "times");
        case EventKind::taut:
            return "lines became taut " + plural(e.count, "time", "times");
        case EventKind::saturation:
            return (e.vessels ? "motors and actuators reached their limit "
                              : "motors reached their maximum force ") +
                   plural(e.count, "time", "times");
        case EventKind::range:
            return "joints reached the end of their range " + plural(e.count, "time", "times");
        case EventKind::input_clamped:
            return "inputs were limited to their range " + plural(e.count, "time", "times");
        case EventKind::warning:
            return "steps were less accurate than 1e-8 " + plural(e.count, "time", "times");
        case EventKind::energy_created:
            return "mechanical energy changed without a cause " + plural(e.count, "time", "times");
        case EventKind::joint_open:
            return "joints were open " + plural(e.count, "time", "times");
        case EventKind::cable_law:
            return "tensions did not match the lengths of lines " +
                   plural(e.count, "time", "times");
        case EventKind::uncertified:
            return "contacts were inaccurate " + plural(e.count, "time", "times");
        case EventKind::fast:
            return "bodies turned too far in one step " + plural(e.count, "time", "times");
        case EventKind::layer:
            return "wires changed layers on drums " + plural(e.count, "time", "times");
        case EventKind::brake_slip:
            return "brakes of winches began to slip " + plural(e.count, "time", "times");
        case EventKind::release:
            return plural(e.count, "winch or hook released", "winches or hooks released");
        case EventKind::weak_link:
            return plural(e.count, "weak link broke", "weak links broke");
        case EventKind::drum_empty:
            return "drums ran empty " + plural(e.count, "time", "times");
        case EventKind::cut:
            return plural(e.count, "wire was cut", "wires were cut");
        case EventKind::join:
            return plural(e.count, "joint of wires made", "joints of wires made");
        case EventKind::detach:
            return plural(e.count, "end of a wire released", "ends of wires released");
        case EventKind::chain_jump:
            return "chain jumped a pocket of its gypsy " + plural(e.count, "time", "times");
        case EventKind::no_node:
            return "winches had no space for another node " + plural(e.count, "time", "times");
        case EventKind::render:
            return "winches yielded to the load " + plural(e.count, "time", "times");
        case EventKind::alarm:
            return "load alarms began " + plural(e.count, "time", "times");
        case EventKind::alarm_end:
            return "load alarms ended " + plural(e.count, "time", "times");
        case EventKind::overload:
            return plural(e.count, "stopper or hook opened above its rated load",
                          "stoppers or hooks opened above their rated loads");
        case EventKind::missed:
            return "stoppers and hooks found nothing within reach " +
                   plural(e.count, "time", "times");
        case EventKind::hauled_in:
            return "ends of wires were hauled in to a fairlead or an eye " +
                   plural(e.count, "time", "times");
        case EventKind::lift_off:
        case EventKind::lay_on:
        case EventKind::incomplete:
            return occurrence_text(e);
        case EventKind::shed:
            return "consumers of vessels lacked power " + plural(e.count, "time", "times");
        case EventKind::failure:
            return plural(e.count, "part of a vessel failed", "parts of vessels failed");
        case EventKind::mode_refused:
            return "requested control modes were refused " + plural(e.count, "time", "times");
        case EventKind::position_lost:
            return "vessels lost their position " + plural(e.count, "time", "times");
        case EventKind::failure_critical:
            return "a single failure would lose the position " + plural(e.count, "time", "times");
        case EventKind::node_limit:
            return "wires reached their limit of nodes " + plural(e.count, "time", "times");
    }
    return "";
}

std::string reported(const EventFigures& e, const ListedEvent& event) {
    std::string value;
    if (e.kind == EventKind::energy_created)
        value = fmt::format(", {} {}", event.value < 0.0 ? "lost" : "gained",
                            record::with_unit(std::abs(event.value), e.unit));
    else if (e.kind == EventKind::failure_critical)
        value = fmt::format(", {:.3g} % of the force is missing", 100.0 * event.value);
    else if (e.kind == EventKind::alarm || e.kind == EventKind::alarm_end)
        value = fmt::format(", {:.4g} % of the rated load", 100.0 * event.value);
    else if (*e.unit != '\0')
        value = ", " + record::with_unit(event.value, e.unit);
    else if (e.kind != EventKind::slack && e.kind != EventKind::saturation)
        value = fmt::format(", {:.4g}", event.value + 0.0);
    return fmt::format("{:.4g} s, {}{}{}", event.time, event.where, value, event.note);
}

std::string event_position(const World& world, const Event& event) {
    if (const std::string input = record::input_label(world, event); !input.empty())
        return "the input " + record::name_in_quotes(input);
    if (!event.interaction.valid() && event.body.valid())
        return record::name_in_quotes(record::body_label(world, event.body)) +
               record::origin(world, record::body_label(world, event.body));
    return record::interaction_in_words(world, event.interaction);
}

/// True if an anchor dragged, was set or broke out.
bool is_of_anchor(const World& world, const Event& event) {
    const bool shared = event.kind == EventKind::render || event.kind == EventKind::join ||
                        event.kind == EventKind::detach;
    if (!shared || !event.body.valid()) return false;
    for (const AnchorView& anchor : anchors_of(world))
        if (anchor.def.body == event.body) return true;
    return false;
}

ListedEvent listed(const World& world, const Event& event) {
    return {event.time, to_string(event.kind), event_position(world, event), event.value,
            record::describe_breaking(world, event)};
}

}  // namespace

std::vector<EventFigures> event_figures(const World& world) {
    std::vector<EventFigures> out;
    for (int k = 0; k < kEventKindCount; ++k) {
        const EventExtremes extremes = world.events().extremes(static_cast<EventKind>(k));
        if (extremes.count == 0) continue;
        const bool vessels =
            extremes.first.kind == EventKind::saturation &&
            !(extremes.first.interaction.valid() && extremes.worst.interaction.valid());
        const bool anchors =
            is_of_anchor(world, extremes.first) || is_of_anchor(world, extremes.worst);
        out.push_back({extremes.first.kind, extremes.count, listed(world, extremes.first),
                       listed(world, extremes.worst), unit_of(world, extremes.worst), vessels,
                       anchors});
    }
    std::stable_sort(out.begin(), out.end(), [](const EventFigures& a, const EventFigures& b) {
        return event_importance(a.kind) < event_importance(b.kind);
    });
    return out;
}

std::string event_lines(const Summary& summary) {
    std::string text;
    const auto out = std::back_inserter(text);
    fmt::format_to(out, "\n");
    if (summary.happened.empty()) fmt::format_to(out, "  events       none\n");
    const char* label = "  events       ";
    for (const EventFigures& e : summary.happened) {
        fmt::format_to(out, "{}{}: first at {}\n", std::exchange(label, "               "),
                       event_text(e), reported(e, e.first));
        const bool another = e.worst.time != e.first.time || e.worst.where != e.first.where;
        if (another) fmt::format_to(out, "               worst at {}\n", reported(e, e.worst));
    }
    label = "  timeline     ";
    for (const ListedEvent& e : summary.events)
        if (e.kind == kTimelineEvent)
            fmt::format_to(out, "{}{:.6g} s: {}\n", std::exchange(label, "               "), e.time,
                           e.where);
    return text;
}

}  // namespace hawser::report
