// SPDX-License-Identifier: Apache-2.0
#include "live/client.h"

#include <arpa/inet.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstring>
#include <stdexcept>

namespace hawser::test {
namespace {

double seconds_now() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch())
        .count();
}

template <class T>
T take(const std::vector<char>& bytes, std::size_t at) {
    T value{};
    if (at + sizeof value > bytes.size()) throw std::runtime_error("the frame is too short");
    std::memcpy(&value, bytes.data() + at, sizeof value);
    return value;
}

}  // namespace

Line::Line(std::uint16_t port) : port_(port), socket_(socket(AF_INET, SOCK_STREAM, 0)) {
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_port = htons(port);
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    const timeval most{2, 0};
    setsockopt(socket_, SOL_SOCKET, SO_SNDTIMEO, &most, sizeof most);
    if (connect(socket_, reinterpret_cast<sockaddr*>(&address), sizeof address) != 0)
        throw std::runtime_error("cannot connect");
}

Line::~Line() { close(socket_); }

bool Line::send(std::string_view bytes) {
    while (!bytes.empty()) {
        const auto sent = ::send(socket_, bytes.data(), bytes.size(), MSG_NOSIGNAL);
        if (sent <= 0) return false;
        bytes.remove_prefix(static_cast<std::size_t>(sent));
    }
    return true;
}

bool Line::more(double until) {
    const double left = until - seconds_now();
    if (ended_ || left <= 0.0) return false;
    pollfd wanted{socket_, POLLIN, 0};
    if (poll(&wanted, 1, static_cast<int>(1e3 * left) + 1) <= 0) return false;
    char buffer[65536];
    const auto got = recv(socket_, buffer, sizeof buffer, 0);
    if (got <= 0) {
        ended_ = true;
        return false;
    }
    have_.append(buffer, static_cast<std::size_t>(got));
    return true;
}

std::string Line::read_all(double seconds) {
    const double until = seconds_now() + seconds;
    while (more(until)) {
    }
    return std::exchange(have_, {});
}

std::string Line::read_until(std::string_view end, double seconds) {
    const double until = seconds_now() + seconds;
    while (have_.find(end) == std::string::npos && more(until)) {
    }
    const std::size_t at = have_.find(end);
    if (at == std::string::npos) return std::exchange(have_, {});
    std::string out = have_.substr(0, at + end.size());
    have_.erase(0, at + end.size());
    return out;
}

std::optional<std::string> Line::read(std::size_t count, double seconds) {
    const double until = seconds_now() + seconds;
    while (have_.size() < count && more(until)) {
    }
    if (have_.size() < count) return std::nullopt;
    std::string out = have_.substr(0, count);
    have_.erase(0, count);
    return out;
}

bool Line::ends(double seconds) {
    const double until = seconds_now() + seconds;
    while (more(until)) have_.clear();
    return ended_;
}

std::string request(std::uint16_t port, const std::string& target, const std::string& host,
                    const std::string& more, const std::string& method) {
    Line line(port);
    line.send(method + " " + target + " HTTP/1.1\r\nHost: " + host + "\r\n" + more + "\r\n");
    const std::string answer = line.read_all(3.0);
    return answer.substr(0, answer.find("\r\n"));
}

LiveClient::LiveClient(std::uint16_t port, const std::string& token, const std::string& more,
                       const std::string& host)
    : line_(port) {
    line_.send("GET /live HTTP/1.1\r\nHost: " +
               (host.empty() ? "127.0.0.1:" + std::to_string(port) : host) +
               "\r\nUpgrade: websocket\r\nConnection: Upgrade\r\nSec-WebSocket-Version: "
               "13\r\nSec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\n" +
               more + "\r\n");
    answer_ = line_.read_until("\r\n\r\n", 5.0);
    answer_ = answer_.substr(0, answer_.find("\r\n"));
    if (!token.empty()) say({{"type", "hello"}, {"version", 1}, {"token", token}});
}

bool LiveClient::say(const std::string& text, int opcode) {
    std::string head(1, static_cast<char>(0x80 | opcode));
    const std::size_t n = text.size();
    const auto put = [&](int bytes) {
        for (int k = bytes; k-- > 0;) head += static_cast<char>((n >> (8 * k)) & 0xFF);
    };
    if (n < 126) {
        head += static_cast<char>(0x80 | n);
    } else if (n < 65536) {
        head += static_cast<char>(0x80 | 126);
        put(2);
    } else {
        head += static_cast<char>(0x80 | 127);
        put(8);
    }
    const char mask[4] = {0x12, 0x34, 0x56, 0x78};
    head.append(mask, 4);
    std::string body = text;
    for (std::size_t k = 0; k < n; ++k) body[k] = static_cast<char>(body[k] ^ mask[k % 4]);
    return line_.send(head + body);
}

Got LiveClient::next(double seconds) {
    Got out;
    const auto head = line_.read(2, seconds);
    if (!head) {
        out.kind = line_.ends(0.0) ? Got::closed : Got::nothing;
        return out;
    }
    const int opcode = (*head)[0] & 0x0F;
    std::size_t size = static_cast<unsigned char>((*head)[1]);
    if (size > 125) {
        const auto wide = line_.read(size == 126 ? 2 : 8, seconds);
        size = 0;
        for (const char c : wide.value_or("")) size = (size << 8U) | static_cast<unsigned char>(c);
    }
    const auto body = line_.read(size, seconds);
    if (!body) {
        out.kind = Got::closed;
    } else if (opcode == 1) {
        out.kind = Got::text;
        out.json = nlohmann::json::parse(*body);
        if (out.json["type"] == "scene") scene_ = out.json;
        if (out.json["type"] == "state") state_ = out.json;
    } else if (opcode == 2) {
        out.kind = Got::frame;
        out.bytes.assign(body->begin(), body->end());
    } else if (opcode == 8) {
        out.kind = Got::closed;
        if (body->size() >= 2)
            out.code = static_cast<unsigned char>((*body)[0]) * 256 +
                       static_cast<unsigned char>((*body)[1]);
    }
    return out;
}

nlohmann::json LiveClient::wait_for(const std::string& type, double seconds) {
    const double until = seconds_now() + seconds;
    while (seconds_now() < until) {
        Got got = next(until - seconds_now());
        if (got.kind == Got::text && got.json["type"] == type) return got.json;
        if (got.kind == Got::closed) break;
    }
    throw std::runtime_error("no message of the type " + type);
}

nlohmann::json LiveClient::answer_to(int id, double seconds) {
    const double until = seconds_now() + seconds;
    while (seconds_now() < until) {
        Got got = next(until - seconds_now());
        if (got.kind == Got::text && got.json.value("id", -1) == id) return got.json;
        if (got.kind == Got::closed) break;
    }
    throw std::runtime_error("no answer to message " + std::to_string(id));
}

std::vector<char> LiveClient::frame(double seconds) {
    const double until = seconds_now() + seconds;
    while (seconds_now() < until) {
        Got got = next(until - seconds_now());
        if (got.kind == Got::frame && take<std::uint32_t>(got.bytes, 12) == scene_["epoch"])
            return got.bytes;
        if (got.kind == Got::closed) break;
    }
    throw std::runtime_error("no frame");
}

int LiveClient::closes(double seconds) {
    const double until = seconds_now() + seconds;
    while (seconds_now() < until) {
        const Got got = next(until - seconds_now());
        if (got.kind == Got::closed) return got.code;
    }
    return -1;
}

ReadFrame read_frame(const std::vector<char>& bytes) {
    ReadFrame out;
    if (bytes.size() < 128 || std::string(bytes.data(), 4) != "HWLV")
        throw std::runtime_error("this is no frame");
    out.version = take<std::uint16_t>(bytes, 4);
    out.flags = take<std::uint16_t>(bytes, 6);
    out.length = take<std::uint32_t>(bytes, 8);
    out.epoch = take<std::uint32_t>(bytes, 12);
    out.number = take<std::uint32_t>(bytes, 16);
    out.step = take<std::int64_t>(bytes, 24);
    out.time = take<double>(bytes, 32);
    out.clock = take<double>(bytes, 40);
    out.bits = take<std::uint32_t>(bytes, 96);
    const auto count = [&](std::size_t k) {
        return static_cast<std::size_t>(take<std::uint32_t>(bytes, 48 + 4 * k));
    };
    std::size_t at = 128;
    const auto section = [&](std::vector<float>& to, std::size_t n) {
        for (std::size_t k = 0; k < n; ++k, at += 4) to.push_back(take<float>(bytes, at));
    };
    section(out.rigid, 7 * count(0));
    section(out.lumps, 3 * count(1));
    section(out.scalars, count(2));
    for (std::size_t k = 0; k < count(3); ++k, at += 4)
        out.counts.push_back(take<std::uint32_t>(bytes, at));
    section(out.points, 3 * count(4));
    section(out.tensions, count(5));
    section(out.contacts, 6 * count(6));
    section(out.joints, 3 * count(7));
    section(out.outputs, count(8));
    section(out.inputs, count(9));
    section(out.stats, count(10));
    if (at != bytes.size() || out.length != bytes.size())
        throw std::runtime_error("a frame has another length than it says");
    return out;
}

}  // namespace hawser::test
