// SPDX-License-Identifier: Apache-2.0
#include "bindings.h"

#include <hawser/recording.h>
#include <hawser/scene.h>

namespace hawser::python {
namespace {

/// Raise an exception class of hawser.errors.
template <class... Args>
void raise(const char* name, Args&&... args) {
    const py::object type = py::module_::import("hawser.errors").attr(name);
    const py::object error = type(std::forward<Args>(args)...);
    PyErr_SetObject(type.ptr(), error.ptr());
}

void translate(std::exception_ptr pointer) {
    try {
        std::rethrow_exception(std::move(pointer));
    } catch (const StepFailed& e) {
        raise("StepError", e.status, e.message);
    } catch (const ObjectRemoved& e) {
        raise("RemovedError", e.what());
    } catch (const scene::SceneError& e) {
        raise("SceneError", e.what(), e.file, e.path, e.message);
    } catch (const DefError& e) {
        raise("DefError", e.what());
    } catch (const LimitError& e) {
        raise("LimitError", e.what());
    } catch (const UseError& e) {
        raise("UseError", e.what());
    } catch (const ThreadError& e) {
        raise("ThreadError", e.what());
    } catch (const EnvironmentError& e) {
        raise("Error", e.what());
    } catch (const record::RecordingError& e) {
        raise("RecordingError", e.what());
    }
}

}  // namespace

void bind_errors() { py::register_exception_translator(translate); }

}  // namespace hawser::python
