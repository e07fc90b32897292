// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file announced.h
/// A stream that reads the announced lengths of WebSocket frames (RFC 6455, 5.2) before their
/// contents arrive. Beast reports a message only with its bytes.
#include "live/beast/floor.h"

#include <array>
#include <cstdint>
#include <functional>
#include <utility>

namespace hawser::live::net {

/// Parses the headers of frames in the bytes from a client.
class FrameHeaders {
  public:
    /// Parse received bytes for WebSocket frame headers. @return the largest frame length that a
    /// header in these bytes announces [bytes].
    std::uint64_t feed(const unsigned char* from, std::size_t count) {
        std::uint64_t largest = 0;
        while (count > 0) {
            if (payload_ > 0) {
                const auto passed =
                    static_cast<std::size_t>(std::min<std::uint64_t>(payload_, count));
                payload_ -= passed;
                from += passed;
                count -= passed;
                continue;
            }
            header_[have_++] = *from++;
            --count;
            if (have_ < 2 || have_ < size()) continue;
            payload_ = length();
            largest = std::max(largest, payload_);
            have_ = 0;
        }
        return largest;
    }

  private:
    [[nodiscard]] std::size_t extended() const {
        const int short_length = header_[1] & 0x7F;
        return short_length == 126 ? 2 : short_length == 127 ? 8 : 0;
    }
    [[nodiscard]] std::size_t size() const {
        return 2 + extended() + ((header_[1] & 0x80) != 0 ? 4 : 0);
    }
    [[nodiscard]] std::uint64_t length() const {
        if (extended() == 0) return header_[1] & 0x7F;
        std::uint64_t out = 0;
        for (std::size_t k = 0; k < extended(); ++k) out = out << 8U | header_[2 + k];
        return out;
    }
    std::array<unsigned char, 14> header_{};
    std::size_t have_ = 0;
    std::uint64_t payload_ = 0;
};

/// A TCP stream that calls `announced` for each read that begins a frame above `most` bytes.
class AnnouncedStream {
  public:
    using executor_type = beast::tcp_stream::executor_type;
    explicit AnnouncedStream(beast::tcp_stream next) : next_(std::move(next)) {}

    std::uint64_t most = ~std::uint64_t{0};
    std::function<void()> announced{};

    [[nodiscard]] executor_type get_executor() { return next_.get_executor(); }
    [[nodiscard]] beast::tcp_stream& next_layer() { return next_; }
    [[nodiscard]] const beast::tcp_stream& next_layer() const { return next_; }

    template <class Buffers, class Handler>
    void async_read_some(const Buffers& to, Handler&& handler) {
        next_.async_read_some(to, [this, to, call = std::forward<Handler>(handler)](
                                      Error error, std::size_t count) mutable {
            if (!error && inspect(to, count) > most && announced) announced();
            call(error, count);
        });
    }
    template <class Buffers, class Handler>
    void async_write_some(const Buffers& from, Handler&& handler) {
        next_.async_write_some(from, std::forward<Handler>(handler));
    }

  private:
    template <class Buffers>
    std::uint64_t inspect(const Buffers& buffers, std::size_t count) {
        std::uint64_t largest = 0;
        for (auto at = asio::buffer_sequence_begin(buffers);
             at != asio::buffer_sequence_end(buffers) && count > 0; ++at) {
            const asio::mutable_buffer one = *at;
            const std::size_t here = std::min(count, one.size());
            largest = std::max(largest,
                               headers_.feed(static_cast<const unsigned char*>(one.data()), here));
            count -= here;
        }
        return largest;
    }
    beast::tcp_stream next_;
    FrameHeaders headers_;
};

inline void teardown(beast::role_type role, AnnouncedStream& stream, Error& error) {
    beast::websocket::teardown(role, stream.next_layer().socket(), error);
}
template <class Handler>
void async_teardown(beast::role_type role, AnnouncedStream& stream, Handler&& handler) {
    beast::websocket::async_teardown(role, stream.next_layer().socket(),
                                     std::forward<Handler>(handler));
}
inline void beast_close_socket(AnnouncedStream& stream) {
    beast::close_socket(stream.next_layer().socket());
}

}  // namespace hawser::live::net
