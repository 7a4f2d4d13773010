# SPDX-FileCopyrightText: The libhgrid developers
# SPDX-License-Identifier: BSD-3-Clause
"""Spack: copy this file to packages/libhgrid of a repository of your own, then, as long as there is no public archive of
releases, `spack develop --path <this tree> libhgrid@<version>` in an environment."""

from spack.package import *


class Libhgrid(CMakePackage):
    """Finds every pair of overlapping spheres or discs among particles of very different sizes, by a hierarchical
    grid; in C, C++, Fortran and Python, with a command that packs and simulates particles."""

    license("BSD-3-Clause")

    version("1.0.0")

    variant("shared", default=True, description="Build a shared library, else a static one")
    variant("fortran", default=True, description="Build the Fortran module")
    variant("f77", default=True, description="Build the calls for FORTRAN 77")
    variant("python", default=False, description="Build the Python package")
    variant("mpi", default=False, description="Build the layer for several ranks of MPI")
    variant("tools", default=True, description="Build the command hgrid")

    depends_on("c", type="build")
    depends_on("cxx", type="build")
    depends_on("fortran", type="build", when="+fortran")
    depends_on("cmake@3.20:", type="build")

    depends_on("mpi", when="+mpi")

    with when("+python"):
        extends("python@3.8:")
        depends_on("swig@4:", type="build")
        depends_on("py-numpy", type=("build", "run"))

    with when("+tools"):
        depends_on("pkgconfig", type="build")
        depends_on("cli11")
        depends_on("eigen")
        depends_on("gmp+cxx")
        depends_on("pugixml")
        depends_on("tomlplusplus")
        depends_on("zlib-api")

    def cmake_args(self):
        define = self.define_from_variant
        args = [
            define("BUILD_SHARED_LIBS", "shared"),
            define("HGRID_BUILD_FORTRAN", "fortran"),
            define("HGRID_BUILD_F77", "f77"),
            define("HGRID_BUILD_PYTHON", "python"),
            define("HGRID_BUILD_MPI", "mpi"),
            define("HGRID_BUILD_APP", "tools"),
            self.define("HGRID_BUILD_BENCH", False),
            self.define("HGRID_BUILD_TESTS", False),
        ]
        if self.spec.satisfies("+python"):
            args.append(self.define("Python3_EXECUTABLE", self.spec["python"].command.path))
            args.append(self.define("HGRID_PYTHON_INSTALL_DIR", python_platlib))
        return args
