// SPDX-License-Identifier: Apache-2.0
/// All of the network. Boost.Beast takes ten seconds to compile: nothing else includes it.
#include "live/server.h"

#include "live/web_rules.h"

#include <utility>  // Asio 1.74 uses std::exchange without it

#include <boost/asio.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/http.hpp>
#include <boost/beast/websocket.hpp>

#include <pthread.h>
#include <sched.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cmath>
#include <csignal>
#include <deque>
#include <map>
#include <string_view>
#include <thread>

namespace hawser::live {
namespace {

namespace asio = boost::asio;
namespace beast = boost::beast;
namespace http = beast::http;
namespace websocket = beast::websocket;
using Tcp = asio::ip::tcp;
using Error = beast::error_code;
using Text = std::shared_ptr<const std::string>;
using Frame = std::shared_ptr<const Bytes>;
using WireKindOfClose = websocket::close_code;

constexpr std::size_t kMostHeader = 8 * 1024;       // [bytes] of a request
constexpr int kMostConnections = 96;                // beside those of clients
constexpr std::size_t kMostWaiting = 4096;          // texts for one client …
constexpr std::size_t kMostWaitingBytes = 1 << 20;  // … and their bytes, but for the first scene
constexpr double kMostRate = 200.0;                 // messages a second of a client
constexpr int kMostFaults = 3;                      // of a client
constexpr int kSendBuffer = 128 * 1024;             // [bytes] of the kernel, of a client
constexpr double kGoodbye = 0.5;                    // [s] for the last words

std::string_view view_of(beast::string_view text) { return {text.data(), text.size()}; }

class Client;

/// What connections need of the server.
class Floor {
  public:
    Floor(Hub& hub, ServerOptions options) : hub_(hub), options_(std::move(options)) {}
    virtual ~Floor() = default;

    Hub& hub_;
    const ServerOptions options_;
    HostNames names_;
    std::map<std::uint32_t, std::shared_ptr<Client>> clients_;
    int connections_ = 0;
    Text scene_, state_, timeline_;
    Frame newest_;
    std::atomic<std::int64_t> sent_{0}, left_out_{0}, refused_{0}, dropped_{0};

    /// One line of the log; the rest of a flood is counted.
    void log(const std::string& line) {
        constexpr int kMostLines = 20;
        constexpr double kWhile = 10.0;  // [s]
        const double now = clock_now();
        if (now - log_since_ > kWhile) {
            if (unsaid_ > 0 && options_.log)
                options_.log("and " + std::to_string(unsaid_) + " more refusals");
            log_since_ = now;
            lines_ = unsaid_ = 0;
        }
        if (++lines_ > kMostLines)
            ++unsaid_;
        else if (options_.log)
            options_.log(line);
    }
    void refuse(const std::string& line) {
        refused_.fetch_add(1, std::memory_order_relaxed);
        log("refused: " + line);
    }
    virtual void left(std::uint32_t number) = 0;
    virtual std::uint32_t next_number() = 0;

  private:
    double log_since_ = -1e9;
    int lines_ = 0, unsaid_ = 0;
};

/// A client at the socket /live.
class Client : public std::enable_shared_from_this<Client> {
  public:
    Client(Floor& floor, beast::tcp_stream stream, std::uint32_t number, std::string from)
        : floor_(floor),
          socket_(std::move(stream)),
          number_(number),
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
        socket_.read_message_max(kMostMessage);
        socket_.auto_fragment(false);
        socket_.async_accept(request, [self = shared_from_this()](Error error) {
            if (error) return self->drop();
            self->read();
        });
    }

    [[nodiscard]] bool known() const { return role_ != nullptr; }
    [[nodiscard]] const Role* role() const { return role_; }

    void send(Text text) {
        if (!known() || closing_) return;
        push(std::move(text));
    }
    void send_scene(const std::string& scene) {
        send(std::make_shared<const std::string>("{\"role\":" + role_text(*role_) + "," + scene));
    }
    void show(const Frame& frame) {
        if (!known() || closing_) return;
        if (frame_) floor_.left_out_.fetch_add(1, std::memory_order_relaxed);
        frame_ = frame;
        pump();
    }
    void close(WireKindOfClose code, const std::string& reason) {
        if (closing_) return;
        closing_ = true;
        close_reason_ = {code, reason.substr(0, 120)};
        closing_since_ = clock_now();
        frame_.reset();
        pump();
    }
    /// Once a second.
    void look(double now) {
        const ServerOptions& o = floor_.options_;
        if (!known() && !closing_ && now - born_ > o.handshake_seconds) {
            fault("no hello within " + std::to_string(static_cast<int>(o.handshake_seconds)) + " s",
                  true);
        } else if (writing_ && now - writing_since_ > o.slow_seconds) {
            floor_.log("dropped: " + from_ + " took nothing for " +
                       std::to_string(static_cast<int>(std::round(o.slow_seconds))) + " s");
            floor_.dropped_.fetch_add(1, std::memory_order_relaxed);
            drop();
        } else if (closing_ && now - closing_since_ > o.handshake_seconds) {
            drop();
        }
    }
    void drop() {
        if (gone_) return;
        gone_ = closing_ = true;
        Error ignored;
        beast::get_lowest_layer(socket_).socket().close(ignored);
        floor_.left(number_);
    }

  private:
    void read() {
        socket_.async_read(
            buffer_, [self = shared_from_this()](Error error, std::size_t) { self->got(error); });
    }

    void got(Error error) {
        if (gone_) return;
        if (error) {
            if (error == websocket::error::message_too_big ||
                error == websocket::error::buffer_overflow)
                floor_.refuse(from_ + ": a message of more than 16 kB");
            return drop();
        }
        const auto bytes = buffer_.data();
        if (closing_) {
            // It is on its way out.
        } else if (!within_rate()) {
            fault("more than 200 messages a second");
        } else if (!socket_.got_text()) {
            fault("a message that is no text");
        } else {
            take({static_cast<const char*>(bytes.data()), bytes.size()});
        }
        buffer_.consume(buffer_.size());
        read();
    }

    /// A bucket that holds the messages of a second.
    bool within_rate() {
        const double now = clock_now();
        allowance_ = std::min(kMostRate, allowance_ + kMostRate * (now - allowance_since_));
        allowance_since_ = now;
        if (allowance_ < 1.0) return false;
        allowance_ -= 1.0;
        return true;
    }

    void take(std::string_view text) {
        Request request;
        std::string reason;
        if (!parse(text, request, reason)) return fault(reason, false, request.id, request.kind);
        if (request.hello) return hello(request);
        if (!known()) return fault("the first message is a hello", true);
        for (Command& command : request.commands)
            if (std::string why = forbidden(*role_, command, floor_.options_.recording);
                !why.empty())
                return fault(why, false, request.id, request.kind);
        if (floor_.hub_.commands.room() < request.commands.size())
            return error("too many commands are waiting; try again", request.id, request.kind);
        for (Command& command : request.commands) {
            command.client = number_;
            (void)command.role.assign(role_->name.substr(0, command.role.kMost));
            (void)floor_.hub_.commands.push(std::move(command));
        }
    }

    void hello(const Request& request) {
        if (known()) return fault("hello has been said");
        if (request.version != kVersionOfHello)
            return fault("this server speaks version 1 of the protocol", true);
        const Role* role = role_of(floor_.options_.roles, request.token);
        if (!role) return fault("no role has this token", true);
        role_ = role;
        floor_.hub_.clients.fetch_add(1, std::memory_order_relaxed);
        if (floor_.scene_) send_scene(*floor_.scene_);
        if (floor_.timeline_) send(floor_.timeline_);
        if (floor_.state_) send(floor_.state_);
        if (floor_.newest_) show(floor_.newest_);
    }

    /// A rule was broken. @param last  This closes the connection.
    void fault(const std::string& reason, bool last = false, std::int64_t id = kNoId,
               CommandKind of = CommandKind::none) {
        ++faults_;
        last = last || faults_ >= kMostFaults;
        floor_.refuse(from_ + (role_ ? " (" + role_->name + ")" : std::string()) + ": " + reason +
                      (last ? "; closed" : ""));
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
        return out + ",\"reason\":" + json_text(reason) + "}";
    }

    /// A JSON string of valid UTF-8.
    static std::string json_text(const std::string& text) {
        std::string out = "\"";
        for (const char c : text) {
            if (c == '"' || c == '\\') out += '\\';
            if (static_cast<unsigned char>(c) >= 0x20) out += c;
        }
        return out + "\"";
    }

    void push(Text text) {
        if (gone_) return;
        waiting_bytes_ += text->size();
        texts_.push_back(std::move(text));
        if (texts_.size() > kMostWaiting ||
            (texts_.size() > 4 && waiting_bytes_ > kMostWaitingBytes + texts_.front()->size())) {
            floor_.log("dropped: " + from_ + " takes no messages");
            floor_.dropped_.fetch_add(1, std::memory_order_relaxed);
            return drop();
        }
        pump();
    }

    void pump() {
        if (writing_ || gone_) return;
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
        socket_.async_write(
            asio::buffer(*text),
            [self = shared_from_this(), text](Error error, std::size_t) { self->wrote(error); });
    }

    void write_frame() {
        const Frame frame = std::move(frame_);
        frame_.reset();
        begin_write();
        floor_.sent_.fetch_add(1, std::memory_order_relaxed);
        socket_.binary(true);
        socket_.async_write(
            asio::buffer(*frame),
            [self = shared_from_this(), frame](Error error, std::size_t) { self->wrote(error); });
    }

    void begin_write() {
        writing_ = true;
        writing_since_ = clock_now();
    }
    void wrote(Error error) {
        writing_ = false;
        if (error) return drop();
        pump();
    }

    static constexpr double kVersionOfHello = 1.0;
    Floor& floor_;
    websocket::stream<beast::tcp_stream> socket_;
    beast::flat_static_buffer<kMostMessage + 1024> buffer_;
    std::uint32_t number_;
    std::string from_;
    const Role* role_ = nullptr;
    std::deque<Text> texts_;
    std::size_t waiting_bytes_ = 0;
    Frame frame_;  ///< The one that waits.
    bool writing_ = false, closing_ = false, gone_ = false;
    int faults_ = 0;
    double born_, writing_since_ = 0.0, closing_since_ = 0.0;
    double allowance_ = kMostRate, allowance_since_;
    std::pair<WireKindOfClose, std::string> close_reason_{websocket::close_code::normal, ""};
};

/// A connection until it is answered, or becomes a client.
class Connection : public std::enable_shared_from_this<Connection> {
  public:
    Connection(Floor& floor, Tcp::socket socket) : floor_(floor), stream_(std::move(socket)) {
        ++floor_.connections_;
        Error error;
        const auto end = stream_.socket().remote_endpoint(error);
        if (!error) from_ = end.address().to_string() + ":" + std::to_string(end.port());
        stream_.socket().set_option(Tcp::no_delay(true), error);
        stream_.socket().set_option(asio::socket_base::send_buffer_size(kSendBuffer), error);
    }
    ~Connection() { --floor_.connections_; }

    void begin() {
        parser_.header_limit(kMostHeader);
        parser_.body_limit(0);
        stream_.expires_after(
            std::chrono::milliseconds(static_cast<int>(1e3 * floor_.options_.handshake_seconds)));
        http::async_read(
            stream_, buffer_, parser_,
            [self = shared_from_this()](Error error, std::size_t) { self->got(error); });
    }

  private:
    void got(Error error) {
        if (error == beast::error::timeout)
            return floor_.refuse(from_ + ": no complete request in time");
        if (error == http::error::end_of_stream || error == asio::error::eof ||
            error == asio::error::connection_reset || error == http::error::partial_message)
            return;
        if (error) {
            floor_.refuse(from_ + ": a request that makes no sense (" + error.message() + ")");
            return answer(http::status::bad_request, "This is no request.\n");
        }
        const auto& request = parser_.get();
        host_ = std::string(view_of(request[http::field::host]));
        if (!host_allowed(floor_.names_, host_)) {
            floor_.refuse(from_ + ": foreign Host " + shown(host_));
            host_.clear();
            return answer(http::status::forbidden, "This server is not called so.\n");
        }
        if (websocket::is_upgrade(request)) return upgrade();
        if (request.method() != http::verb::get && request.method() != http::verb::head) {
            floor_.refuse(from_ + ": method " + shown(view_of(request.method_string())));
            return answer(http::status::method_not_allowed, "Only GET and HEAD.\n");
        }
        const PageFile* file = file_at(view_of(request.target()));
        if (!file) {
            floor_.refuse(from_ + ": no file " + shown(view_of(request.target())));
            return answer(http::status::not_found, "There is no such file.\n");
        }
        send_file(*file, request.method() == http::verb::head);
    }

    void upgrade() {
        const auto& request = parser_.get();
        const std::string_view origin = view_of(request[http::field::origin]);
        if (!origin_allowed(origin, host_)) {
            floor_.refuse(from_ + ": foreign Origin " + shown(origin));
            return answer(http::status::forbidden, "This page may not connect.\n");
        }
        if (request.target() != "/live") {
            floor_.refuse(from_ + ": no socket " + shown(view_of(request.target())));
            return answer(http::status::not_found, "The socket is /live.\n");
        }
        if (floor_.clients_.size() >= static_cast<std::size_t>(floor_.options_.clients)) {
            floor_.refuse(from_ + ": all places for clients are taken (--clients " +
                          std::to_string(floor_.options_.clients) + ")");
            return answer(http::status::service_unavailable, "All places are taken.\n");
        }
        const std::uint32_t number = floor_.next_number();
        auto client = std::make_shared<Client>(floor_, std::move(stream_), number, from_);
        floor_.clients_.emplace(number, client);
        client->begin(request);
    }

    /// What a stranger sent, for the log: short, and nothing that a terminal obeys.
    static std::string shown(std::string_view text) {
        constexpr std::size_t kShown = 60;
        std::string out = "\"";
        for (const char c : text.substr(0, kShown)) out += c >= ' ' && c <= '~' ? c : '?';
        return out + (text.size() > kShown ? "…\"" : "\"");
    }

    template <class Body>
    void send(std::shared_ptr<http::response<Body>> response) {
        for (const auto& [name, value] : safe_headers(host_)) response->set(name, value);
        response->keep_alive(false);
        http::async_write(stream_, *response,
                          [self = shared_from_this(), response](Error, std::size_t) {
                              Error ignored;
                              self->stream_.socket().shutdown(Tcp::socket::shutdown_send, ignored);
                          });
    }

    void answer(http::status status, const char* words) {
        auto response = std::make_shared<http::response<http::string_body>>(status, 11);
        response->set(http::field::content_type, "text/plain; charset=utf-8");
        response->body() = words;
        response->prepare_payload();
        send(response);
    }

    void send_file(const PageFile& file, bool head_only) {
        using Span = http::span_body<const unsigned char>;
        auto response = std::make_shared<http::response<Span>>(http::status::ok, 11);
        response->set(http::field::content_type,
                      beast::string_view(file.type.data(), file.type.size()));
        if (is_compressed(file)) response->set(http::field::content_encoding, "gzip");
        response->content_length(file.gzip.size());
        if (!head_only) response->body() = {file.gzip.data(), file.gzip.size()};
        if (!head_only) return send(response);
        auto empty = std::make_shared<http::response<http::empty_body>>(http::status::ok, 11);
        empty->base() = response->base();
        send(empty);
    }

    Floor& floor_;
    beast::tcp_stream stream_;
    beast::flat_static_buffer<kMostHeader + 1024> buffer_;
    http::request_parser<http::empty_body> parser_;
    std::string from_, host_;
};

std::string machine_name() {
    std::array<char, 256> name{};
    return gethostname(name.data(), name.size() - 1) == 0 ? std::string(name.data()) : "";
}

/// Below the thread that steps; not on processors that are kept for it, and deaf to signals.
void lower_this_thread() {
    sigset_t all;
    sigfillset(&all);
    pthread_sigmask(SIG_BLOCK, &all, nullptr);
    const sched_param none{};
    (void)pthread_setschedparam(pthread_self(), SCHED_OTHER, &none);
    cpu_set_t everywhere;
    CPU_ZERO(&everywhere);
    for (int cpu = 0; cpu < CPU_SETSIZE; ++cpu) CPU_SET(cpu, &everywhere);
    (void)sched_setaffinity(0, sizeof everywhere, &everywhere);
    constexpr int kNice = 5;
    const auto self = static_cast<id_t>(syscall(SYS_gettid));
    (void)setpriority(PRIO_PROCESS, self, kNice);
}

}  // namespace

struct Server::Impl final : Floor {
    Impl(Hub& hub, ServerOptions options)
        : Floor(hub, std::move(options)),
          acceptor(context),
          woken(context, dup(hub.descriptor())),
          timer(context) {
        listen();
        names_ = host_names(options_.address, port, machine_name());
        accept();
        await_hub();
        await_second();
        thread = std::thread([this] {
            lower_this_thread();
            context.run();
        });
    }
    ~Impl() override {
        asio::post(context, [this] { goodbye(); });
        thread.join();
    }

    void listen() {
        Error error;
        const auto address = asio::ip::make_address(options_.address, error);
        if (error)
            throw ServerError("--listen " + options_.address +
                              ": no address in numbers, such as 127.0.0.1 or 0.0.0.0");
        const Tcp::endpoint end(address, options_.port);
        acceptor.open(end.protocol(), error);
        if (!error) acceptor.set_option(Tcp::acceptor::reuse_address(true), error);
        if (!error) acceptor.bind(end, error);
        if (!error) acceptor.listen(asio::socket_base::max_listen_connections, error);
        if (error == asio::error::address_in_use)
            throw ServerError("port " + std::to_string(options_.port) + " of " + options_.address +
                              " is taken; free is --port " + std::to_string(free_port(address)));
        if (error)
            throw ServerError("cannot listen at " + options_.address + ", port " +
                              std::to_string(options_.port) + ": " + error.message());
        port = acceptor.local_endpoint().port();
    }

    /// One of the next twenty, else any.
    [[nodiscard]] std::uint16_t free_port(const asio::ip::address& address) {
        for (int next = 1; next <= 21; ++next) {
            Error error;
            const int wanted = next <= 20 ? options_.port + next : 0;
            if (wanted > 65535) continue;
            const Tcp::endpoint end(address, static_cast<std::uint16_t>(wanted));
            Tcp::acceptor probe(context);
            probe.open(end.protocol(), error);
            if (!error) probe.set_option(Tcp::acceptor::reuse_address(true), error);
            if (!error) probe.bind(end, error);
            if (!error) probe.listen(1, error);
            if (!error) return probe.local_endpoint().port();
        }
        return 0;
    }

    void accept() {
        acceptor.async_accept([this](Error error, Tcp::socket socket) {
            if (error == asio::error::operation_aborted) return;
            if (!error) {
                if (connections_ < kMostConnections)
                    std::make_shared<Connection>(*this, std::move(socket))->begin();
                else
                    refuse("a connection: too many are open");
            }
            accept();
        });
    }

    void await_hub() {
        woken.async_wait(asio::posix::stream_descriptor::wait_read, [this](Error error) {
            if (error) return;
            hub_.clear();
            take_messages();
            take_frame();
            await_hub();
        });
    }

    void take_messages() {
        Message message;
        while (hub_.messages.pop(message)) {
            auto text = std::make_shared<const std::string>(std::move(message.text));
            // Clients may leave while they are told.
            const auto all = clients_;
            switch (message.kind) {
                case MessageKind::scene:
                    scene_ = text;
                    for (const auto& [number, client] : all)
                        if (client->known()) client->send_scene(*text);
                    continue;
                case MessageKind::state:
                    state_ = text;
                    break;
                case MessageKind::timeline:
                    timeline_ = text;
                    break;
                case MessageKind::text:
                    break;
            }
            for (const auto& [number, client] : all)
                if (message.to == 0 || message.to == number) client->send(text);
        }
    }

    void take_frame() {
        const Bytes* frame = hub_.frames.take();
        if (!frame) return;
        if (clients_.empty()) {
            newest_.reset();
            return;
        }
        newest_ = std::make_shared<const Bytes>(*frame);
        const auto all = clients_;
        for (const auto& [number, client] : all) client->show(newest_);
    }

    void await_second() {
        timer.expires_after(std::chrono::milliseconds(250));
        timer.async_wait([this](Error error) {
            if (error) return;
            const double now = clock_now();
            const auto all = clients_;
            for (const auto& [number, client] : all) client->look(now);
            await_second();
        });
    }

    void left(std::uint32_t number) override {
        const auto at = clients_.find(number);
        if (at == clients_.end()) return;
        if (at->second->known()) {
            hub_.clients.fetch_sub(1, std::memory_order_relaxed);
            Command gone;
            gone.kind = CommandKind::left;
            gone.client = number;
            (void)hub_.commands.push(std::move(gone));
        }
        clients_.erase(at);
    }
    std::uint32_t next_number() override { return ++last_number; }

    void goodbye() {
        Error ignored;
        acceptor.close(ignored);
        const auto bye =
            std::make_shared<const std::string>(R"({"type":"bye","reason":"the program ends"})");
        const auto all = clients_;
        for (const auto& [number, client] : all) {
            client->send(bye);
            client->close(websocket::close_code::normal, "the program ends");
        }
        timer.expires_after(std::chrono::milliseconds(static_cast<int>(1e3 * kGoodbye)));
        timer.async_wait([this](Error) { context.stop(); });
        if (all.empty()) context.stop();
    }

    asio::io_context context{1};
    Tcp::acceptor acceptor;
    asio::posix::stream_descriptor woken;
    asio::steady_timer timer;
    std::uint16_t port = 0;
    std::uint32_t last_number = 0;
    std::thread thread;
};

Server::Server(Hub& hub, ServerOptions options)
    : impl_(std::make_unique<Impl>(hub, std::move(options))) {}
Server::~Server() = default;

std::uint16_t Server::port() const noexcept { return impl_->port; }

std::string Server::address_of(const Role& role) const {
    std::string host = impl_->options_.address;
    if (host == "0.0.0.0" || host == "::") host = machine_name();
    if (host.find(':') != std::string::npos) host = "[" + host + "]";
    return "http://" + host + ":" + std::to_string(impl_->port) + "/#token=" + role.token;
}

ServerFigures Server::figures() const noexcept {
    return {.frames_sent = impl_->sent_.load(),
            .frames_left_out = impl_->left_out_.load(),
            .refused = impl_->refused_.load(),
            .dropped = impl_->dropped_.load()};
}

}  // namespace hawser::live
