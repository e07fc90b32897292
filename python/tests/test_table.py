# SPDX-License-Identifier: Apache-2.0
"""Test hawser.table and `python3 -m hawser` with tables like those of `hawser run --csv`."""
import contextlib
import io
import math
import pathlib
import sys
import tempfile
import unittest

sys.path.append(str(pathlib.Path(__file__).resolve().parents[1]))
from hawser import __main__ as program, table  # noqa: E402


class Tables(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)

    def write(self, text: str) -> str:
        path = pathlib.Path(self.folder.name) / "run.csv"
        path.write_text(text, encoding="utf-8")
        return str(path)

    def test_reads_names_and_units(self):
        t = table.read(self.write("time [s],tow tension [N],mode\n0.5,1e3,2\n1.0,2e3,2\n1.5,,2\n"))
        self.assertEqual(t.step, 0.5)
        self.assertEqual([(c.name, c.unit) for c in t.columns], [("tow tension", "N"), ("mode", "")])
        self.assertEqual(t["tow tension"].values[1], 2e3)
        self.assertTrue(math.isnan(t["tow tension"].values[2]))
        self.assertEqual(t.after(1.0).time.size, 2)
        with self.assertRaises(KeyError):
            t["tension"]

    def test_refuses_with_file_and_line(self):
        for text, said in (("a,b\n1,2\n", "first column"), ("time [s],a\n1\n2,3\n", ":2: 1 values"),
                           ("time [s],a\n1,2\n2,x\n", ":3: could not"), ("time [s],a\n1,2\n", "two rows"),
                           ("", "first column")):
            with self.assertRaisesRegex(ValueError, said):
                table.read(self.write(text))

    def test_program(self):
        rows = "".join(f"{0.1 * i},{5.0 + math.sin(0.1 * i)},1\n" for i in range(2000))
        out = io.StringIO()
        with contextlib.redirect_stdout(out):
            self.assertEqual(program.main([self.write("time [s],heave [m],mode\n" + rows)]), 0)
        heave = next(x for x in out.getvalue().splitlines() if x.startswith("heave [m]")).split()
        self.assertAlmostEqual(float(heave[2]), 5.0, delta=0.01)
        self.assertAlmostEqual(float(heave[6]), 2.0 * math.pi, delta=0.01)
        self.assertAlmostEqual(float(heave[7]), 6.0, delta=0.01)  # a sine has no larger peaks
        with contextlib.redirect_stderr(io.StringIO()) as said:
            self.assertEqual(program.main([self.write("nothing\n")]), 1)
        self.assertIn("first column", said.getvalue())


if __name__ == "__main__":
    unittest.main()
