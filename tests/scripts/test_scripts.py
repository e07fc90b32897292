# SPDX-License-Identifier: Apache-2.0
"""The checking scripts must find the faults that they check."""
import importlib.util
import pathlib
import unittest

SCRIPTS = pathlib.Path(__file__).resolve().parents[2] / "scripts"


def load(name: str):
    spec = importlib.util.spec_from_file_location(name, SCRIPTS / f"{name}.py")
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


layers = load("check_layers")
symbols = load("check_isa_symbols")
tidy = load("tidy")
affected = load("affected")
structure = layers.structure
words = load("check_words")


class Layers(unittest.TestCase):
    def setUp(self):
        self.table = layers.read_table()

    def findings(self, path: str, *includes: str) -> int:
        text = "".join(f"#include {i}\n" for i in includes)
        return len(layers.check_cxx(path, text, self.table))

    def test_table_is_complete(self):
        rooms = "base runtime wire graph factor model nonsmooth collide assembly budget " \
                "context state solve contact methods monitor split edit step world scene " \
                "record verify session report draw validate crane marine live export exercise " \
                "debrief vessel apps examples python tests bench"
        self.assertEqual(set(rooms.split()), set(self.table))
        self.assertEqual(self.table["base"], set())
        self.assertEqual(self.table["nonsmooth"], {"base", "factor"})

    def test_allowed(self):
        self.assertEqual(self.findings("src/factor/a.cpp", '"factor/a.h"', '"base/memory.h"',
                                       "<hawser/id.h>", "<amd.h>", "<vector>", "<Eigen/Core>"), 0)
        self.assertEqual(self.findings("src/scene/a.cpp", '"base/check.h"', "<fmt/core.h>"), 0)
        self.assertEqual(self.findings("apps/cli/a.cpp", '"record/files.h"', '"options.h"'), 0)
        self.assertEqual(self.findings("tests/factor/a.cpp", '"step/step.h"'), 0)

    def test_refused(self):
        self.assertEqual(self.findings("src/factor/a.cpp", '"model/bodies.h"'), 1)
        self.assertEqual(self.findings("src/base/a.cpp", '"model/bodies.h"'), 1)
        self.assertEqual(self.findings("src/scene/a.cpp", '"world/world.h"'), 1)
        self.assertEqual(self.findings("apps/cli/a.cpp", '"model/bodies.h"'), 1)
        self.assertEqual(self.findings("src/model/a.cpp", '"bodies.h"'), 1)
        self.assertEqual(self.findings("src/model/a.cpp", "<fmt/core.h>"), 1)
        self.assertEqual(self.findings("src/model/a.cpp", "<amd.h>"), 1)
        self.assertEqual(self.findings("src/unknown/a.cpp"), 1)

    def test_rooms_with_one_header_for_others(self):
        self.assertEqual([f for f, names in self.table.items() if "split" in names], [])
        for header in ("split/split.h", "split/limits.h"):
            rows = {folder for folder, names in self.table.items() if header in names}
            self.assertIn("step", rows)
            for folder in rows:
                self.assertEqual(self.findings(f"src/{folder}/a.cpp", f'"{header}"'), 0)
                self.assertEqual(self.findings(f"src/{folder}/a.cpp", '"split/other.h"'), 1)
        self.assertEqual(self.findings("src/split/a.cpp", '"split/other.h"'), 0)
        for folder in ("state", "solve", "contact", "methods"):
            self.assertEqual(self.findings(f"src/{folder}/a.cpp", '"split/split.h"',
                                           '"split/limits.h"'), 2)

    def test_public_headers(self):
        self.assertEqual(self.findings("include/hawser/a.h", "<hawser/id.h>", "<vector>"), 0)
        self.assertEqual(self.findings("include/hawser/a.h", '"base/check.h"'), 1)
        self.assertEqual(self.findings("include/hawser/a.h", "<fmt/core.h>"), 1)

    def test_length(self):
        text = "\n" * (layers.MAX_LINES + 1)
        self.assertEqual(len(layers.check_cxx("src/base/a.cpp", text, self.table)), 1)

    def test_machine_path(self):
        self.assertTrue(layers.MACHINE_PATH.search('open("/' + 'home/ann/scene.json")'))
        self.assertFalse(layers.MACHINE_PATH.search("build/release/x"))
        self.assertFalse(layers.MACHINE_PATH.search("$(DEMO)" + "/wo" + "rk/x"))


class Structure(unittest.TestCase):
    def test_circles(self):
        sources = {"a/x.h": '#include "a/y.h"', "a/y.h": "", "a/y.cpp": '#include "a/z.h"',
                   "a/z.h": '#include "a/x.h"', "a/w.h": '#include "a/x.h"'}
        edges = structure.module_edges(sources)
        self.assertEqual(structure.circles(edges), [["a/x", "a/y", "a/z"]])
        edges["a/z"].clear()
        self.assertEqual(structure.circles(edges), [])

    def test_circles_above_the_allowance_are_findings(self):
        sources = {"src/base/x.h": '#include "base/y.h"', "src/base/y.h": '#include "base/x.h"'}
        found, count = layers.check_circles(sources)
        self.assertEqual((len(found), count), (1, 1))
        self.assertIn("base/x, base/y", found[0])

    def test_functions(self):
        text = """namespace n {
struct S {
    int one() const { return '}'; }  // }
    S(int a) : a_(a) {
        if (a) { /* } */ }
    }
};
std::vector<int> n::long_one(int a,
                             int b) noexcept {
    auto f = [] { return 1; };
    return {};
}
}"""
        self.assertEqual(structure.functions(text),
                         [("one", 3, 1), ("S", 4, 3), ("n::long_one", 8, 5)])

    def test_kinds(self):
        header = "#define HAWSER_INTERACTION_KINDS(X) \\\n    X(Ball) X(Hinge)\n"
        kinds = structure.kinds_of(header)
        self.assertEqual(kinds, ["Ball", "Hinge"])
        self.assertTrue(structure.asks_for_kind("if (k == InteractionKind::Ball) {}", kinds))
        self.assertTrue(structure.asks_for_kind("case InteractionKind::Hinge:", kinds))
        self.assertFalse(structure.asks_for_kind("add(InteractionKind::Ball, d);", kinds))
        self.assertFalse(structure.asks_for_kind("// k == InteractionKind::Ball", kinds))


class IsaSymbols(unittest.TestCase):
    def test_own(self):
        for name in ("hawser::avx2::factor(double*, int)",
                     "void hawser::avx2::rank<6>(double*)",
                     "guard variable for hawser::avx2::table()::t",
                     "typeinfo for hawser::avx2::Kernel",
                     "DW.ref.__gxx_personality_v0"):
            self.assertTrue(symbols.allowed("avx2", name), name)

    def test_foreign(self):
        for name in ("std::vector<double, std::allocator<double> >::push_back(double const&)",
                     "Eigen::internal::gebp<hawser::avx2::X>(double)",
                     "hawser::model::rows()",
                     "hawser::avx512::factor(double*, int)",
                     "void std::swap<hawser::avx2::X>(hawser::avx2::X&, hawser::avx2::X&)"):
            self.assertFalse(symbols.allowed("avx2", name), name)


class Tidy(unittest.TestCase):
    def test_latest_first_and_headers(self):
        compiled = ["src/factor/numeric.cpp", "src/factor/ordering.cpp", "src/base/isa.cpp"]
        changed = ["src/factor/ordering.cpp", "src/factor/numeric.cpp", "README.md"]
        self.assertEqual(tidy.sources_to_check(changed, compiled),
                         ["src/factor/ordering.cpp", "src/factor/numeric.cpp"])
        self.assertEqual(tidy.sources_to_check(["src/base/isa.h"], ["src/base/isa.cpp"]),
                         ["src/base/isa.cpp"])


class Affected(unittest.TestCase):
    """Changed files -> folders -> tests."""

    def test_folders_of_files(self):
        self.assertEqual(affected.folders_of(["src/draw/svg.cpp", "apps/cli/main.cpp",
                                              "tests/wire/pin_test.cpp", "README.md"]),
                         {"draw", "apps", "tests/wire"})
        self.assertEqual(affected.folders_of(["tests/support/yard.h"]), {"tests/support/yard.h"})
        self.assertEqual(affected.folders_of(["include/hawser/crane.h"]), {"crane"})
        self.assertEqual(affected.folders_of([]), set())

    def test_base_and_build_affect_everything(self):
        for files in (["src/base/isa.cpp"], ["src/model/bodies.h"], ["cmake/HawserIsa.cmake"],
                      ["CMakeLists.txt"], [".ci/run"], None):
            self.assertEqual(affected.folders_of(files), {affected.EVERYTHING}, files)
        self.assertEqual(affected.tests_of({affected.EVERYTHING}), affected.test_folders())

    def test_a_client_reaches_its_tests_and_the_program(self):
        reached = affected.tests_of({"report"})
        self.assertEqual(reached[0], "report")
        self.assertIn("cli", reached)
        for folder in ("factor", "world", "wire", "marine"):
            self.assertNotIn(folder, reached)

    def test_a_room_of_the_library_reaches_what_is_built_on_it(self):
        reached = affected.tests_of({"factor"})
        self.assertEqual(reached[0], "factor")
        for folder in ("assembly", "world", "wire", "session", "cli"):
            self.assertIn(folder, reached)

    def test_support_reaches_the_tests_that_include_it(self):
        reached = affected.tests_of({"tests/support/yard.h"})
        self.assertIn("world", reached)
        self.assertNotIn("factor", reached)

    def test_changed_tests_reach_themselves(self):
        self.assertEqual(affected.tests_of({"tests/wire"}), ["wire"])


class Words(unittest.TestCase):
    """Each rule finds text that breaks it, and accepts text that keeps it."""

    def figures(self, path: str, text: str) -> dict[str, float]:
        return next(iter(words.measure({path: text}).values()))

    def test_what(self):
        self.assertEqual(self.figures("src/base/a.h", "// Tell what it is.\n")["what"], 2500.0)
        self.assertEqual(self.figures("src/base/a.h", "// Return the mass.\n")["what"], 0.0)
        self.assertEqual(self.figures("src/base/a.h", "int what = 1;\n")["what"], 0.0)
        self.assertGreater(self.figures("src/base/a.py", '"""What it does."""\n')["what"], 0.0)

    def test_sentences_that_begin_with_of(self):
        self.assertEqual(self.figures("src/base/a.h", "double m;  ///< Of the drum.\n")["of"], 1000.0)
        self.assertEqual(self.figures("src/base/a.h", "// Mass. Of all bodies.\n")["of"], 500.0)
        self.assertEqual(self.figures("src/base/a.h", "// Mass of all bodies.\n")["of"], 0.0)

    def test_long_sentences(self):
        def text(count: int) -> str:
            return "// " + " ".join(["word"] * count) + ".\n"
        self.assertEqual(self.figures("src/base/a.h", text(25))["long"], 0.0)
        self.assertEqual(self.figures("src/base/a.h", text(26))["long"], 100.0)
        self.assertEqual(self.figures("src/base/a.h", text(26))["longest"], 0.0)
        self.assertEqual(self.figures("src/base/a.h", text(36))["longest"], 100.0)
        self.assertEqual(self.figures("docs/a.md", text(36)[3:])["longest"], 100.0)
        fenced = "```\n" + text(36)[3:] + "```\nShort.\n"
        self.assertEqual(self.figures("docs/a.md", fenced)["longest"], 0.0)

    def test_comments_of_functions_begin_with_a_verb(self):
        def share(comment: str) -> float:
            return self.figures("include/hawser/a.h", f"/// {comment}\n[[nodiscard]] int f(int x);\n")["verb"]
        self.assertEqual(share("Return the mass [kg]."), 100.0)
        self.assertEqual(share("True if the wire is taut."), 100.0)
        self.assertEqual(share("@return the mass."), 100.0)
        self.assertEqual(share("Mass of all bodies."), 0.0)
        self.assertEqual(share("1; or 0: idle."), 0.0)
        members = self.figures("include/hawser/a.h", "/// Mass.\ndouble mass = 1.0;\n")
        self.assertNotIn("verb", members)

    def test_commit_subjects(self):
        good = ["factor: fit kernels to 16 registers", "winch, guide: hold each stop",
                "docs/wires: name the unit"]
        self.assertEqual(words.bad_subjects(good), [])
        bad = ["Look at eight bodies", "factor: Fit kernels", "factor: fit kernels.",
               "factor: " + "x" * 70, "wip"]
        self.assertEqual(len(words.bad_subjects(bad)), len(bad))

    def test_ratchets(self):
        worse, better = {"a": {"what": 50.0}}, {"a": {"what": 30.0}}
        self.assertEqual(len(words.faults_of(worse, {})), 1)
        self.assertEqual(len(words.faults_of(worse, {"a": {"what": 40.0}})), 1)
        self.assertEqual(words.faults_of(better, {"a": {"what": 40.0}}), [])
        self.assertEqual(words.improved(better, {"a": {"what": 40.0}}), better)
        self.assertEqual(words.improved(worse, {"a": {"what": 40.0}}), {"a": {"what": 40.0}})
        self.assertEqual(words.improved({"a": {"what": 1.0}}, {"a": {"what": 40.0}}), {})
        self.assertEqual(len(words.faults_of({"a": {"verb": 50.0}}, {"a": {"verb": 60.0}})), 1)
        self.assertEqual(words.faults_of({"a": {"verb": 70.0}}, {"a": {"verb": 60.0}}), [])


if __name__ == "__main__":
    unittest.main()
