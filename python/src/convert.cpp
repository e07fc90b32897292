// SPDX-License-Identifier: Apache-2.0
#include "convert.h"

#include <algorithm>

namespace hawser::python {
namespace {

std::string shape_text(const std::vector<py::ssize_t>& shape) {
    std::string out = "(";
    for (std::size_t i = 0; i < shape.size(); ++i)
        out += (i > 0 ? ", " : "") + (shape[i] < 0 ? std::string("n") : std::to_string(shape[i]));
    return out + (shape.size() == 1 ? ",)" : ")");
}

}  // namespace

void refuse(const std::string& field, const std::string& expected, py::handle given) {
    throw py::value_error(field + ": expected " + expected + ", got " +
                          py::str(py::type::of(given).attr("__name__")).cast<std::string>() + " " +
                          py::repr(given).cast<std::string>().substr(0, 80));
}

py::array_t<double> numbers(py::handle given, const std::string& field,
                            const std::vector<py::ssize_t>& shape) {
    const py::array array = py::array::ensure(given);
    const std::string wanted = "numbers of shape " + shape_text(shape);
    if (!array) {
        PyErr_Clear();
        refuse(field, wanted, given);
    }
    const std::vector<py::ssize_t> found(array.shape(), array.shape() + array.ndim());
    bool fits = found.size() == shape.size();
    for (std::size_t i = 0; fits && i < shape.size(); ++i)
        fits = shape[i] < 0 || shape[i] == found[i];
    // An empty list has no second axis.
    if (!fits && array.size() == 0 && !shape.empty() && shape[0] < 0 && found.size() == 1) {
        std::vector<py::ssize_t> none(shape);
        none[0] = 0;
        return py::array_t<double>(none);
    }
    const char kind = array.dtype().kind();
    const bool real = kind == 'i' || kind == 'u' || kind == 'f' || kind == 'b';
    if (!fits || !real)
        throw py::value_error(field + ": expected " + wanted + " and dtype float64, got shape " +
                              shape_text(found) + " and dtype " +
                              py::str(array.dtype()).cast<std::string>());
    auto out = py::array_t < double, py::array::c_style | py::array::forcecast > ::ensure(array);
    if (!out) throw py::error_already_set();
    const double* const data = out.data();
    for (py::ssize_t i = 0; i < out.size(); ++i)
        if (std::isnan(data[i]))
            throw py::value_error(field + ": value " + std::to_string(i) + " is NaN");
    return out;
}

double number(py::handle given, const std::string& field) {
    if (PyFloat_Check(given.ptr()) == 0 && PyIndex_Check(given.ptr()) == 0 &&
        !py::hasattr(given, "__float__"))
        refuse(field, "a number", given);
    const double value = PyFloat_AsDouble(given.ptr());
    if (value == -1.0 && PyErr_Occurred() != nullptr) {
        PyErr_Clear();
        refuse(field, "a number", given);
    }
    if (std::isnan(value)) throw py::value_error(field + ": the value is NaN");
    return value;
}

std::int64_t integer(py::handle given, const std::string& field) {
    if (PyIndex_Check(given.ptr()) == 0) refuse(field, "an integer", given);
    const py::object index = py::reinterpret_steal<py::object>(PyNumber_Index(given.ptr()));
    if (!index) throw py::error_already_set();
    int overflow = 0;
    const std::int64_t value = PyLong_AsLongLongAndOverflow(index.ptr(), &overflow);
    if (overflow != 0) refuse(field, "an integer of 64 bits", given);
    return value;
}

std::string text(py::handle given, const std::string& field) {
    if (!py::isinstance<py::str>(given)) refuse(field, "a str", given);
    return given.cast<std::string>();
}

Vec3 vector(py::handle given, const std::string& field) {
    if (PyTuple_Check(given.ptr()) != 0 || PyList_Check(given.ptr()) != 0) {  // no array needed
        PyObject* const sequence = given.ptr();
        if (PySequence_Fast_GET_SIZE(sequence) == 3) {
            Vec3 out;
            int taken = 0;
            for (; taken < 3; ++taken) {
                PyObject* const entry = PySequence_Fast_GET_ITEM(sequence, taken);
                if (PyFloat_Check(entry) == 0 || std::isnan(PyFloat_AS_DOUBLE(entry))) break;
                out[taken] = PyFloat_AS_DOUBLE(entry);
            }
            if (taken == 3) return out;
        }
    }
    const auto a = numbers(given, field, {3});
    return {a.at(0), a.at(1), a.at(2)};
}

std::string path(const py::object& given, const std::string& field) {
    if (!py::isinstance<py::str>(given) && !py::hasattr(given, "__fspath__"))
        refuse(field, "a path, or a dict of its fields", given);
    return text(py::module_::import("os").attr("fspath")(given), field);
}

std::shared_ptr<const WaveCoefficients> Reader::coefficients(const py::object& value,
                                                             const std::string& field) {
    HydroUnits units;
    py::object file = value;
    if (py::isinstance<py::dict>(value)) {
        const auto given = value.attr("copy")().cast<py::dict>();
        if (!given.contains("file")) refuse(field, "the key file", value);
        file = given.attr("pop")("file");
        read(box_, given, field, units);
    }
    return std::make_shared<const WaveCoefficients>(
        read_coefficients(path(file, field + ".file"), units));
}

std::string nearest(const std::string& name, const std::vector<std::string>& names) {
    py::list all;
    for (const std::string& n : names) all.append(n);
    const py::list near = py::module_::import("difflib").attr("get_close_matches")(name, all, 1);
    if (near.empty()) {
        std::string list;
        for (const std::string& n : names) list += (list.empty() ? "" : ", ") + n;
        return names.size() > 12 ? "" : "; known: " + list;
    }
    return "; nearest: \"" + near[0].cast<std::string>() + "\"";
}

void Reader::finish() const {
    if (used_ == py::len(given_)) return;
    for (const auto& [key, value] : given_) {
        const auto name = py::str(key).cast<std::string>();
        if (std::find(known_.begin(), known_.end(), name) == known_.end())
            throw py::type_error(path_ + ": there is no field \"" + name + "\"" +
                                 nearest(name, known_));
    }
}

py::array_t<double> array_of(const Vec3& v) { return array_of(std::span(v.data(), 3)); }
py::array_t<double> array_of(std::span<const double> values) {
    return py::array_t<double>(static_cast<py::ssize_t>(values.size()), values.data());
}

}  // namespace hawser::python
