// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file client.h
/// A client of `hawser view` on plain sockets, written from docs/live.md: none of the server's
/// code.

#include <nlohmann/json.hpp>

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace hawser::test {

/// Data received through a WebSocket.
struct Got {
    enum Kind { nothing, text, frame, closed } kind = nothing;
    nlohmann::json json;      ///< For text.
    std::vector<char> bytes;  ///< For a frame.
    int code = 0;             ///< For closed; 0: the connection ended without a message.
};

/// A connection to a port of this machine; every wait has an end.
class Line {
  public:
    explicit Line(std::uint16_t port);
    ~Line();
    Line(const Line&) = delete;
    Line& operator=(const Line&) = delete;

    /// @return false if the other side has closed.
    bool send(std::string_view bytes);
    /// Return the data received within a time [s], at most until the other side closes.
    std::string read_all(double seconds);
    /// Return the data up to and including an end mark.
    std::string read_until(std::string_view end, double seconds);
    /// Return a number of bytes; none if they do not arrive in time.
    std::optional<std::string> read(std::size_t count, double seconds);
    /// @return true if the other side closes within a time [s].
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

/// The first line of an answer to a request.
[[nodiscard]] std::string request(std::uint16_t port, const std::string& target,
                                  const std::string& host, const std::string& more = {},
                                  const std::string& method = "GET");

/// At the socket /live.
class LiveClient {
  public:
    /// @param token  Token of the hello; "": none is sent. @param more  Headers, each with its line
    ///        end.
    LiveClient(std::uint16_t port, const std::string& token, const std::string& more = {},
               const std::string& host = {});
    [[nodiscard]] const std::string& answer() const { return answer_; }  ///< Its first line.

    bool say(const nlohmann::json& message) { return say(message.dump()); }
    bool say(const std::string& text, int opcode = 1);
    /// Return the next message; none within the time [s].
    Got next(double seconds = 5.0);
    /// Return the next text of a type; frames and others are skipped. @throws std::runtime_error
    nlohmann::json wait_for(const std::string& type, double seconds = 5.0);
    /// The answer to the message with this id, `ok`, `error` or `picked`.
    nlohmann::json answer_to(int id, double seconds = 5.0);
    /// The next frame of the present scene.
    std::vector<char> frame(double seconds = 5.0);
    /// Code of the close; 0 without one; −1: it stays open.
    int closes(double seconds);
    [[nodiscard]] const nlohmann::json& scene() const { return scene_; }
    [[nodiscard]] const nlohmann::json& state() const { return state_; }
    [[nodiscard]] Line& line() { return line_; }

  private:
    Line line_;
    std::string answer_;
    nlohmann::json scene_, state_;
};

/// A frame, decoded as in docs/live.md.
struct ReadFrame {
    std::uint16_t version = 0, flags = 0;
    std::uint32_t length = 0, epoch = 0, number = 0, bits = 0;
    std::int64_t step = 0;
    double time = 0.0, clock = 0.0;
    std::vector<float> rigid, lumps, scalars, points, tensions, contacts, joints, outputs, inputs,
        stats;
    std::vector<std::uint32_t> counts;
};
/// @throws std::runtime_error if it is not a frame.
[[nodiscard]] ReadFrame read_frame(const std::vector<char>& bytes);

}  // namespace hawser::test
