// SPDX-License-Identifier: Apache-2.0
#include "bindings.h"
#include "system.h"

#include <hawser/machine.h>

PYBIND11_MODULE(_core, module) {
    using namespace hawser::python;
    module.doc() = "Compiled part of the package hawser; use it by `import hawser`.";
    bind_errors();
    bind_handles(module);
    bind_systems(module);
    WorldClass world = bind_world(module);
    bind_definitions(world);
    bind_session(module);
    bind_recording(module);
    module.attr("__version__") = hawser::version();
    module.def(
        "instruction_set", [] { return hawser::instruction_set(); },
        "Return the name of the instruction set in use, which is part of every hash.");
}
