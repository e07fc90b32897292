// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file field_bytes.h
/// Definitions as bytes: their fields in the order of visit_fields().

#include "record/bytes.h"
#include "record/change_fields.h"

#include <hawser/hawser.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <type_traits>
#include <vector>

namespace hawser::record {

/// Bit of a recorded kind: fields with their names follow those of the table.
inline constexpr unsigned kNamedFields = 0x80;

/// Write the fields of a definition.
struct PutFields {
    ByteWriter& out;

    template <class T>
        requires std::is_arithmetic_v<T>
    void operator()(T value) {
        if constexpr (std::is_same_v<T, bool>)
            out.put(static_cast<std::uint8_t>(value ? 1 : 0));
        else
            out.put(value);
    }
    void operator()(const std::string& text) { out.put_text(text); }
    void operator()(const Vec3& v) {
        for (int i = 0; i < 3; ++i) out.put(v[i]);
    }
    void operator()(const Quat& q) {
        for (const double x : {q.w(), q.x(), q.y(), q.z()}) out.put(x);
    }
    void operator()(const Mat3& m) {
        for (int i = 0; i < 9; ++i) out.put(m(i / 3, i % 3));
    }
    template <class Tag>
    void operator()(const Id<Tag>& id) {
        out.put(id.index);
        out.put(id.generation);
    }
    void operator()(const std::array<std::int32_t, 3>& corners) {
        for (const std::int32_t i : corners) out.put(i);
    }
    template <class E>
    void word(const E& value, int) {
        out.put(static_cast<std::uint8_t>(value));
    }
    template <class E>
    void words(const std::vector<E>& all, int count) {
        out.put(static_cast<std::uint32_t>(all.size()));
        for (const E& each : all) word(each, count);
    }
    /// Write an enumerator `kind` and the members that its field table lists. Members from index
    /// `named` on are written with their names, and only if they differ from the default.
    template <class D, class E, class Rows>
    void table(const D& d, const E& kind, int, const Rows& rows, std::size_t named) {
        std::vector<const FieldInfo<D>*> more;
        for (std::size_t i = named; i < rows.size(); ++i)
            if (!has_default(d, rows[i])) more.push_back(&rows[i]);
        const unsigned bits = static_cast<unsigned>(kind) | (more.empty() ? 0U : kNamedFields);
        out.put(static_cast<std::uint8_t>(bits));
        for (std::size_t i = 0; i < named; ++i) visit_member(d, rows[i], *this);
        if (more.empty()) return;
        out.put(static_cast<std::uint8_t>(more.size()));
        for (const FieldInfo<D>* row : more) {
            out.put_text(row->key);
            visit_member(d, *row, *this);
        }
    }
    template <class T>
        requires std::is_class_v<T>
    void operator()(const T& definition) {
        visit_fields(definition, *this);
    }
    template <class T>
    void list(const std::vector<T>& all) {
        out.put(static_cast<std::uint32_t>(all.size()));
        for (const T& each : all) (*this)(each);
    }
};

/// Read fields in the order in which they were written. The world checks the values.
struct GetFields {
    ByteReader& in;

    template <class T>
        requires std::is_arithmetic_v<T>
    void operator()(T& value) {
        if constexpr (std::is_same_v<T, bool>)
            value = in.get<std::uint8_t>() != 0;
        else
            value = in.get<T>();
    }
    void operator()(std::string& text) { text = in.get_text(); }
    void operator()(Vec3& v) {
        for (int i = 0; i < 3; ++i) v[i] = in.get<double>();
    }
    void operator()(Quat& q) {
        const double w = in.get<double>(), x = in.get<double>(), y = in.get<double>();
        q = Quat(w, x, y, in.get<double>());
    }
    void operator()(Mat3& m) {
        for (int i = 0; i < 9; ++i) m(i / 3, i % 3) = in.get<double>();
    }
    template <class Tag>
    void operator()(Id<Tag>& id) {
        id.index = in.get<std::int32_t>();
        id.generation = in.get<std::int32_t>();
    }
    void operator()(std::array<std::int32_t, 3>& corners) {
        for (std::int32_t& i : corners) i = in.get<std::int32_t>();
    }
    template <class E>
    void word(E& value, int count) {
        const auto number = in.get<std::uint8_t>();
        if (number >= count) throw BadBytes("an enumerated value is out of range");
        value = static_cast<E>(number);
    }
    template <class E>
    void words(std::vector<E>& all, int count) {
        all.resize(in.get_count(1));
        for (E& each : all) word(each, count);
    }
    /// Read a kind and the rows of its field table, as PutFields::table() writes them.
    template <class D, class E, class Rows>
    void table(D& d, E& kind, int count, const Rows& rows, std::size_t named) {
        const unsigned bits = in.get<std::uint8_t>(), number = bits & ~kNamedFields;
        if (number >= static_cast<unsigned>(count))
            throw BadBytes("an enumerated value is out of range");
        kind = static_cast<E>(number);
        for (std::size_t i = 0; i < named; ++i) visit_member(d, rows[i], *this);
        if ((bits & kNamedFields) == 0) return;
        for (unsigned left = in.get<std::uint8_t>(); left > 0; --left) {
            const std::string key = in.get_text();
            const auto row = std::find_if(rows.begin() + static_cast<std::ptrdiff_t>(named),
                                          rows.end(), [&](const auto& r) { return key == r.key; });
            if (row == rows.end())
                throw BadBytes("\"" + key + "\" is a field of a later version of hawser");
            visit_member(d, *row, *this);
        }
    }
    template <class T>
        requires std::is_class_v<T>
    void operator()(T& definition) {
        visit_fields(definition, *this);
    }
    template <class T>
    void list(std::vector<T>& all) {
        // Least size of an entry. For a class it is the size of its numbers and of the counts of
        // its texts and lists.
        constexpr std::size_t kMinEntrySize = std::is_arithmetic_v<T> ? sizeof(T)
                                              : sizeof(T) < 64        ? 8
                                                                      : 32;
        all.resize(in.get_count(kMinEntrySize));
        for (T& each : all) (*this)(each);
    }

    template <class T>
    [[nodiscard]] T value() {
        T out{};
        (*this)(out);
        return out;
    }
    template <class D>
    [[nodiscard]] D definition() {
        D out;
        visit_fields(out, *this);
        return out;
    }
};

}  // namespace hawser::record
