// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file connection.h
/// A connection until it is answered with a file or a refusal, or becomes a client.

#include "live/beast/client.h"

#include <list>
#include <map>
#include <optional>
#include <string>

namespace hawser::live::net {

inline constexpr std::size_t kMaxHeader = 8 * 1024;  ///< Largest header of a request [bytes].
inline constexpr int kMaxStrangers = 32;             ///< Largest number of sockets without hello.
inline constexpr int kSendBuffer =
    128 * 1024;  ///< Size of the kernel's send buffer of a client [bytes].

/// A connection until it is answered, or becomes a client.
class Connection : public std::enable_shared_from_this<Connection> {
  public:
    Connection(Floor& floor, Tcp::socket socket) : floor_(floor), stream_(std::move(socket)) {
        Error error;
        const auto end = stream_.socket().remote_endpoint(error);
        if (!error) address_ = end.address().to_string();
        if (!error) from_ = address_ + ":" + std::to_string(end.port());
        at_ = floor_.connections_.insert(floor_.connections_.end(), {address_, [this] { drop(); }});
        (void)stream_.socket().set_option(Tcp::no_delay(true), error);
        (void)stream_.socket().set_option(asio::socket_base::send_buffer_size(kSendBuffer), error);
    }
    ~Connection() { disconnect(); }
    Connection(const Connection&) = delete;
    Connection& operator=(const Connection&) = delete;

    void begin() {
        parser_.header_limit(kMaxHeader);
        parser_.body_limit(0);
        stream_.expires_after(
            std::chrono::milliseconds(static_cast<int>(1e3 * floor_.options_.handshake_seconds)));
        http::async_read(
            stream_, buffer_, parser_,
            [self = shared_from_this()](Error error, std::size_t) { self->on_read(error); });
    }

  private:
    /// Close the connection from outside. Pending operations end with an error.
    void drop() {
        disconnect();
        Error ignored;
        (void)stream_.socket().close(ignored);
    }
    void disconnect() {
        if (!at_) return;
        floor_.connections_.erase(*at_);
        at_.reset();
    }

    void on_read(Error error) {
        if (error == asio::error::operation_aborted) return;
        if (error == beast::error::timeout)
            return floor_.record_rejection(from_ + ": no complete request in time");
        if (error == http::error::end_of_stream || error == asio::error::eof ||
            error == asio::error::connection_reset || error == http::error::partial_message)
            return;
        if (error) {
            floor_.record_rejection(from_ + ": a request that makes no sense (" + error.message() +
                                    ")");
            return answer(http::status::bad_request, "This is no request.\n");
        }
        const auto& request = parser_.get();
        host_ = std::string(view_of(request[http::field::host]));
        if (!host_allowed(floor_.names_, host_)) {
            floor_.record_rejection(from_ + ": foreign Host " + shown(host_));
            host_.clear();
            return answer(http::status::forbidden, "This server is not called so.\n");
        }
        if (websocket::is_upgrade(request)) return upgrade();
        if (request.method() != http::verb::get && request.method() != http::verb::head) {
            floor_.record_rejection(from_ + ": method " + shown(view_of(request.method_string())));
            return answer(http::status::method_not_allowed, "Only GET and HEAD.\n");
        }
        const PageFile* file = file_at(view_of(request.target()));
        if (!file) {
            floor_.record_rejection(from_ + ": no file " + shown(view_of(request.target())));
            return answer(http::status::not_found, "There is no such file.\n");
        }
        send_file(*file, request.method() == http::verb::head);
    }

    void upgrade() {
        const auto& request = parser_.get();
        const std::string_view origin = view_of(request[http::field::origin]);
        if (!origin_allowed(origin, host_)) {
            floor_.record_rejection(from_ + ": foreign Origin " + shown(origin));
            return answer(http::status::forbidden, "This page may not connect.\n");
        }
        if (request.target() != "/live") {
            floor_.record_rejection(from_ + ": no socket " + shown(view_of(request.target())));
            return answer(http::status::not_found, "The socket is /live.\n");
        }
        free_stranger_slot();
        const std::uint32_t number = floor_.next_number();
        auto client = std::make_shared<Client>(floor_, std::move(stream_), number, address_, from_);
        floor_.clients_.emplace(number, client);
        client->begin(request);
    }

    /// Limit the number of sockets that have not sent a hello. They do not count as clients, but
    /// need memory. Close the oldest socket of the address with the most sockets.
    void free_stranger_slot() {
        int strangers = 0, most = 0;
        std::map<std::string, int> by_address;
        for (const auto& [number, client] : floor_.clients_) {
            if (client->has_role()) continue;
            ++strangers;
            most = std::max(most, ++by_address[client->address()]);
        }
        if (strangers < kMaxStrangers) return;
        std::shared_ptr<Client> oldest;  // in the order of rising numbers
        for (const auto& [number, client] : floor_.clients_) {
            if (client->has_role() || by_address[client->address()] < most) continue;
            oldest = client;
            break;
        }
        floor_.record_rejection(from_ + ": too many sockets without a hello; the oldest is closed");
        oldest->drop();
    }

    /// Return text from an unknown client for the log: shortened, without control characters of
    /// terminals.
    static std::string shown(std::string_view text) {
        constexpr std::size_t kMaxShownBytes = 60;
        std::string out = "\"";
        for (const char c : text.substr(0, kMaxShownBytes)) out += c >= ' ' && c <= '~' ? c : '?';
        return out + (text.size() > kMaxShownBytes ? "…\"" : "\"");
    }

    template <class Body>
    void send(const std::shared_ptr<http::response<Body>>& response) {
        for (const auto& [name, value] : safe_headers(host_)) response->set(name, value);
        response->keep_alive(false);
        http::async_write(
            stream_, *response, [self = shared_from_this(), response](Error, std::size_t) {
                Error ignored;
                (void)self->stream_.socket().shutdown(Tcp::socket::shutdown_send, ignored);
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
    beast::flat_static_buffer<kMaxHeader + 1024> buffer_;
    http::request_parser<http::empty_body> parser_;
    std::string address_, from_, host_;
    std::optional<std::list<OpenConnection>::iterator> at_;  ///< Position in Floor::connections_.
};

}  // namespace hawser::live::net
