# SPDX-FileCopyrightText: The libhgrid developers
# SPDX-License-Identifier: BSD-3-Clause
"""Type stubs: the same names and arguments as the package, by mypy's stubtest; a program and a wrong one by mypy."""

import importlib.metadata
import importlib.util
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

import hgrid

HERE = pathlib.Path(__file__).parent
PACKAGE = pathlib.Path(hgrid.__file__).parent


def run(*arguments):
    environment = {**os.environ, **dict.fromkeys(("MYPYPATH", "PYTHONPATH"), str(PACKAGE.parent))}
    with tempfile.TemporaryDirectory() as folder:
        command = [sys.executable, "-m", *map(str, arguments)]
        done = subprocess.run(command, cwd=folder, env=environment, capture_output=True, text=True, check=False)
    return done.returncode, done.stdout + done.stderr


class Package(unittest.TestCase):
    def test_version(self):
        self.assertEqual(importlib.metadata.version("hgrid"), hgrid.__version__)
        self.assertEqual(hgrid.__version__, "{}.{}.{}".format(*hgrid.version()))

    def test_is_marked_as_typed(self):
        self.assertTrue((PACKAGE / "py.typed").is_file())

    def test_everything_public_says_what_it_is(self):
        for name in hgrid.__all__:
            thing = getattr(hgrid, name)
            if isinstance(thing, int):
                continue
            self.assertTrue(thing.__doc__, name)
            if isinstance(thing, type) and not issubclass(thing, (tuple, Exception)):
                for member, value in vars(thing).items():
                    if not member.startswith("_"):
                        self.assertTrue(value.__doc__, f"{name}.{member}")


@unittest.skipIf(importlib.util.find_spec("mypy") is None, "mypy is not installed")
class Stubs(unittest.TestCase):
    def test_fit_the_package(self):
        # The extension module and what stands between have no stubs; users do not see them.
        with tempfile.TemporaryDirectory() as folder:
            allowed, settings = pathlib.Path(folder, "allowed"), pathlib.Path(folder, "mypy.ini")
            inner = ("_hgrid", "capi", "_mpi_capi", "mpi_capi", "arrays", "boxes", "definition")
            allowed.write_text("".join(f"hgrid\\.{name}(\\..*)?\n" for name in inner))
            settings.write_text("[mypy]\n[mypy-hgrid.capi,hgrid.mpi_capi]\nignore_errors = True\n")
            options = ("--allowlist", allowed, "--ignore-unused-allowlist", "--mypy-config-file", settings)
            status, text = run("mypy.stubtest", "hgrid", *options)
        self.assertEqual(status, 0, text)

    def test_a_program_passes(self):
        status, text = run("mypy", "--strict", "--follow-imports=silent", HERE / "typed_program.py")
        self.assertEqual(status, 0, text)

    def test_a_wrong_program_does_not(self):
        program = "import hgrid\ngrid = hgrid.Grid(imagse='all')\ngrid.insert([[0, 0, 0]])\ngrid.stats.pairs\n"
        status, text = run("mypy", "--follow-imports=silent", "-c", program)
        self.assertEqual(status, 1)
        for wrong in ('"imagse"', 'Missing positional argument "r"', 'no attribute "pairs"'):
            self.assertIn(wrong, text)


if __name__ == "__main__":
    unittest.main()
