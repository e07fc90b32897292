// SPDX-License-Identifier: Apache-2.0
#include "live/driver.h"

#include "live/scene_text.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace hawser::live {
namespace {

constexpr double kFarFromOrigin =
    2000.0;                         // [m] distance from which single precision becomes visible
constexpr int kLookAtOrigin = 300;  // steps

/// Return a point near the moving bodies, rounded to few digits.
Vec3 view_centre(const World& world, const FramePlan& plan) {
    Vec3 sum = Vec3::Zero();
    const std::vector<BodyId>& bodies = !plan.rigid.empty() ? plan.rigid : plan.lumps;
    for (const BodyId id : bodies) sum += world.pose(id).position;
    if (bodies.empty()) return sum;
    sum /= static_cast<double>(bodies.size());
    for (int k = 0; k < 3; ++k) sum[k] = 10.0 * std::round(sum[k] / 10.0);
    sum.z() = 0.0;
    return sum;
}

}  // namespace

Driver::Driver(Session& session, Hub& hub, const DriverOptions& options)
    : session_(session),
      hub_(hub),
      options_(options),
      out_(hub),
      plan_(FramePlan::of(session.scene())),
      playing_(options.paused) {
    if (options_.run != nullptr) lesson_.emplace(*options_.exercise, *options_.run);
    origin_ = view_centre(session_.world(), plan_);
    notes_.epoch = 1;
    save("start");
    send_scene();
    send_state();
    if (lesson_) lesson_->send_now(out_);
    publish();
}

void Driver::send_scene() {
    out_.scene(
        text_of(scene_json(session_.scene(), plan_, {.epoch = notes_.epoch, .origin = origin_})));
    reported_ = out_.flush();
}

void Driver::send_state() {
    Json points = Json::array();
    for (const Point& point : points_)
        points.push_back({{"name", point.name}, {"time", point.time}});
    Json state{{"type", "state"},
               {"paused", playing_.paused()},
               {"rate", playing_.rate()},
               {"time", session_.time()},
               {"restore_points", points},
               {"range", nullptr},
               {"recording", options_.recording.empty() ? Json(nullptr) : Json(options_.recording)},
               {"clients", hub_.clients.load(std::memory_order_relaxed)},
               {"failure", nullptr}};
    if (failure_)
        state["failure"] = {{"type", "failure"},
                            {"time", failure_->time},
                            {"status", failure_->status},
                            {"element", failure_->element},
                            {"reason", failure_->reason},
                            {"remedy", failure_->remedy},
                            {"restore_point", points_.back().name}};
    out_.state(state);
    reported_ = out_.flush();
}

/// Update the frame plan after the last step or a command has added or removed objects of the
/// world.
void Driver::follow_pieces() {
    if (plan_.current(session_.world())) return;
    FramePlan next = FramePlan::of(session_.scene());
    const bool same = next.is_same_scene(plan_);
    plan_ = std::move(next);
    if (same) return;
    ++notes_.epoch;
    send_scene();
}

void Driver::follow_origin() {
    if (session_.world().step_count() % kLookAtOrigin != 0) return;
    const Vec3 middle = view_centre(session_.world(), plan_);
    if ((middle - origin_).norm() < kFarFromOrigin) return;
    origin_ = middle;
    ++notes_.epoch;
    send_scene();
}

void Driver::publish() {
    const World& world = session_.world();
    notes_.flags =
        static_cast<std::uint16_t>((playing_.paused() ? kPaused : 0) | (failure_ ? kFailed : 0) |
                                   (drags_.any() ? kDragged : 0));
    notes_.deadline_ms = 1e3 * world.settings().step / playing_.rate();
    notes_.late_ms = 1e3 * playing_.delay();
    ++notes_.number;
    if (lesson_) notes_.shown = lesson_->frozen(world, plan_);
    // Clients cannot use frames without the scene.
    if (!reported_) reported_ = out_.flush();
    if (!reported_) return;
    Bytes& frame = hub_.frames.back();
    writer_.write(world, plan_, origin_, notes_, frame);
    figures_.frame_bytes = std::max(figures_.frame_bytes, frame.size());
    ++figures_.frames;
    hub_.frames.publish();
    hub_.wake();
    playing_.note_shown();
    changed_ = false;
}

void Driver::fail(Failure failure) {
    failure_ = std::move(failure);
    playing_.pause();
    out_.send(0, {{"type", "failure"},
                  {"time", failure_->time},
                  {"status", failure_->status},
                  {"element", failure_->element},
                  {"reason", failure_->reason},
                  {"remedy", failure_->remedy},
                  {"restore_point", points_.back().name}});
    send_state();
}

void Driver::step() {
    World& world = session_.world();
    drags_.before_step(world);
    Status status = Status::ok;
    try {
        status = lesson_ ? lesson_->step() : session_.step();
    } catch (const DefError& error) {  // an operation of the timeline failed
        return fail({.time = world.time(),
                     .status = "timeline",
                     .element = {},
                     .reason = error.what(),
                     .remedy = "go back to a restore point, or mend the scene's timeline"});
    }
    if (status != Status::ok) return fail(failure_of(world, status));
    ++figures_.steps;
    if (!session_.events().empty()) send_events(world, session_.events(), out_);
    follow_pieces();
    follow_origin();
    if (failure_) {
        failure_.reset();
        send_state();
    }
    if (playing_.count_step()) send_state();
    after_exercise_step();
}

/// Report the progress of the exercise, and pause at its end. Without an exercise, do nothing.
/// Steps after the end have no score.
void Driver::after_exercise_step() {
    if (!lesson_) return;
    lesson_->report_news(session_.world(), out_);
    if (lesson_->ended() && !over_) {
        playing_.pause();
        send_state();
    }
    over_ = lesson_->ended();
    (void)out_.flush();
}

void Driver::advance() {
    perform_commands();
    const int clients = hub_.clients.load(std::memory_order_relaxed);
    if (clients != clients_) {
        clients_ = clients;
        send_state();
    }
    if (playing_.is_running()) {
        step();
        playing_.record_step(session_.world().settings().step);
        publish();
        return;
    }
    if (!reported_) reported_ = out_.flush();
    if (changed_ || playing_.is_frame_due()) publish();
}

void Driver::run(const std::function<bool()>& stop) {
    playing_.begin_clock();
    while (!stop()) {
        advance();
        playing_.wait([this] {
            perform_commands();
            return false;  // the next step shows the changes
        });
    }
}

}  // namespace hawser::live
