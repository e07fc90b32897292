#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Generate the Python form of the C++ definitions from the public headers.

usage: definitions.py INCLUDE_DIR CORE_PYI OUT_DIR

Reads the structs named in METHODS, and all structs that they contain, from INCLUDE_DIR/hawser.
Writes to OUT_DIR:
- definitions.inc: for each struct a function `fields(visitor, definition)`, names of enumerators,
  and a docstring in numpy style
- _core.pyi: CORE_PYI with the methods of World added

A field keeps its name, default, unit and description. Python passes files for the types in FILES.
"""
from __future__ import annotations

import dataclasses
import keyword
import pathlib
import re
import sys
import textwrap

# Method of World, struct, first sentence of its docstring, type of the result. A "define" method
# calls World::add(); the others have their own call in src/world_add.cpp.
METHODS = [
    ("add_body", "BodyDef", "Add a body.", "Body"),
    ("add_input", "InputDef", "Add an input.", "Input"),
    ("add_output", "OutputDef", "Add an output.", "Output"),
    ("add_material", "MaterialDef", "Add a material.", "Material"),
    ("add_material_pair", "MaterialPairDef", "Set the contact law of two materials.", "None"),
    ("add_shape", "ShapeDef", "Add a collision shape.", "Shape"),
    ("add_wire", "WireDef", "Add a wire.", "Wire"),
    ("add_hinge", "HingeDef", "Add a hinge.", "SimpleNamespace"),
    ("add_prismatic", "PrismaticDef", "Add a prismatic joint.", "SimpleNamespace"),
    ("add_cylindrical", "CylindricalDef", "Add a cylindrical joint.", "SimpleNamespace"),
    ("add_universal", "UniversalDef", "Add a universal joint.", "Interaction"),
    ("add_ball", "BallDef", "Add a ball joint.", "Interaction"),
    ("add_lock", "LockDef", "Add a lock.", "Interaction"),
    ("add_gear", "GearDef", "Add a pair of gear wheels.", "Interaction"),
    ("add_distance", "DistanceDef", "Add a rod or spring.", "Interaction"),
    ("add_stretch", "StretchDef", "Add an elastic line element.", "Interaction"),
    ("add_winch_stretch", "WinchStretchDef", "Add a line element at a drum.", "Interaction"),
    ("add_bend", "BendDef", "Add bending stiffness at a node.", "Interaction"),
    ("add_twist", "TwistDef", "Add torsional stiffness.", "Interaction"),
    ("add_hydrostatic", "HydrostaticDef", "Add linear hydrostatic stiffness.", "Interaction"),
    ("add_drum", "DrumDef", "Add motor, brake and hold of a drum.", "SimpleNamespace"),
    ("add_winch", "WinchDef", "Add a winch.", "SimpleNamespace"),
    ("add_knuckle_crane", "KnuckleCraneDef", "Add a knuckle-boom crane.", "SimpleNamespace"),
    ("add_lattice_crane", "LatticeCraneDef", "Add a lattice crane.", "SimpleNamespace"),
    ("add_sea", "SeaDef", "Add the sea.", "None"),
]
RESULTS = ["JointIds", "AxisIds", "CylindricalIds", "DrumIds", "WinchIds", "CraneIds"]
EXTRA = ["JoinDef", "HydroUnits"]  # used by methods of Wire, and for files of coefficients
HEADERS = ["def.h", "interactions.h", "math.h", "outputs.h", "shapes.h", "wire.h", "joints.h", "lines.h", "winch.h",
           "crane.h", "sea.h", "hull.h", "water_hull.h", "water_rod.h",
           "hydro.h", "hydro_files.h"]
FILES = {"std::shared_ptr<const WaveCoefficients>":
         ("str | PathLike[str] | Mapping[str, Any]",
          "path, or dict: key file and those of HydroUnits"),
         "HullMesh": ("str | PathLike[str] | Mapping[str, Any]", "path, or dict: HullMesh")}
VECTORS = {"Vec3": "three numbers", "Quat": "quaternion w, x, y, z", "Mat3": "3 × 3 numbers"}
HANDLES = {"BodyId": "Body", "InteractionId": "Interaction", "InputId": "Input",
           "ShapeId": "Shape", "MaterialId": "Material", "WireId": "Wire", "OutputId": "Output"}


@dataclasses.dataclass
class Field:
    type: str
    name: str
    default: str
    doc: str


@dataclasses.dataclass
class Struct:
    name: str
    doc: str
    fields: list[Field]


def outside(text: str, separator: str) -> list[str]:
    """Split at separators outside brackets."""
    parts, depth, start = [], 0, 0
    for i, c in enumerate(text):
        depth += (c in "([{<") - (c in ")]}>")
        if c == separator and depth == 0:
            parts.append(text[start:i])
            start = i + 1
    return parts + [text[start:]]


def closing(text: str, at: int) -> int:
    """Return the index of the brace that closes the one at an index."""
    depth = 0
    for i in range(at, len(text)):
        depth += (text[i] == "{") - (text[i] == "}")
        if depth == 0:
            return i
    raise ValueError("unbalanced braces")


def without_comments(line: str) -> tuple[str, str, str]:
    """Return code, comment before a member (///) and comment behind it (///<) of a line."""
    if "///<" in line:
        code, doc = line.split("///<", 1)
        return code.strip(), "", doc.strip()
    if "///" in line:
        code, doc = line.split("///", 1)
        return code.strip(), doc.strip(), ""
    return line.split("//", 1)[0].strip(), "", ""


def members(body: str, owner: str, found: dict[str, Struct]) -> list[Field]:
    """Return the data members of a struct, and enter nested structs in `found`."""
    fields: list[Field] = []
    before: list[str] = []
    statement, latest, skipping = "", 0, 0
    for line in body.splitlines():
        code, ahead, behind = without_comments(line)
        if skipping:
            skipping += code.count("{") - code.count("}")
            statement = "" if skipping == 0 else statement
            continue
        if ahead:
            before.append(ahead)
        if not code and behind:
            for field in fields[latest:]:
                field.doc = f"{field.doc} {behind}".strip()
            continue
        if re.match(r"(private|public|protected)\s*:", code):
            break
        if not statement and re.match(r"struct \w+ \{", code):
            before = []
            skipping = 1
            continue
        if not statement and "(" in re.split(r"[={]", code, maxsplit=1)[0]:  # a function
            before = []
            skipping = code.count("{") - code.count("}")
            statement = "" if skipping == 0 and code.endswith((";", "}")) else code
            continue
        statement = f"{statement} {code}".strip()
        doc = behind
        if not statement.endswith(";"):
            if doc:
                before.append(doc)
            continue
        latest = len(fields)
        fields += declared(statement[:-1], " ".join([*before, doc]).strip())
        statement, before = "", []
    return fields


def declared(statement: str, doc: str) -> list[Field]:
    """Return the members of one declaration."""
    depth = 0
    for i, c in enumerate(statement):
        depth += (c == "<") - (c == ">")
        if c == " " and depth == 0 and statement[:i] != "const":
            break
    else:
        return []
    kind, rest = statement[:i], statement[i + 1:]
    out = []
    for declarator in outside(rest, ","):
        match = re.match(r"\s*(\w+)\s*(?:=\s*(.*)|\{(.*)\})?$", declarator, re.DOTALL)
        if match:
            default = (match.group(2) or match.group(3) or "").strip()
            out.append(Field(kind, match.group(1), default, doc))
    return out


def read(include: pathlib.Path) -> tuple[dict[str, Struct], dict[str, list[str]]]:
    """Return structs and enumerators of the headers."""
    structs: dict[str, Struct] = {}
    enums: dict[str, list[str]] = {}
    for header in HEADERS:
        text = (include / "hawser" / header).read_text(encoding="utf-8")
        for match in re.finditer(r"^([ ]*)(?:enum class (\w+) : [\w:]+|struct (\w+)) \{", text,
                                 re.MULTILINE):
            end = closing(text, match.end() - 1)
            body = text[match.end():end]
            if match.group(2):
                code = " ".join(without_comments(line)[0] for line in body.splitlines())
                enums[match.group(2)] = re.findall(r"\w+", code)
                continue
            name = match.group(3)
            if match.group(1):  # nested
                outer = re.findall(r"^struct (\w+) \{", text[:match.start()], re.MULTILINE)[-1]
                name = f"{outer}::{name}"
            doc = []
            for line in reversed(text[:match.start()].splitlines()):
                if not line.strip().startswith("///"):
                    break
                doc.append(line.strip()[3:].strip())
            structs[name] = Struct(name, " ".join(reversed(doc)), members(body, name, structs))
    return structs, enums


def inner(kind: str) -> list[str]:
    """Return the types that a type is made of."""
    return re.findall(r"[\w:]+", kind.replace("std::", ""))


def wanted(structs: dict[str, Struct], start: list[str]) -> list[str]:
    """Return the structs that those in `start` contain, contained ones first."""
    order: list[str] = []

    def visit(name: str) -> None:
        if name in order:
            return
        for field in structs[name].fields:
            if field.type.startswith("std::shared_ptr"):
                continue
            for kind in inner(field.type):
                full = kind if kind in structs else f"{name}::{kind}"
                if full in structs and full != name:
                    visit(full)
        order.append(name)

    for name in start:
        visit(name)
    return order


def python_type(kind: str, owner: str, structs: dict[str, Struct],
                enums: dict[str, list[str]]) -> tuple[str, str]:
    """Return the type for stubs and its name for docstrings."""
    if kind in FILES:
        return FILES[kind]
    if kind == "double":
        return "float", "float"
    if kind == "bool":
        return "bool", "bool"
    if kind in ("int", "std::int32_t", "std::uint32_t", "std::uint64_t", "std::int64_t"):
        return "int", "int"
    if kind == "std::string":
        return "str", "str"
    if kind in VECTORS:
        return "ArrayLike", VECTORS[kind]
    if kind in HANDLES:
        handle = HANDLES[kind]
        named = f"{handle} | str" if handle in ("Body", "Interaction", "Wire", "Material") else handle
        return named, f"{handle} or name" if "str" in named else handle
    if kind == "InteractionKind" or kind == "OutputKind":
        return "str", "str"
    if kind in enums:
        words = ", ".join(f'"{w}"' for w in enums[kind])
        return f"Literal[{words}]", "{" + ", ".join(f"'{w}'" for w in enums[kind]) + "}"
    match = re.match(r"std::(vector|optional|array)<(.*)>$", kind)
    if match:
        what, of = match.groups()
        if what == "array":
            of, size = outside(of, ",")
            return "ArrayLike", f"{size.strip()} values"
        stub, word = python_type(of, owner, structs, enums)
        if what == "optional":
            return f"{stub} | None", f"{word} or None"
        return ("ArrayLike" if stub == "ArrayLike" else f"Sequence[{stub}]"), f"list of {word}"
    for name in (kind, f"{owner}::{kind}"):
        if name in structs:
            return "Mapping[str, Any]", f"dict: {name.split('::')[-1]}"
    raise ValueError(f"{owner}: no Python form of {kind}")


def python_name(name: str) -> str:
    """Return the name of a keyword argument."""
    return name + "_" if keyword.iskeyword(name) else name


def default_of(field: Field) -> str:
    """Return a default for docstrings; "" if it says nothing."""
    text = field.default.rstrip("f")
    if text in ("", "kDefault", "true", "false"):
        return {"true": "True", "false": "False"}.get(text, "")
    if re.fullmatch(r"-?[\d.]+(e-?\d+)?", text):
        return "" if text in ("1e30", "-1e30") else text
    match = re.fullmatch(r"[\w]+::([a-z_]+)", text)
    return f"'{match.group(1)}'" if match else ""


def described(struct: Struct, structs: dict[str, Struct], enums: dict[str, list[str]],
              indent: str = "") -> list[str]:
    """Return the lines of the parameters of a struct."""
    lines = []
    for field in struct.fields:
        _, word = python_type(field.type, struct.name, structs, enums)
        default = default_of(field)
        required = "Required." in field.doc
        tail = "" if required else f", default {default}" if default else ", optional"
        lines.append(f"{indent}{python_name(field.name)} : {word}{tail}")
        doc = re.sub(r"\s*Required\.", "", field.doc)
        lines += textwrap.wrap(doc, 88 - len(indent), initial_indent=indent + "    ",
                               subsequent_indent=indent + "    ")
    return lines


def docstring(first: str, struct: Struct, result: str, structs: dict[str, Struct],
              enums: dict[str, list[str]]) -> str:
    """Return a docstring in numpy style."""
    doc = struct.doc if struct.doc.rstrip(".") not in first else ""
    lines = [first, "", *textwrap.wrap(doc, 92), *([""] if doc else []), "Parameters", "----------"]
    lines += described(struct, structs, enums)
    for name in wanted(structs, [struct.name])[:-1]:
        inner_struct = structs[name]
        lines += ["", f"Keys of {name.split('::')[-1]}:", ""]
        lines += described(inner_struct, structs, enums, "    ")
    lines += ["", "Returns", "-------", result, "", "Raises", "------", "DefError",
              "    If the world rejects the definition.", "ValueError",
              "    If a value has the wrong type or shape, or is NaN.", "TypeError",
              "    If a key does not exist."]
    return "\n".join(lines)


def stub(method: str, struct: Struct, first: str, result: str, structs: dict[str, Struct],
         enums: dict[str, list[str]]) -> str:
    """Return the stub of a method."""
    lines = [f"    def {method}(", "        self,", "        *,"]
    for field in struct.fields:
        kind, _ = python_type(field.type, struct.name, structs, enums)
        optional = kind if kind.endswith("None") else f"{kind} | None"
        lines.append(f"        {python_name(field.name)}: {optional} = ...,")
    return "\n".join([*lines, f"    ) -> {result}: ..."])


def main() -> int:
    include, template, out = map(pathlib.Path, sys.argv[1:4])
    structs, enums = read(include)
    names = wanted(structs, [m[1] for m in METHODS] + RESULTS + EXTRA)
    lines = ["// Generated by python/tools/definitions.py from the public headers.", ""]
    used = {k for n in names for f in structs[n].fields for k in inner(f.type) if k in enums}
    for name in sorted(used - {"InteractionKind"}):
        entries = ", ".join(f'{{"{w}", {name}::{w}}}' for w in enums[name])
        lines.append(f"inline std::span<const Word<{name}>> words(const {name}&) {{")
        lines.append(f"    static constexpr Word<{name}> all[] = {{{entries}}};")
        lines.append("    return all;\n}")
    for name in names:
        lines.append(f"template <class V>\nvoid fields(V& v, {name}& d) {{")
        lines += [f'    v("{f.name}", d.{f.name});' for f in structs[name].fields]
        lines.append("}")
    for method, name, first, result in METHODS:
        text = docstring(first, structs[name], result, structs, enums)
        lines.append(f'inline constexpr const char* doc_{method} = R"doc({text})doc";')
    stubs = [stub(m, structs[n], first, result, structs, enums)
             for m, n, first, result in METHODS]
    out.mkdir(parents=True, exist_ok=True)
    pyi = template.read_text(encoding="utf-8").replace("    #@definitions\n", "\n".join(stubs) + "\n")
    for file, content in ((out / "definitions.inc", "\n".join(lines) + "\n"),
                          (out / "_core.pyi", pyi)):
        if not file.exists() or file.read_text(encoding="utf-8") != content:
            file.write_text(content, encoding="utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main())
