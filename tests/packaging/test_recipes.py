# SPDX-FileCopyrightText: The libhgrid developers
# SPDX-License-Identifier: BSD-3-Clause
"""Recipes of packagers: each is read by its format's own rules, and asks the project for options that it has."""

import os
import pathlib
import re
import sys
import types
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
PACKAGING = ROOT / "packaging"

try:
    import tomllib
except ImportError:  # Python before 3.11
    tomllib = None
try:
    import yaml
except ImportError:
    yaml = None


def cmake_options():
    """Every name that a builder may set, as the CMake files declare it."""
    declared = re.compile(r"^ *(?:(?:hgrid_)?option\((HGRID_\w+) |set\((HGRID_\w+)\s[^()]*\bCACHE\b)", re.MULTILINE)
    paths = [ROOT / "CMakeLists.txt", *ROOT.glob("cmake/*.cmake"), *ROOT.glob("bindings/*/CMakeLists.txt")]
    texts = [path.read_text(encoding="utf-8") for path in paths]
    names = {name for text in texts for match in declared.findall(text) for name in match if name}
    return names


@unittest.skipIf(tomllib is None, "no tomllib before Python 3.11")
class Toml(unittest.TestCase):
    def test_pyproject_says_what_cmake_installs(self):
        project = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]
        metadata = (ROOT / "bindings/swig/METADATA.in").read_text(encoding="utf-8")
        told = dict(line.split(": ", 1) for line in metadata.splitlines())
        self.assertEqual(told["Name"], project["name"])
        self.assertEqual(told["Summary"], project["description"])
        self.assertEqual(told["License"], project["license"]["text"])
        self.assertEqual(told["Requires-Python"], project["requires-python"])
        self.assertEqual([told["Requires-Dist"]], project["dependencies"])

    def test_fpm_finds_every_module(self):
        manifest = tomllib.loads((ROOT / "fpm.toml").read_text(encoding="utf-8"))
        sources = ROOT / manifest["library"]["source-dir"]
        listed = re.findall(r"^ +(\w+\.f90)", (sources / "sources.cmake").read_text(encoding="utf-8"), re.MULTILINE)
        self.assertGreater(len(listed), 5)
        self.assertEqual([name for name in listed if not (sources / name).is_file()], [])
        self.assertEqual(manifest["build"]["link"], "hgrid")


@unittest.skipIf(yaml is None, "PyYAML is not installed")
class Yaml(unittest.TestCase):
    def test_conda(self):
        recipe = yaml.safe_load((PACKAGING / "conda/recipe.yaml").read_text(encoding="utf-8"))
        self.assertEqual(recipe["schema_version"], 1)
        self.assertTrue((PACKAGING / "conda" / recipe["source"]["path"] / "CMakeLists.txt").is_file())
        self.assertEqual([each["package"]["name"] for each in recipe["outputs"]], ["libhgrid", "hgrid"])
        for output in recipe["outputs"]:
            self.assertTrue(all(isinstance(line, str) for line in output["build"]["script"]))
            self.assertIn("build", output["requirements"])
            self.assertTrue(output["tests"])

    def test_citation(self):
        citation = yaml.safe_load((ROOT / "CITATION.cff").read_text(encoding="utf-8"))
        for key in ("cff-version", "message", "title", "authors", "version", "preferred-citation"):
            self.assertIn(key, citation)


class Spack(unittest.TestCase):
    """The recipe runs in a stand-in for Spack that notes what it says."""

    def load(self, chosen):
        said = {"version": [], "variant": [], "depends_on": []}

        def note(kind):
            return lambda name, **_: said[kind].append(name)

        class Spec(dict):
            def satisfies(self, what):
                return chosen[what[1:]]

        class CMakePackage:
            spec = Spec(python=types.SimpleNamespace(command=types.SimpleNamespace(path="/usr/bin/python3")))

            def define(self, name, value):
                return f"-D{name}={value}"

            def define_from_variant(self, name, variant):
                return f"-D{name}={chosen[variant]}"

        class When:
            def __init__(self, _):
                pass

            def __enter__(self):
                return self

            def __exit__(self, *_):
                return False

        module = types.ModuleType("spack.package")
        vars(module).update(CMakePackage=CMakePackage, when=When, license=lambda _: None, extends=note("depends_on"))
        vars(module).update(python_platlib="/prefix/lib", **{kind: note(kind) for kind in said})
        sys.modules.update({"spack": types.ModuleType("spack"), "spack.package": module})
        scope = {}
        exec(compile((PACKAGING / "spack/package.py").read_text(encoding="utf-8"), "package.py", "exec"), scope)
        return said, scope["Libhgrid"]().cmake_args()

    def test_variants_reach_cmake(self):
        names = ("shared", "fortran", "f77", "python", "mpi", "tools")
        off, without = self.load(dict.fromkeys(names, False))
        on, args = self.load(dict.fromkeys(names, True))
        self.assertEqual(sorted(on["variant"]), sorted(names))
        self.assertEqual(off, on)
        self.assertEqual(len(on["version"]), 1)
        self.assertIn("-DHGRID_BUILD_PYTHON=True", args)
        self.assertIn("-DHGRID_BUILD_PYTHON=False", without)
        self.assertIn("-DPython3_EXECUTABLE=/usr/bin/python3", args)


class Options(unittest.TestCase):
    def test_every_option_that_is_set_exists(self):
        known = cmake_options()
        self.assertIn("HGRID_BUILD_FORTRAN", known)
        self.assertIn("HGRID_PYTHON_INSTALL_DIR", known)
        recipes = ["debian/rules", "conda/recipe.yaml", "nix/package.nix", "spack/package.py", "../pyproject.toml"]
        for name in recipes:
            asked = set(re.findall(r"(?:\b|(?<=-D))HGRID_[A-Z0-9_]+", (PACKAGING / name).read_text("utf-8")))
            self.assertTrue(asked, name)
            self.assertEqual(asked - known, set(), name)


class Debian(unittest.TestCase):
    def test_every_test_is_there_and_can_be_run(self):
        control = (PACKAGING / "debian/tests/control").read_text(encoding="utf-8")
        named = re.findall(r"^Tests: (\S+)$", control, re.MULTILINE)
        self.assertTrue(named)
        for name in named:
            self.assertTrue(os.access(PACKAGING / "debian/tests" / name, os.X_OK), name)

    def test_every_file_belongs_to_a_package(self):
        control = (PACKAGING / "debian/control").read_text(encoding="utf-8")
        packages = set(re.findall(r"^Package: (\S+)$", control, re.MULTILINE))
        for path in (PACKAGING / "debian").iterdir():
            if path.suffix in (".install", ".symbols", ".docs", ".examples"):
                self.assertIn(path.stem, packages)


if __name__ == "__main__":
    unittest.main()
