// SPDX-License-Identifier: Apache-2.0
/// All network code is compiled here, because Boost.Beast takes long to compile.
#include "live/server.h"

#include "live/beast/connection.h"

#include <pthread.h>
#include <sched.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <thread>

namespace hawser::live {
namespace {

using namespace net;

constexpr std::size_t kMaxConnections = 96;  // in addition to the slots of clients
constexpr double kGoodbyeSeconds = 0.5;      // [s] time for the last messages

std::string machine_name() {
    std::array<char, 256> name{};
    return gethostname(name.data(), name.size() - 1) == 0 ? std::string(name.data()) : "";
}

/// Lower the priority of this thread below that of the stepping thread. Exclude the processors
/// reserved for stepping, and block signals.
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
    constexpr int kNiceIncrement = 5;
    const auto self = static_cast<id_t>(syscall(SYS_gettid));
    (void)setpriority(PRIO_PROCESS, self, kNiceIncrement);
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
        asio::post(context, [this] { send_goodbye(); });
        thread.join();
        // Clients that are still connected use timers of the context, which is destroyed before the
        // base class.
        clients_.clear();
    }

    void listen() {
        Error error;
        const auto address = asio::ip::make_address(options_.address, error);
        if (error)
            throw ServerError("--listen " + options_.address +
                              ": no address in numbers, such as 127.0.0.1 or 0.0.0.0");
        const Tcp::endpoint end(address, options_.port);
        (void)acceptor.open(end.protocol(), error);
        if (!error) (void)acceptor.set_option(Tcp::acceptor::reuse_address(true), error);
        if (!error) (void)acceptor.bind(end, error);
        if (!error) (void)acceptor.listen(asio::socket_base::max_listen_connections, error);
        if (error == asio::error::address_in_use)
            throw ServerError("port " + std::to_string(options_.port) + " of " + options_.address +
                              " is taken; free is --port " + std::to_string(free_port(address)));
        if (error)
            throw ServerError("cannot listen at " + options_.address + ", port " +
                              std::to_string(options_.port) + ": " + error.message());
        port = acceptor.local_endpoint().port();
    }

    /// Return one of the next twenty ports if one is free, else any free port.
    [[nodiscard]] std::uint16_t free_port(const asio::ip::address& address) {
        for (int next = 1; next <= 21; ++next) {
            Error error;
            const int wanted = next <= 20 ? options_.port + next : 0;
            if (wanted > 65535) continue;
            const Tcp::endpoint end(address, static_cast<std::uint16_t>(wanted));
            Tcp::acceptor probe(context);
            (void)probe.open(end.protocol(), error);
            if (!error) (void)probe.set_option(Tcp::acceptor::reuse_address(true), error);
            if (!error) (void)probe.bind(end, error);
            if (!error) (void)probe.listen(1, error);
            if (!error) return probe.local_endpoint().port();
        }
        return 0;
    }

    void accept() {
        acceptor.async_accept([this](Error error, Tcp::socket socket) {
            if (error == asio::error::operation_aborted) return;
            if (!error) {
                if (connections_.size() >= kMaxConnections) free_connection_slot();
                std::make_shared<Connection>(*this, std::move(socket))->begin();
            }
            accept();
        });
    }

    void await_hub() {
        woken.async_wait(asio::posix::stream_descriptor::wait_read, [this](Error error) {
            if (error) return;
            hub_.clear();
            receive_messages();
            receive_frame();
            await_hub();
        });
    }

    void receive_messages() {
        Message message;
        while (hub_.messages.pop(message)) {
            auto text = std::make_shared<const std::string>(std::move(message.text));
            // Clients may leave during the loop.
            const auto all = clients_;
            switch (message.kind) {
                case MessageKind::scene:
                    scene_ = text;
                    for (const auto& [number, client] : all)
                        if (client->has_role()) client->send_scene(*text);
                    continue;
                case MessageKind::state:
                    state_ = text;
                    break;
                case MessageKind::timeline:
                    timeline_ = text;
                    break;
                case MessageKind::exercise:
                    exercise_ = text;
                    break;
                case MessageKind::faults:
                    faults_ = text;
                    break;
                case MessageKind::text:
                    break;
            }
            for (const auto& [number, client] : all)
                if ((message.to == 0 || message.to == number) &&
                    (!message.control || (client->has_role() && client->role()->control)))
                    client->send(text);
        }
    }

    void receive_frame() {
        const Bytes* frame = hub_.frames.newest_frame();
        if (!frame) return;
        if (clients_.empty()) {
            newest_.reset();
            return;
        }
        newest_ = std::make_shared<const Bytes>(*frame);
        const auto all = clients_;
        for (const auto& [number, client] : all) client->send_newest_frame(newest_);
    }

    void await_second() {
        timer.expires_after(std::chrono::milliseconds(250));
        timer.async_wait([this](Error error) {
            if (error) return;
            const double now = clock_now();
            const auto all = clients_;
            for (const auto& [number, client] : all) client->check_time_limits(now);
            await_second();
        });
    }

    void client_left(std::uint32_t number) override {
        const auto at = clients_.find(number);
        if (at == clients_.end()) return;
        if (at->second->has_role()) {
            hub_.clients.fetch_sub(1, std::memory_order_relaxed);
            Command gone;
            gone.kind = CommandKind::left;
            gone.client = number;
            // NOLINTNEXTLINE(performance-move-const-arg): the ring takes rvalues.
            (void)hub_.commands.push(std::move(gone));
        }
        clients_.erase(at);
    }
    std::uint32_t next_number() override { return ++last_number; }

    void send_goodbye() {
        Error ignored;
        (void)acceptor.close(ignored);
        const auto bye =
            std::make_shared<const std::string>(R"({"type":"bye","reason":"the program ends"})");
        const auto all = clients_;
        for (const auto& [number, client] : all) {
            client->send(bye);
            client->close(websocket::close_code::normal, "the program ends");
        }
        timer.expires_after(std::chrono::milliseconds(static_cast<int>(1e3 * kGoodbyeSeconds)));
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
            .frames_left_out = impl_->frames_skipped_.load(),
            .refused = impl_->rejected_.load(),
            .dropped = impl_->dropped_.load()};
}

}  // namespace hawser::live
