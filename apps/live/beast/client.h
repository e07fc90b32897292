// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file client.h
/// A client of the socket /live: its rights, the messages to it, and the checks of its messages.

#include "live/beast/announced.h"
#include "live/message_fields.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <deque>

namespace hawser::live::net {

inline constexpr std::size_t kMaxWaiting =
    4096;  ///< Largest number of waiting texts for a client …
inline constexpr std::size_t kMaxWaitingBytes = 1 << 20;  ///< … and of their bytes, without scenes.
inline constexpr double kMaxRate = 200.0;  ///< Largest number of messages per second from a client.
inline constexpr int kMaxFaults = 3;  ///< Number of faults after which a client is disconnected.
/// Time to wait for the closing handshake of a client without hello, so that our close frame is
/// sent [s].
inline constexpr double kStrangersGoodbye = 0.5;

/// A client at the socket /live.
class Client : public std::enable_shared_from_this<Client> {
  public:
    /// Create a client. @param address  Address of the client, without its port. @param from
    /// Address with the port, for the log.
    Client(Floor& floor, beast::tcp_stream stream, std::uint32_t number, std::string address,
           std::string from)
        : floor_(floor),
          socket_(AnnouncedStream(std::move(stream))),
          number_(number),
          address_(std::move(address)),
          from_(std::move(from)),
          born_(clock_now()),
          allowance_since_(born_) {}

    void begin(const http::request<http::empty_body>& request) {
        beast::get_lowest_layer(socket_).expires_never();
        websocket::stream_base::timeout limits{};
        limits.handshake_timeout =
            std::chrono::milliseconds(static_cast<int>(1e3 * floor_.options_.handshake_seconds));
        limits.idle_timeout = websocket::stream_base::none();
        limits.keep_alive_pings = false;
        socket_.set_option(limits);
        // Beast's own limit is reported only after the other side has disconnected.
        socket_.read_message_max(0);
        socket_.next_layer().most = kMaxMessage;
        socket_.next_layer().announced = [this] {
            // Do not call too_big() within a read of Beast.
            asio::post(socket_.get_executor(), [self = shared_from_this()] { self->too_big(); });
        };
        socket_.auto_fragment(false);
        // Beast answers a close frame and waits until the other side disconnects.
        // check_time_limits() limits that time.
        socket_.control_callback([this](websocket::frame_type kind, beast::string_view) {
            if (kind != websocket::frame_type::close || closing_) return;
            closing_ = true;
            closing_since_ = clock_now();
        });
        socket_.async_accept(request, [self = shared_from_this()](Error error) {
            if (error) return self->drop();
            self->read();
        });
    }

    [[nodiscard]] bool has_role() const { return role_ != nullptr; }
    [[nodiscard]] const Role* role() const { return role_; }
    [[nodiscard]] const std::string& address() const { return address_; }

    void send(Text text) {
        if (!has_role() || closing_) return;
        push(std::move(text));
    }
    void send_scene(const std::string& scene) {
        send(std::make_shared<const std::string>("{\"role\":" + role_text(*role_) + "," + scene));
    }
    void send_newest_frame(const Frame& frame) {
        if (!has_role() || closing_) return;
        if (frame_) floor_.frames_skipped_.fetch_add(1, std::memory_order_relaxed);
        frame_ = frame;
        send_queued();
    }
    void close(websocket::close_code code, const std::string& reason) {
        if (closing_) return;
        closing_ = true;
        close_reason_ = {code, std::string(shortened(reason, 120))};
        closing_since_ = clock_now();
        frame_.reset();
        send_queued();
    }
    /// Disconnect a client that sends no hello or reads no frames in time. Called once a second.
    void check_time_limits(double now) {
        const ServerOptions& o = floor_.options_;
        if (!has_role() && !closing_ && now - born_ > o.handshake_seconds) {
            fault("no hello within " + std::to_string(static_cast<int>(o.handshake_seconds)) + " s",
                  true);
        } else if (writing_ && now - writing_since_ > o.slow_seconds) {
            floor_.log("dropped: " + from_ + " received nothing for " +
                       std::to_string(static_cast<int>(std::round(o.slow_seconds))) + " s");
            floor_.dropped_.fetch_add(1, std::memory_order_relaxed);
            drop();
        } else if (closing_ &&
                   now - closing_since_ > (has_role() ? o.handshake_seconds : kStrangersGoodbye)) {
            drop();
        }
    }
    void drop() {
        if (disconnected_) return;
        disconnected_ = closing_ = true;
        Error ignored;
        (void)beast::get_lowest_layer(socket_).socket().close(ignored);
        floor_.client_left(number_);
    }

  private:
    void read() {
        socket_.async_read_some(
            buffer_, kMaxMessage + 1 - buffer_.size(),
            [self = shared_from_this()](Error error, std::size_t) { self->on_read(error); });
    }

    void on_read(Error error) {
        if (disconnected_) return;
        if (error) return drop();
        if (buffer_.size() > kMaxMessage) too_big();  // of several frames
        if (closing_) {                               // data after the close frame is discarded
            buffer_.consume(buffer_.size());
            return read();
        }
        if (!socket_.is_message_done()) return read();
        const auto bytes = buffer_.data();
        if (!within_rate()) {
            fault("more than 200 messages a second");
        } else if (!socket_.got_text()) {
            fault("a message that is no text");
        } else {
            handle_message({static_cast<const char*>(bytes.data()), bytes.size()});
        }
        buffer_.consume(buffer_.size());
        read();
    }

    void too_big() {
        if (disconnected_ || closing_) return;
        floor_.record_rejection(from_ + ": a message of more than 16 kB; closed");
        close(websocket::close_code::too_big, "a message has at most 16 kB");
    }

    /// Return true if another message is within the rate limit. The token bucket has the capacity
    /// of one second.
    bool within_rate() {
        const double now = clock_now();
        allowance_ = std::min(kMaxRate, allowance_ + kMaxRate * (now - allowance_since_));
        allowance_since_ = now;
        if (allowance_ < 1.0) return false;
        allowance_ -= 1.0;
        return true;
    }

    void handle_message(std::string_view text) {
        Request request;
        std::string reason;
        if (!parse(text, request, reason)) return fault(reason, false, request.id, request.kind);
        if (request.hello) return handle_hello(request);
        if (!has_role()) return fault("the first message is a hello", true);
        for (Command& command : request.commands)
            if (std::string why = rejection_reason(*role_, command, floor_.options_.recording);
                !why.empty())
                return fault(why, false, request.id, request.kind);
        if (floor_.hub_.commands.free_slots() < request.commands.size())
            return error("too many commands are waiting; try again", request.id, request.kind);
        for (Command& command : request.commands) {
            command.client = number_;
            (void)command.role.assign(shortened(role_->name, command.role.kMaximum));
            // NOLINTNEXTLINE(performance-move-const-arg): the ring takes rvalues.
            (void)floor_.hub_.commands.push(std::move(command));
        }
    }

    void handle_hello(const Request& request) {
        if (has_role()) return fault("hello has been said");
        if (request.version != kVersionOfHello)
            return fault("this server speaks version 1 of the protocol", true);
        const Role* role = role_of(floor_.options_.roles, request.token);
        if (!role) return fault("no role has this token", true);
        if (!floor_.has_free_slot(*role)) return reject_full();
        role_ = role;
        floor_.hub_.clients.fetch_add(1, std::memory_order_relaxed);
        if (floor_.scene_) send_scene(*floor_.scene_);
        if (floor_.timeline_) send(floor_.timeline_);
        if (floor_.state_) send(floor_.state_);
        if (floor_.exercise_) send(floor_.exercise_);
        if (floor_.faults_ && role->control) send(floor_.faults_);
        if (floor_.newest_) send_newest_frame(floor_.newest_);
    }

    /// Disconnect the client because the server is full. This is no fault, and the client may try
    /// again later.
    void reject_full() {
        const std::string reason = "all places for clients are taken (--clients " +
                                   std::to_string(floor_.options_.clients) + ")";
        floor_.record_rejection(from_ + ": " + reason);
        error(reason, kNoId, CommandKind::none);
        close(websocket::close_code::try_again_later, reason);
    }

    /// Report to the client that it broke a rule of the protocol. @param last  True: close the
    /// connection.
    void fault(const std::string& reason, bool last = false, std::int64_t id = kNoId,
               CommandKind of = CommandKind::none) {
        ++faults_;
        last = last || faults_ >= kMaxFaults;
        floor_.record_rejection(from_ + (role_ ? " (" + role_->name + ")" : std::string()) + ": " +
                                reason + (last ? "; closed" : ""));
        error(reason, id, of);
        if (last) close(websocket::close_code::policy_error, reason);
    }

    void error(const std::string& reason, std::int64_t id, CommandKind of) {
        push(std::make_shared<const std::string>(error_text(reason, id, of)));
    }

    static std::string error_text(const std::string& reason, std::int64_t id, CommandKind of) {
        std::string out = "{\"type\":\"error\"";
        if (id != kNoId) out += ",\"id\":" + std::to_string(id);
        if (of != CommandKind::none) out += std::string(",\"of\":\"") + to_string(of) + "\"";
        return out + ",\"reason\":" + json_string(reason) + "}";
    }

    void push(Text text) {
        if (disconnected_) return;
        waiting_bytes_ += text->size();
        texts_.push_back(std::move(text));
        if (texts_.size() > kMaxWaiting ||
            (texts_.size() > 4 && waiting_bytes_ > kMaxWaitingBytes + texts_.front()->size())) {
            floor_.log("dropped: " + from_ + " takes no messages");
            floor_.dropped_.fetch_add(1, std::memory_order_relaxed);
            return drop();
        }
        send_queued();
    }

    void send_queued() {
        if (writing_ || disconnected_) return;
        if (!texts_.empty()) {
            write_text();
        } else if (closing_) {
            writing_ = true;
            writing_since_ = clock_now();
            socket_.async_close({close_reason_.first, close_reason_.second},
                                [self = shared_from_this()](Error) { self->drop(); });
        } else if (frame_) {
            write_frame();
        }
    }

    void write_text() {
        const Text text = std::move(texts_.front());
        texts_.pop_front();
        waiting_bytes_ -= text->size();
        begin_write();
        socket_.text(true);
        socket_.async_write(asio::buffer(*text),
                            [self = shared_from_this(), text](Error error, std::size_t) {
                                self->on_written(error);
                            });
    }

    void write_frame() {
        const Frame frame = std::move(frame_);
        frame_.reset();
        begin_write();
        floor_.sent_.fetch_add(1, std::memory_order_relaxed);
        socket_.binary(true);
        socket_.async_write(asio::buffer(*frame),
                            [self = shared_from_this(), frame](Error error, std::size_t) {
                                self->on_written(error);
                            });
    }

    void begin_write() {
        writing_ = true;
        writing_since_ = clock_now();
    }
    void on_written(Error error) {
        writing_ = false;
        if (error) return drop();
        send_queued();
    }

    static constexpr double kVersionOfHello = 1.0;
    Floor& floor_;
    websocket::stream<AnnouncedStream> socket_;
    beast::flat_static_buffer<kMaxMessage + 1024> buffer_;
    std::uint32_t number_;
    std::string address_, from_;
    const Role* role_ = nullptr;
    std::deque<Text> texts_;
    std::size_t waiting_bytes_ = 0;
    Frame frame_;  ///< Frame that waits to be sent.
    bool writing_ = false, closing_ = false, disconnected_ = false;
    int faults_ = 0;
    double born_, writing_since_ = 0.0, closing_since_ = 0.0;
    double allowance_ = kMaxRate, allowance_since_;
    std::pair<websocket::close_code, std::string> close_reason_{websocket::close_code::normal, ""};
};

}  // namespace hawser::live::net
