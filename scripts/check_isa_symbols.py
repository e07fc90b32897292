#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Check that kernel objects define nothing outside their own namespace.

usage: check_isa_symbols.py ISA OBJECT...

Files in src/*/isa are compiled once per instruction set. If such an object defines an inline
function of the standard library or of Eigen as a weak symbol, the linker may keep this copy for
the whole program. A machine without the instruction set would then crash in it.
"""
import re
import subprocess
import sys


def allowed(isa: str, name: str) -> bool:
    """True if a name is in namespace hawser::ISA, or data about such a name (guard, type name)."""
    if name == "DW.ref.__gxx_personality_v0":
        return True  # not code: the address of a function, for unwinding
    inside = f"hawser::{isa}::"
    name = re.sub(r"^(guard variable for|typeinfo for|typeinfo name for|vtable for) ", "", name)
    # A template instance prints its return type first: strip `type ` before the name.
    return name.startswith(inside) or re.match(r"^[^(<]*? " + re.escape(inside), name) is not None


def main() -> int:
    if len(sys.argv) < 3:
        print(__doc__)
        return 2
    isa, objects = sys.argv[1], sys.argv[2:]
    bad = []
    symbols = 0
    for path in objects:
        text = subprocess.run(["nm", "--defined-only", "--demangle", path], check=True,
                              capture_output=True, text=True).stdout
        for line in text.splitlines():
            match = re.match(r"^[0-9a-fA-F]* *([A-Za-z]) (.*)$", line)
            if not match:
                continue
            kind, name = match.groups()
            if kind not in "TDBRGSCWVu":  # upper case: visible to the linker; u: unique global
                continue
            symbols += 1
            if not allowed(isa, name):
                bad.append(f"{path}: {kind} {name}")
    for line in bad:
        print(line)
    if symbols == 0:
        print(f"no symbol found in {len(objects)} objects: namespace or build is wrong")
        return 1
    print(f"{isa}: {len(objects)} objects, {symbols} symbols, {len(bad)} outside hawser::{isa}")
    return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main())
