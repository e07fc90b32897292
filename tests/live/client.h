// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file client.h
/// A client of `hawser view` on plain sockets, written from docs/live.md without code of the
/// server.

#include <nlohmann/json.hpp>

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace hawser::test {

/// Message received through a WebSocket.
struct Got {
    enum Kind { nothing, text, frame, closed } kind = nothing;
    nlohmann::json json;      ///< Content of a text message.
    std::vector<char> bytes;  ///< Content of a frame.
    int code = 0;             ///< Code of a close; 0: the connection ended without one.
};

/// A connection to a port of this machine; every wait has a time limit.
class Line {
  public:
    explicit Line(std::uint16_t port);
    ~Line();
    Line(const Line&) = delete;
    Line& operator=(const Line&) = delete;

    /// Send bytes. @return false if the other side accepts no more.
    bool send(std::string_view bytes);
    /// Read the bytes that arrive within a time [s], at most until the other side closes.
    std::string read_all(double seconds);
    /// Read up to and including a terminator.
    std::string read_until(std::string_view end, double seconds);
    /// Read a number of bytes; nullopt if they do not arrive in time.
    std::optional<std::string> read(std::size_t count, double seconds);
    /// True if the other side closes within a time [s].
    bool ends(double seconds);
    [[nodiscard]] std::uint16_t port() const { return port_; }
    [[nodiscard]] int descriptor() const { return socket_; }

  private:
    bool more(double until);

    std::uint16_t port_;
    int socket_;
    bool ended_ = false;
    std::string have_;
};

/// Return the first line of the response to a request.
[[nodiscard]] std::string request(std::uint16_t port, const std::string& target,
                                  const std::string& host, const std::string& more = {},
                                  const std::string& method = "GET");

/// A client of the socket /live.
class LiveClient {
  public:
    /// Connect. @param token  Token of hello; "": send no hello. @param more  Further headers, each
    /// with its line end.
    LiveClient(std::uint16_t port, const std::string& token, const std::string& more = {},
               const std::string& host = {});
    [[nodiscard]] const std::string& answer() const {
        return answer_;
    }  ///< First line of the response.

    bool say(const nlohmann::json& message) { return say(message.dump()); }
    bool say(const std::string& text, int opcode = 1);
    /// Return the next message; an empty one after the time [s].
    Got next(double seconds = 5.0);
    /// Return the next text of a type; frames and other texts are skipped. @throws
    /// std::runtime_error
    nlohmann::json wait_for(const std::string& type, double seconds = 5.0);
    /// Return the response to the message with this id: `ok`, `error` or `picked`.
    nlohmann::json answer_to(int id, double seconds = 5.0);
    /// Return the next frame of the present scene.
    std::vector<char> frame(double seconds = 5.0);
    /// Return the code of the close; 0: closed without one; −1: still open.
    int closes(double seconds);
    [[nodiscard]] const nlohmann::json& scene() const { return scene_; }
    [[nodiscard]] const nlohmann::json& state() const { return state_; }
    [[nodiscard]] Line& line() { return line_; }

  private:
    Line line_;
    std::string answer_;
    nlohmann::json scene_, state_;
};

/// Contents of a frame by docs/live.md.
struct ReadFrame {
    std::uint16_t version = 0, flags = 0;
    std::uint32_t length = 0, epoch = 0, number = 0, bits = 0;
    std::int64_t step = 0;
    double time = 0.0, clock = 0.0;
    std::vector<float> rigid, lumps, scalars, points, tensions, contacts, joints, outputs, inputs,
        stats;
    std::vector<std::uint32_t> counts;
};
/// Decode a frame. @throws std::runtime_error if the bytes are not a frame.
[[nodiscard]] ReadFrame read_frame(const std::vector<char>& bytes);

}  // namespace hawser::test
