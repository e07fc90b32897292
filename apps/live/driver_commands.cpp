// SPDX-License-Identifier: Apache-2.0
/// Perform the commands of clients between two steps.
#include "live/driver.h"
#include "live/pick.h"

#include "record/commands.h"
#include "record/input_range.h"
#include "record/names.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <span>
#include <string>

namespace hawser::live {
namespace {

constexpr std::size_t kMostPoints = 17;   // restore points, including the start
constexpr int kMaxCommands = 512;         // performed between two steps
constexpr double kRestoresAllowed = 0.1;  // [s] time for it that is always allowed

}  // namespace

void Driver::perform_commands() {
    Command command;
    for (int n = 0; n < kMaxCommands && hub_.commands.pop(command); ++n) {
        try {
            perform(command);
        } catch (const DefError& refused) {
            out_.reject(command, refused.what());
        } catch (const exercise::Refused& refused) {
            out_.reject(command, refused.what());
        }
        follow_pieces();
    }
}

void Driver::perform(const Command& command) {
    const double now = session_.time();
    changed_ = true;
    switch (command.kind) {
        case CommandKind::set:
            set_input(command);
            break;
        case CommandKind::pause:
            playing_.perform(command);
            out_.command(now, command, "paused");
            break;
        case CommandKind::resume:
            playing_.perform(command);
            out_.command(now, command, "resumed");
            break;
        case CommandKind::step:
            playing_.perform(command);
            break;
        case CommandKind::rate:
            playing_.perform(command);
            out_.command(now, command, fmt::format("set the rate to {:.3g}", playing_.rate()));
            break;
        case CommandKind::drag:
            drag(command);
            break;
        case CommandKind::release:
        case CommandKind::left:
            drags_.end(session_.world(), command.client);
            break;
        case CommandKind::part:
            part(command);
            break;
        case CommandKind::save:
            save(std::string(command.name.view()));
            out_.command(now, command, fmt::format("saved \"{}\"", command.name.view()));
            break;
        case CommandKind::restore:
            restore(command);
            break;
        case CommandKind::pick:
            out_.send(command.client, picked_object_json(session_.world(), plan_, command));
            return;
        case CommandKind::fault:
            lesson().fault(command);
            out_.command(now, command,
                         fmt::format("{} the fault {}", command.value != 0.0 ? "began" : "ended",
                                     command.name.view()),
                         true);
            break;
        case CommandKind::end:
            lesson().end(command);
            playing_.pause();
            over_ = true;
            out_.command(now, command, "ended the exercise");
            break;
        case CommandKind::note:
            note(command);
            break;
        case CommandKind::report:
            if (!options_.report) throw DefError("this is a scene without an exercise: no report");
            out_.report(command, options_.report(std::string(command.name.view())));
            return;
        case CommandKind::seek:
            throw DefError("this run is live: only recordings can be sought through");
        case CommandKind::none:
            return;
    }
    out_.answer(command);
    if (lesson_ && command.kind != CommandKind::set) lesson_->send_now(out_);
    if (command.kind != CommandKind::set && command.kind != CommandKind::drag) send_state();
}

Lesson& Driver::lesson() {
    if (!lesson_)
        throw DefError("this is a scene without an exercise: it has no faults and no end");
    return *lesson_;
}

void Driver::set_input(const Command& command) {
    record::check_input_range(session_.scene(), command.name.view(), command.value);
    if (lesson_) return lesson_->set_input(command);
    session_.set_input(command.name.view(), command.value);
}

void Driver::drag(const Command& command) {
    World& world = session_.world();
    const Vec3 target(command.target.data()), point(command.point.data());
    if (!command.by_wire)
        return drags_.begin(world, command.client, body_of(world, command.target_id), point, target,
                            command.stiffness);
    const WireSource& wire = find_wire_source(plan_, command);
    if (!wire.wire.valid()) throw DefError("\"" + wire.name + "\" has no nodes to pull at");
    drags_.begin(world, command.client, node_near(world, wire.wire, command.value), Vec3::Zero(),
                 target, command.stiffness);
}

/// Write a remark of the instructor into recording and time line.
void Driver::note(const Command& command) {
    const std::string text = fmt::format("note: {}", command.name.view());
    session_.note(record::kDoneNote, std::as_bytes(std::span(text)));
    out_.command(session_.time(), command, text);
}

void Driver::part(const Command& command) {
    World& world = session_.world();
    const WireSource wire = find_wire_source(plan_, command);
    if (wire.wire.valid())
        world.wires().part(wire.wire, command.value * world.wires().length(wire.wire));
    else if (!wire.pieces.empty() && !wire.pieces.front().joint)
        world.wires().part(wire.pieces.front().element);
    else
        throw DefError("\"" + wire.name + "\" is a chain of rigid links, which does not part");
    const std::string text = fmt::format("parted {} at {:.0f} %", wire.name, 100.0 * command.value);
    session_.note(record::kDoneNote, std::as_bytes(std::span(text)));
    out_.command(session_.time(), command, text);
}

void Driver::check_state_cost(const char* what) const {
    const double wait = states_free_ - clock_now();
    if (wait <= 0.0) return;
    throw DefError(fmt::format(
        "{}: saving and restoring this scene takes {:.2g} s, and would stop the run; try again in "
        "{:.1f} s",
        what, state_seconds_, wait + 0.05));
}

void Driver::count_states(double begun) {
    state_seconds_ = clock_now() - begun;
    const double from = std::max(states_free_, begun - kRestoresAllowed / options_.states_fraction);
    states_free_ = from + state_seconds_ / options_.states_fraction;
}

void Driver::save(const std::string& name) {
    check_state_cost("save");
    const double begun = clock_now();
    drags_.remove_forces(session_.world());
    const World& world = session_.world();
    Point point{name, world.time(), 0, world.state().structure(), world.state().save()};
    const auto same = std::find_if(points_.begin(), points_.end(),
                                   [&](const Point& p) { return p.name == name; });
    if (same == points_.begin() && !points_.empty())
        throw DefError("\"start\" is the start, and stays; give another name");
    if (same == points_.end() && points_.size() >= kMostPoints)
        throw DefError("there are 16 restore points already; use one of their names again");
    if (lesson_) point.mark = lesson_->mark();
    if (same != points_.end()) points_.erase(same);
    points_.push_back(std::move(point));
    count_states(begun);
}

void Driver::restore(const Command& command) {
    const auto at = std::find_if(points_.begin(), points_.end(),
                                 [&](const Point& p) { return p.name == command.name.view(); });
    if (at == points_.end()) {
        std::vector<std::string> names;
        for (const Point& point : points_) names.push_back(point.name);
        throw DefError(fmt::format("there is no restore point \"{}\"; nearest: \"{}\"",
                                   command.name.view(),
                                   record::nearest_name(command.name.view(), names)));
    }
    check_state_cost("restore");
    const double begun = clock_now();
    drags_.end_all(session_.world());
    session_.restore(at->made_of, at->state);
    if (lesson_) {
        lesson_->return_to_mark(at->mark);
        over_ = lesson_->ended();
    }
    failure_.reset();
    playing_.begin_clock();
    count_states(begun);
    out_.command(session_.time(), command,
                 fmt::format("went back to \"{}\" at {:.6g} s", at->name, at->time));
}

}  // namespace hawser::live
