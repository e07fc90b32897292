// SPDX-License-Identifier: Apache-2.0
#include "live/random_messages.h"

#include "live/run.h"
#include "machine/failing.h"

#include "support/repeat.h"

#include <fmt/format.h>
#include <gtest/gtest-spi.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <ctime>
#include <limits>
#include <memory>
#include <optional>
#include <utility>

namespace hawser::test {
namespace {

double thread_seconds() {
    timespec t{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
    return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

/// Return the tow of live_scene() with an input without a range, which makes steps fail.
std::string rangeless_tow() {
    std::string text = live_scene();
    const std::string before = R"("inputs": [)";
    text.insert(text.find(before) + before.size(),
                R"({"name": "shove", "body": "load", "component": "force_y"}, )");
    return text;
}

/// Balls and boxes on a floor, with more contacts than the limit if clients push them together.
const char* const kYard = R"({
  "version": 1, "name": "yard",
  "settings": {"step": 0.016666666666666666, "max_contacts": 20, "sleep_speed": 0.02},
  "line_types": {"wire": {"mass_per_length": 2, "EA": 2e6, "diameter": 0.04}},
  "material_pairs": [{"between": ["default", "default"], "friction": 0.5}],
  "bodies": [
    {"name": "floor", "kind": "fixed", "shapes": [{"kind": "plane"}]},
    {"name": "box1", "mass": 50, "box": [0.5, 0.5, 0.5], "position": [0, 0, 0.5],
     "shapes": [{"kind": "box", "half_size": [0.5, 0.5, 0.5]}]},
    {"name": "box2", "mass": 50, "box": [0.5, 0.5, 0.5], "position": [3, 0, 0.5],
     "shapes": [{"kind": "box", "half_size": [0.5, 0.5, 0.5]}]},
    {"name": "box3", "mass": 50, "box": [0.5, 0.5, 0.5], "position": [0, 3, 0.5],
     "shapes": [{"kind": "box", "half_size": [0.5, 0.5, 0.5]}]},
    {"name": "ball1", "mass": 20, "sphere": 0.4, "position": [3, 3, 0.4],
     "shapes": [{"kind": "sphere", "radius": 0.4}]},
    {"name": "ball2", "mass": 20, "sphere": 0.4, "position": [-2, 0, 0.4],
     "shapes": [{"kind": "sphere", "radius": 0.4}]}],
  "cables": [{"name": "tie", "line_type": "wire", "from": {"body": "ball1"},
              "to": {"body": "ball2"}, "length": 6, "elements": 6, "shape": "straight"}],
  "inputs": [
    {"name": "push1", "body": "box1", "component": "force_x", "min": -2000, "max": 2000},
    {"name": "push2", "body": "box2", "component": "force_x", "min": -2000, "max": 2000},
    {"name": "push3", "body": "box3", "component": "force_y", "min": -2000, "max": 2000},
    {"name": "shove", "body": "ball1", "component": "force_y"}]
})";

/// Return the last body that moves in space; invalid if there is none.
BodyId last_mover(const World& w) {
    BodyId found{};
    for (const BodyId id : w.bodies()) {
        const BodyKind kind = w.body_def(id).kind;
        if (kind == BodyKind::lump || kind == BodyKind::rigid) found = id;
    }
    return found;
}

/// Fails steps on demand.
class StepBreaker final : public System {
  public:
    enum class Cause { none, nan, input, edit, cancel, pivot, late };
    [[nodiscard]] std::string_view name() const noexcept override { return "breaker"; }
    void prestep(Prestep& now, Loads& loads) noexcept override {
        const BodyId body = last_mover(now.world);
        if (!body.valid()) return;
        if (cause == Cause::nan)
            loads.add_force(body, Vec3::Constant(std::numeric_limits<double>::quiet_NaN()));
        if (cause == Cause::input) now.set_input(InputId{9999}, 1.0);
        if (cause == Cause::edit) {
            (void)now.edits.add_body({.name = "late", .kind = BodyKind::lump, .mass = 1.0});
            now.edits.remove_body(BodyId{9999});
        }
        if (cause == Cause::cancel) world->cancel();
        if (cause == Cause::pivot) loads.add_damping(body, Mat3(Mat3::Identity() * 1e308));
        if (cause == Cause::late) loads.add_force(body, Vec3::Constant(1e300));
    }

    Cause cause = Cause::none;
    World* world = nullptr;
};

StepBreaker::Cause cause_of(const std::string& line) {
    constexpr std::array<std::pair<std::string_view, StepBreaker::Cause>, 7> kCauses{
        {{"!nan", StepBreaker::Cause::nan},
         {"!input", StepBreaker::Cause::input},
         {"!edit", StepBreaker::Cause::edit},
         {"!cancel", StepBreaker::Cause::cancel},
         {"!pivot", StepBreaker::Cause::pivot},
         {"!late", StepBreaker::Cause::late},
         {"!memory", StepBreaker::Cause::late}}};
    for (const auto& [name, cause] : kCauses)
        if (line.starts_with(name)) return cause;
    return StepBreaker::Cause::none;
}

/// A session that lines drive, without a server.
class Driven {
  public:
    Driven(int session, const std::filesystem::path& file)
        : run(message_session(session)),
          breaker_(
              &static_cast<StepBreaker&>(run.world().add_system(std::make_unique<StepBreaker>()))) {
        breaker_->world = &run.world();
        run.record(file);
        driver_.emplace(run, hub_, live::DriverOptions{.paused = true, .states_fraction = 1e6});
        figures.by_status.resize(16);
    }

    /// @return true if the last step failed.
    bool take(const std::string& line) {
        if (line.starts_with("!")) {
            breaker_->cause = cause_of(line);
            if (line.starts_with("!memory")) fail_for_memory(std::atol(line.c_str() + 8));
            return failed_;
        }
        live::Request request;
        std::string reason;
        if (!live::parse(line, request, reason)) return failed_;
        ++figures.taken;
        for (live::Command& command : request.commands) {
            command.client = 1 + static_cast<std::uint32_t>(line.size() % 3);
            (void)hub_.commands.push(std::move(command));
        }
        for (int loops = 0; loops == 0 || (!driver_->paused() && loops < 5); ++loops) loop();
        return failed_;
    }

    void finish() {
        figures.steps = driver_->figures().steps;
        (void)run.finish();
    }

    Session run;
    MessageFigures figures;

  private:
    void loop() {
        const double begin = thread_seconds();
        const std::int64_t before = run.world().step_count();
        driver_->advance();
        figures.longest = std::max(figures.longest, thread_seconds() - begin);
        const bool now = drop_messages();
        if (now || run.world().step_count() != before) breaker_->cause = StepBreaker::Cause::none;
        if (now) count(run.world().stats().status);
        failed_ = now || (failed_ && run.world().step_count() == before);
    }
    void count(Status status) {
        ++figures.failures;
        ++figures.by_status[static_cast<std::size_t>(status)];
    }
    /// The step would fail later anyway, so that nothing but the failed step is tried.
    void fail_for_memory(long at) {
        Status status = Status::ok;
        {
            const failing::Memory memory(at);
            status = run.world().step();
        }
        breaker_->cause = StepBreaker::Cause::none;
        if (status != Status::ok) return count(status);
        // A body that nothing holds reaches 1e298 m/s. The recording has no frame of this step.
        (void)take(R"({"type":"restore","name":"start"})");
    }
    /// @return true if a step has failed according to the messages to clients.
    bool drop_messages() {
        live::Message message;
        bool failed = false;
        while (hub_.messages.pop(message))
            failed = failed || message.text.find(R"("type":"failure")") != std::string::npos;
        return failed;
    }

    StepBreaker* breaker_;
    live::Hub hub_;
    std::optional<live::Driver> driver_;
    bool failed_ = false;
};

}  // namespace

SessionDef message_session(int session) {
    constexpr std::array kFiles{"crane_knuckle", "wire_pins", "tow_payout"};
    const auto kind = static_cast<std::size_t>(session) % kMessageScenes;
    SessionDef def;
    def.options.threads = session % 6 == 5 ? 2 : 1;
    // A replay repeats the work that a step left out.
    if (session % 3 == 2) def.options.budget_work = 2e4;
    if (session % 7 == 3) def.options.budget = 1e-4;
    if (kind == 0)
        def.scene_text = rangeless_tow();
    else if (kind == 1)
        def.scene_text = kYard;
    else
        def.scene = fmt::format("scenes/{}.json", kFiles[kind - 2]);
    return def;
}

Sender::Sender(const World& world, std::uint32_t seed)
    : random_(seed),
      bodies_(static_cast<std::int32_t>(world.bodies().size())),
      wires_(static_cast<std::int32_t>(world.wires().ids().size())) {
    for (const InputId id : world.inputs()) names_.push_back(world.input_def(id).name);
    for (const SystemSignal& s : world.system_signals())
        if (s.input) names_.push_back(s.system + "." + s.name);
    names_.emplace_back("nothing of this name");
}

const std::string& Sender::name() {
    return names_[static_cast<std::size_t>(
        random_.integer(0, static_cast<int>(names_.size()) - 1))];
}

double Sender::any_value() {
    constexpr std::array kSpecial{0.0,    -0.0,    1.0,   -1.0,   0.5,   64.0,
                                  1e-320, -1e-320, 1e7,   -1e7,   1e30,  -1e30,
                                  1e300,  -1e300,  1e308, -1e308, 1e-12, 2147483648.0};
    if (random_.chance(0.3))
        return kSpecial[static_cast<std::size_t>(
            random_.integer(0, static_cast<int>(kSpecial.size()) - 1))];
    if (random_.chance(0.1))
        return random_.uniform(-1, 1) * std::pow(10.0, random_.uniform(-320, 308));
    return random_.uniform(-2.0, 2.0);
}

double Sender::place() { return random_.chance(0.1) ? any_value() : random_.uniform(-80, 80); }

std::string Sender::cause() {
    constexpr std::array kCauses{"!nan", "!input", "!edit", "!cancel", "!pivot", "!late"};
    if (random_.chance(0.5))
        return fmt::format("!memory {}", random_.integer(0, random_.chance(0.5) ? 20 : 400));
    return kCauses[static_cast<std::size_t>(
        random_.integer(0, static_cast<int>(kCauses.size()) - 1))];
}

std::string Sender::drag() {
    const double stiffness = random_.chance(0.5) ? 0.0 : std::abs(any_value());
    if (random_.chance(0.4))
        return fmt::format(R"({{"type":"drag","wire":{},"s":{},"target":[{},{},{}]}})",
                           random_.integer(-1, wires_), random_.unit(), place(), place(), place());
    return fmt::format(
        R"({{"type":"drag","body":{},"point":[{},{},0],"target":[{},{},{}],"stiffness":{}}})",
        random_.integer(-1, bodies_), near(), near(), place(), place(), place(), stiffness);
}

std::string Sender::set() {
    if (random_.chance(0.7))
        return fmt::format(R"({{"type":"set","input":"{}","value":{},"id":1}})", name(),
                           any_value());
    std::string list;
    for (int k = random_.integer(1, 6); k > 0; --k)
        list += fmt::format(R"({}["{}",{}])", list.empty() ? "" : ",", name(), any_value());
    return R"({"type":"set","inputs":[)" + list + "]}";
}

std::string Sender::next(bool failed) {
    // Clients often correct the input for which a step failed.
    if (failed && random_.chance(0.4)) return R"({"type":"set","input":"shove","value":0,"id":1})";
    switch (random_.integer(0, 12)) {
        case 0:
        case 1:
        case 2:
            return set();
        case 3:
        case 4:
            return drag();
        case 5:
            return R"({"type":"release"})";
        case 6:
            if (random_.chance(0.2)) return R"({"type":"resume"})";
            if (!random_.chance(0.1)) return R"({"type":"pause"})";
            return fmt::format(R"({{"type":"part","wire":{},"s":{}}})", random_.integer(0, wires_),
                               random_.unit());
        case 7:
            return fmt::format(R"({{"type":"save","name":"{}"}})", random_.integer(0, 20));
        case 8:
            if (random_.chance(0.5)) return R"({"type":"restore","name":"start"})";
            return fmt::format(R"({{"type":"restore","name":"{}"}})", random_.integer(0, 20));
        case 9:
            return random_.chance(0.5) ? cause() : R"({"type":"step","count":1})";
        default:
            return fmt::format(R"({{"type":"step","count":{}}})", random_.integer(1, 3));
    }
}

void MessageFigures::add(const MessageFigures& other) {
    steps += other.steps;
    failures += other.failures;
    taken += other.taken;
    longest = std::max(longest, other.longest);
    by_status.resize(std::max(by_status.size(), other.by_status.size()));
    for (std::size_t i = 0; i < other.by_status.size(); ++i) by_status[i] += other.by_status[i];
}

MessageFigures run_random(int session, int count, std::uint32_t seed,
                          const std::filesystem::path& file, Lines& lines) {
    Driven driven(session, file);
    Sender sender(driven.run.world(), seed);
    bool failed = false;
    lines.clear();
    for (int i = 0; i < count; ++i) {
        lines.push_back(sender.next(failed));
        failed = driven.take(lines.back());
    }
    driven.finish();
    return driven.figures;
}

MessageFigures run_lines(int session, const Lines& lines, const std::filesystem::path& file) {
    Driven driven(session, file);
    for (const std::string& line : lines) (void)driven.take(line);
    driven.finish();
    return driven.figures;
}

std::string replay_difference(const std::filesystem::path& file) {
    testing::TestPartResultArray found;
    try {
        const testing::ScopedFakeTestPartResultReporter catcher(
            testing::ScopedFakeTestPartResultReporter::INTERCEPT_ALL_THREADS, &found);
        (void)expect_repeats(record::Recording::open(file), 1);
    } catch (const std::exception& error) {
        return error.what();
    }
    return found.size() == 0 ? "" : found.GetTestPartResult(0).message();
}

std::uint64_t end_hash(const std::filesystem::path& file) {
    return record::Recording::open(file).end_hash;
}

Lines shortest(int session, Lines lines, const std::filesystem::path& file) {
    const auto differs = [&](const Lines& some) {
        try {
            (void)run_lines(session, some, file);
        } catch (const std::exception&) {
            return true;
        }
        return !replay_difference(file).empty();
    };
    for (std::size_t piece = std::max<std::size_t>(1, lines.size() / 2);;) {
        bool removed = false;
        for (std::size_t at = 0; at < lines.size();) {
            Lines fewer = lines;
            const auto begin = fewer.begin() + static_cast<std::ptrdiff_t>(at);
            const auto end =
                fewer.begin() + static_cast<std::ptrdiff_t>(std::min(at + piece, fewer.size()));
            fewer.erase(begin, end);
            if (differs(fewer)) {
                lines = std::move(fewer);
                removed = true;
            } else {
                at += piece;
            }
        }
        if (piece == 1 && !removed) return lines;
        if (!removed) piece = (piece + 1) / 2;
    }
}

}  // namespace hawser::test
