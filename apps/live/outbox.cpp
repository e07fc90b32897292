// SPDX-License-Identifier: Apache-2.0
#include "live/outbox.h"

#include <nlohmann/json.hpp>

#include <utility>

namespace hawser::live {
namespace {

/// Return JSON text without spaces. Names of a scene may contain any bytes; invalid UTF-8 is
/// replaced.
std::string compact(const Json& message) {
    return message.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace

bool Outbox::post(MessageKind kind, std::uint32_t to, std::string text, bool control) {
    Message message{kind, to, control, std::move(text)};
    const bool sent = hub_.messages.push(std::move(message));
    hub_.wake();
    return sent;
}

void Outbox::send(std::uint32_t client, const Json& message) {
    (void)post(MessageKind::text, client, compact(message));
}

void Outbox::event(double time, const std::string& kind, const std::string& name, double value,
                   const std::string& words, bool control) {
    const Json message{{"type", "event"}, {"time", time},   {"kind", kind},
                       {"name", name},    {"value", value}, {"words", words}};
    (void)post(MessageKind::text, 0, compact(message), control);
}

void Outbox::command(double time, const Command& of, const std::string& words, bool control) {
    event(time, "command", to_string(of.kind), of.value, std::string(of.role.view()) + " " + words,
          control);
}

void Outbox::answer(const Command& to) {
    if (to.id == kNoId || !to.answer) return;
    send(to.client, {{"type", "ok"}, {"id", to.id}});
}

void Outbox::reject(const Command& to, const std::string& reason) {
    Json out{{"type", "error"}, {"of", to_string(to.kind)}, {"reason", reason}};
    if (to.id != kNoId) out["id"] = to.id;
    send(to.client, out);
}

void Outbox::report(const Command& to, std::string html) {
    constexpr std::size_t kMaxReportBytes = 900 * 1024;  // of 1 MB that may wait for a client
    if (html.size() > kMaxReportBytes)
        return reject(to, "the report is larger than 900 kB: use `hawser exercise --report`");
    Json out{{"type", "report"}, {"html", std::move(html)}};
    if (to.id != kNoId) out["id"] = to.id;
    send(to.client, out);
}

void Outbox::state(const Json& message) { state_ = compact(message); }
void Outbox::timeline(const Json& message) { timeline_ = compact(message); }
void Outbox::exercise(const Json& message) { exercise_ = compact(message); }
void Outbox::faults(const Json& message) {
    std::string text = compact(message);
    if (text == reported_faults_) return;
    reported_faults_ = text;
    faults_ = std::move(text);
}

bool Outbox::flush() {
    const auto try_one = [this](std::optional<std::string>& waiting, MessageKind kind) {
        if (!waiting) return;
        if (hub_.messages.free_slots() == 0) return;
        (void)post(kind, 0, std::move(*waiting), kind == MessageKind::faults);
        waiting.reset();
    };
    try_one(scene_, MessageKind::scene);
    if (!scene_) try_one(timeline_, MessageKind::timeline);
    if (!scene_) try_one(state_, MessageKind::state);
    if (!scene_) try_one(exercise_, MessageKind::exercise);
    if (!scene_) try_one(faults_, MessageKind::faults);
    return !scene_;
}

}  // namespace hawser::live
