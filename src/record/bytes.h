// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file bytes.h
/// Little-endian numbers and strings in byte buffers, with bounds checks, and CRC-32.

#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace hawser::record {

[[nodiscard]] inline std::string_view as_text(std::span<const std::byte> bytes) {
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

static_assert(std::endian::native == std::endian::little, "files are little-endian");

/// Invalid bytes.
struct BadBytes : std::runtime_error {
    using std::runtime_error::runtime_error;
};

class ByteWriter {
  public:
    template <class T>
        requires std::is_arithmetic_v<T>
    void put(T value) {
        const auto* p = reinterpret_cast<const std::byte*>(&value);
        bytes_.insert(bytes_.end(), p, p + sizeof value);
    }
    void write_bytes(std::span<const std::byte> bytes) {
        bytes_.insert(bytes_.end(), bytes.begin(), bytes.end());
    }
    /// Write the length in 4 bytes, then the characters.
    void put_text(std::string_view text) {
        if (text.size() > std::numeric_limits<std::uint32_t>::max())
            throw BadBytes("a text is longer than 4 GiB");
        put(static_cast<std::uint32_t>(text.size()));
        write_bytes(std::as_bytes(std::span(text.data(), text.size())));
    }
    void clear() noexcept { bytes_.clear(); }
    /// Drop all but the first `size` bytes.
    void truncate(std::size_t size) noexcept {
        if (size < bytes_.size()) bytes_.resize(size);
    }
    [[nodiscard]] std::span<const std::byte> bytes() const noexcept { return bytes_; }

  private:
    std::vector<std::byte> bytes_;
};

/// Reads the output of ByteWriter. Every function throws BadBytes at the end of the bytes.
class ByteReader {
  public:
    explicit ByteReader(std::span<const std::byte> bytes) : bytes_(bytes) {}

    template <class T>
        requires std::is_arithmetic_v<T>
    [[nodiscard]] T get() {
        T value{};
        std::memcpy(&value, take(sizeof value).data(), sizeof value);
        return value;
    }
    [[nodiscard]] std::string get_text() {
        const auto bytes = take(get<std::uint32_t>());
        return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
    }
    /// Read the number of following entries. Throw if they cannot fit in the remaining bytes.
    /// @param least Smallest size of one entry [bytes].
    [[nodiscard]] std::size_t get_count(std::size_t least) {
        const std::size_t count = get<std::uint32_t>();
        if (count > bytes_left() / least) throw BadBytes("a count is larger than its data");
        return count;
    }
    [[nodiscard]] std::span<const std::byte> take(std::size_t size) {
        if (size > bytes_left()) throw BadBytes("data end too early");
        const auto out = bytes_.subspan(at_, size);
        at_ += size;
        return out;
    }
    [[nodiscard]] std::size_t bytes_left() const noexcept { return bytes_.size() - at_; }
    /// Check that all bytes have been read. @throws BadBytes if bytes remain.
    void expect_end() const {
        if (bytes_left() != 0) throw BadBytes("data are longer than expected");
    }

  private:
    std::span<const std::byte> bytes_;
    std::size_t at_ = 0;
};

/// Compute CRC-32 as in zlib and PNG (polynomial 0xEDB88320). Continue with the previous result.
[[nodiscard]] std::uint32_t crc32(std::span<const std::byte> bytes, std::uint32_t before = 0);

}  // namespace hawser::record
