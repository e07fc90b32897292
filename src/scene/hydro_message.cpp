// SPDX-License-Identifier: Apache-2.0
#include "scene/hydro_message.h"

#include <array>
#include <cstdint>
#include <cstring>

namespace hawser::scene {
namespace {

constexpr std::uint64_t kHydroMagic = 0x3130524457414800u;  // changes with the layout
constexpr std::size_t kMaxErrorText = 4000;

constexpr std::uint64_t kHasInfinite = 1, kHasZero = 2, kHasStiffness = 4;  // bits of flags

void put_bytes(std::vector<char>& to, const void* from, std::size_t size) {
    const char* const begin = static_cast<const char*>(from);
    to.insert(to.end(), begin, begin + size);
}
void append_word(std::vector<char>& to, std::uint64_t word) { put_bytes(to, &word, sizeof word); }

class MessageBytes {
  public:
    explicit MessageBytes(std::span<const char> bytes) : bytes_left_(bytes) {}
    [[nodiscard]] std::size_t bytes_left() const { return bytes_left_.size(); }
    void read_bytes(void* to, std::size_t size) {
        if (size == 0) return;
        std::memcpy(to, bytes_left_.data(), size);
        bytes_left_ = bytes_left_.subspan(size);
    }
    [[nodiscard]] std::uint64_t word() {
        std::uint64_t out = 0;
        if (bytes_left_.size() >= sizeof out) read_bytes(&out, sizeof out);
        return out;
    }
    [[nodiscard]] std::string text() const { return {bytes_left_.begin(), bytes_left_.end()}; }

  private:
    std::span<const char> bytes_left_;
};

/// Call f for each table of coefficients that a reader may return.
template <class C, class F>
void for_each_table(C& c, F&& f) {
    f(c.frequency);
    f(c.heading);
    f(c.added_mass);
    f(c.damping);
    f(c.excitation);
    f(c.scattering);
    f(c.drift);
}
constexpr std::size_t kTableCount = 7;

std::string printable(std::string text) {
    if (text.size() > kMaxErrorText) text.resize(kMaxErrorText);
    for (char& c : text)
        if (static_cast<unsigned char>(c) < 0x20 || c == 0x7F) c = '?';
    return text;
}

}  // namespace

std::vector<char> message_of(const WaveCoefficients& c) {
    std::vector<char> out;
    append_word(out, kHydroMagic);
    append_word(out, 1);
    for_each_table(c, [&](const auto& table) { append_word(out, table.size()); });
    append_word(out, (c.has_infinite ? kHasInfinite : 0u) | (c.has_zero ? kHasZero : 0u) |
                         (c.has_stiffness ? kHasStiffness : 0u));
    for (const Matrix6* m : {&c.infinite, &c.zero, &c.stiffness})
        put_bytes(out, m->data(), sizeof(double) * 36);
    for_each_table(c, [&](const auto& table) {
        put_bytes(out, table.data(), table.size() * sizeof(*table.data()));
    });
    return out;
}

std::vector<char> message_of_error(const std::string& text) {
    std::vector<char> out;
    append_word(out, kHydroMagic);
    append_word(out, 0);
    const std::string shown = printable(text.empty() ? "no reason" : text);
    put_bytes(out, shown.data(), shown.size());
    return out;
}

std::optional<HydroMessage> read_message(std::span<const char> bytes) {
    if (bytes.size() < 2 * sizeof(std::uint64_t) || bytes.size() > kMaxHydroMessage)
        return std::nullopt;
    MessageBytes in(bytes);
    if (in.word() != kHydroMagic) return std::nullopt;
    const std::uint64_t kind = in.word();
    HydroMessage out;
    if (kind == 0) {
        out.error = printable(in.text());
        if (out.error.empty()) return std::nullopt;
        return out;
    }
    if (kind != 1 || in.bytes_left() < (kTableCount + 1) * sizeof(std::uint64_t))
        return std::nullopt;
    std::array<std::uint64_t, kTableCount> count{};
    for (std::uint64_t& n : count) n = in.word();
    const std::uint64_t flags = in.word();
    if (flags > (kHasInfinite | kHasZero | kHasStiffness)) return std::nullopt;
    WaveCoefficients& c = out.value;
    std::size_t needed = 3 * sizeof(double) * 36, at = 0;
    bool fits = true;
    for_each_table(c, [&](const auto& table) {
        constexpr std::size_t kEntrySize = sizeof(*table.data());
        const std::uint64_t n = count[at++];
        fits = fits && n <= kMaxHydroMessage / kEntrySize;
        if (fits) needed += static_cast<std::size_t>(n) * kEntrySize;
    });
    if (!fits || needed != in.bytes_left()) return std::nullopt;
    c.has_infinite = (flags & kHasInfinite) != 0;
    c.has_zero = (flags & kHasZero) != 0;
    c.has_stiffness = (flags & kHasStiffness) != 0;
    for (Matrix6* m : {&c.infinite, &c.zero, &c.stiffness})
        in.read_bytes(m->data(), sizeof(double) * 36);
    at = 0;
    for_each_table(c, [&](auto& table) {
        table.resize(static_cast<std::size_t>(count[at++]));
        in.read_bytes(table.data(), table.size() * sizeof(*table.data()));
    });
    return out;
}

}  // namespace hawser::scene
