// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file convert.h
/// Conversion of Python values to fields of definitions, and of results to Python values. Errors
/// name the field, the expected form and the given one.

#include "handles.h"

#include <hawser/hydro_files.h>

#include <array>
#include <cmath>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace hawser::python {

/// Word of an enumeration.
template <class E>
struct Word {
    const char* text;
    E value;
};

#include "definitions.inc"

/// Raise ValueError: "field: expected …, got …".
[[noreturn]] void refuse(const std::string& field, const std::string& expected, py::handle given);
/// Return the values of a numeric array of a shape; −1: any length along that axis.
/// @throws py::value_error if shape or dtype differ, or a value is NaN.
py::array_t<double> numbers(py::handle given, const std::string& field,
                            const std::vector<py::ssize_t>& shape);
double number(py::handle given, const std::string& field);
std::int64_t integer(py::handle given, const std::string& field);
std::string text(py::handle given, const std::string& field);
Vec3 vector(py::handle given, const std::string& field);
/// Return a path, given as text or os.PathLike.
std::string path(const py::object& given, const std::string& field);

/// Return the nearest of several names as "; nearest: …", or "".
std::string nearest(const std::string& name, const std::vector<std::string>& names);

/// Return the id of a handle or name.
template <class Id>
Id find_id(WorldBox& box, py::handle given, const std::string& field) {
    if (py::isinstance<py::str>(given)) {
        const auto name = given.cast<std::string>();
        const Id id = Kind<Id>::find(box.read(), name);
        if (!id.valid())
            throw DefError(field + ": there is no " + Kind<Id>::name + " \"" + name + "\"");
        return id;
    }
    if (!py::isinstance<Handle<Id>>(given))
        refuse(field, std::string("a handle or name of a ") + Kind<Id>::name, given);
    const auto& handle = given.cast<const Handle<Id>&>();
    if (handle.checked().get() != &box)
        throw DefError(field + ": this " + Kind<Id>::name + " belongs to another world");
    return handle.id;
}

/// Reads the fields of a definition from a dict.
class Reader {
  public:
    Reader(WorldBox& box, py::dict given, std::string path)
        : box_(box), given_(std::move(given)), path_(std::move(path)) {}

    template <class T>
    void operator()(const char* key, T& out) {
        known_.emplace_back(key);
        if (!given_.contains(key)) return;
        const py::object value = given_[key];
        ++used_;
        if (!value.is_none()) convert(value, out, path_ + "." + key);
    }
    /// Check that all keys were read. @throws py::type_error with the nearest key.
    void finish() const;

    /// Read a definition from a dict.
    template <class Def>
    static void read(WorldBox& box, const py::dict& given, const std::string& path, Def& def) {
        Reader reader(box, given, path);
        fields(reader, def);
        reader.finish();
    }

  private:
    template <class T>
    void convert(const py::object& value, T& out, const std::string& field);
    /// Read coefficients of a floating body from a file.
    std::shared_ptr<const WaveCoefficients> coefficients(const py::object& value,
                                                         const std::string& field);

    WorldBox& box_;
    py::dict given_;
    std::string path_;
    std::vector<std::string> known_;
    std::size_t used_ = 0;
};

template <class T>
struct IsVector : std::false_type {};
template <class T>
struct IsVector<std::vector<T>> : std::true_type {};
template <class T>
struct IsArray : std::false_type {};
template <class T, std::size_t N>
struct IsArray<std::array<T, N>> : std::true_type {};
template <class T>
struct IsOptional : std::false_type {};
template <class T>
struct IsOptional<std::optional<T>> : std::true_type {};
template <class T>
struct IsId : std::false_type {};
template <class Tag>
struct IsId<Id<Tag>> : std::true_type {};

template <class E>
E word(py::handle given, const std::string& field) {
    const std::string name = text(given, field);
    std::vector<std::string> all;
    for (const auto& w : words(E{})) {
        if (name == w.text) return w.value;
        all.emplace_back(w.text);
    }
    throw py::value_error(field + ": \"" + name + "\" is none of its values" + nearest(name, all));
}

template <class T>
void Reader::convert(const py::object& value, T& out, const std::string& field) {
    if constexpr (std::is_same_v<T, bool>) {
        if (!py::isinstance<py::bool_>(value)) refuse(field, "True or False", value);
        out = value.cast<bool>();
    } else if constexpr (std::is_same_v<T, double>) {
        out = number(value, field);
    } else if constexpr (std::is_integral_v<T>) {
        const std::int64_t n = integer(value, field);
        out = static_cast<T>(n);
        if (static_cast<std::int64_t>(out) != n || (std::is_unsigned_v<T> && n < 0))
            throw py::value_error(field + ": " + std::to_string(n) + " is out of range");
    } else if constexpr (std::is_enum_v<T>) {
        out = word<T>(value, field);
    } else if constexpr (std::is_same_v<T, std::string>) {
        out = text(value, field);
    } else if constexpr (std::is_same_v<T, Vec3>) {
        out = vector(value, field);
    } else if constexpr (std::is_same_v<T, Quat>) {
        const auto a = numbers(value, field, {4});
        out = Quat(a.at(0), a.at(1), a.at(2), a.at(3));
    } else if constexpr (std::is_same_v<T, Mat3>) {
        const auto a = numbers(value, field, {3, 3});
        for (int i = 0; i < 3; ++i)
            for (int j = 0; j < 3; ++j) out(i, j) = a.at(i, j);
    } else if constexpr (std::is_same_v<T, std::shared_ptr<const WaveCoefficients>>) {
        out = coefficients(value, field);
    } else if constexpr (std::is_same_v<T, HullMesh>) {
        if (py::isinstance<py::dict>(value))
            read(box_, value.cast<py::dict>(), field, out);
        else
            out = read_hull(path(value, field));
    } else if constexpr (IsId<T>::value) {
        out = find_id<T>(box_, value, field);
    } else if constexpr (IsOptional<T>::value) {
        typename T::value_type inner{};
        convert(value, inner, field);
        out = std::move(inner);
    } else if constexpr (std::is_same_v<T, std::vector<double>>) {
        const auto a = numbers(value, field, {-1});
        out.assign(a.data(), a.data() + a.size());
    } else if constexpr (std::is_same_v<T, std::vector<Vec3>>) {
        const auto a = numbers(value, field, {-1, 3});
        out.clear();
        for (py::ssize_t i = 0; i < a.shape(0); ++i)
            out.emplace_back(a.at(i, 0), a.at(i, 1), a.at(i, 2));
    } else if constexpr (std::is_same_v<T, std::vector<std::array<std::int32_t, 3>>>) {
        const auto a = numbers(value, field, {-1, 3});
        out.clear();
        for (py::ssize_t i = 0; i < a.shape(0); ++i) {
            std::array<std::int32_t, 3> corner{};
            for (int k = 0; k < 3; ++k) {
                corner[static_cast<std::size_t>(k)] = static_cast<std::int32_t>(a.at(i, k));
                if (a.at(i, k) != corner[static_cast<std::size_t>(k)])
                    throw py::value_error(field + ": vertex indices must be integers");
            }
            out.push_back(corner);
        }
    } else if constexpr (IsArray<T>::value) {
        const auto a = numbers(value, field, {static_cast<py::ssize_t>(out.size())});
        std::copy_n(a.data(), out.size(), out.begin());
    } else if constexpr (IsVector<T>::value) {
        if (!py::isinstance<py::sequence>(value) || py::isinstance<py::str>(value))
            refuse(field, "a list", value);
        out.clear();
        std::size_t i = 0;
        for (const py::handle entry : value) {
            typename T::value_type inner{};
            convert(py::reinterpret_borrow<py::object>(entry), inner,
                    field + "[" + std::to_string(i++) + "]");
            out.push_back(std::move(inner));
        }
    } else {
        if (!py::isinstance<py::dict>(value)) refuse(field, "a dict of its fields", value);
        read(box_, value.cast<py::dict>(), field, out);
    }
}

/// Writes the ids of a result as a types.SimpleNamespace of handles; invalid ids are None.
class ResultWriter {
  public:
    explicit ResultWriter(std::shared_ptr<WorldBox> box) : box_(std::move(box)) {}
    template <class T>
    void operator()(const char* key, T& value) {
        made_[key] = write(value);
    }
    template <class Ids>
    py::object result(Ids ids) {
        fields(*this, ids);
        return py::module_::import("types").attr("SimpleNamespace")(**made_);
    }
    template <class T>
    py::object write(T& value) {
        if constexpr (IsId<T>::value) {
            if (!value.valid()) return py::none();
            return py::cast(Handle<T>{box_, value});
        } else if constexpr (IsVector<T>::value) {
            py::list list;
            for (auto& entry : value) list.append(write(entry));
            return list;
        } else {
            return ResultWriter(box_).result(value);
        }
    }

  private:
    std::shared_ptr<WorldBox> box_;
    py::dict made_;
};

template <class Id>
py::object handle_of(const std::shared_ptr<WorldBox>& box, Id id) {
    if (!id.valid()) return py::none();
    return py::cast(Handle<Id>{box, id});
}
template <class Ids>
py::list handles_of(const std::shared_ptr<WorldBox>& box, const Ids& ids) {
    py::list list;
    for (const auto& id : ids) list.append(handle_of(box, id));
    return list;
}
/// Return a new array with the numbers of a vector.
py::array_t<double> array_of(const Vec3& v);
py::array_t<double> array_of(std::span<const double> values);

}  // namespace hawser::python
