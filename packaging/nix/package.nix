# SPDX-FileCopyrightText: The libhgrid developers
# SPDX-License-Identifier: BSD-3-Clause
# nix-build -E '(import <nixpkgs> { }).callPackage packaging/nix/package.nix { }'
{
  lib,
  stdenv,
  cmake,
  ninja,
  pkg-config,
  gfortran,
  cli11,
  eigen,
  gmp,
  pugixml,
  tomlplusplus,
  zlib,
  mpi,
  withTools ? true,
  withMpi ? false,
}:

let
  project = builtins.readFile ../../CMakeLists.txt;
  onOff = wanted: if wanted then "ON" else "OFF";
in
stdenv.mkDerivation {
  pname = "libhgrid";
  version = builtins.head (builtins.match ".*project\\(hgrid VERSION ([0-9.]+) .*" project);

  src = lib.cleanSource ../..;
  outputs = [
    "out"
    "dev"
  ];

  nativeBuildInputs = [
    cmake
    gfortran
    ninja
    pkg-config
  ];
  buildInputs = lib.optionals withTools [
    cli11
    eigen
    gmp
    pugixml
    tomlplusplus
    zlib
  ];
  propagatedBuildInputs = lib.optional withMpi mpi;

  cmakeFlags = [
    "-DHGRID_BUILD_FORTRAN=ON"
    "-DHGRID_BUILD_PYTHON=OFF"
    "-DHGRID_BUILD_BENCH=OFF"
    "-DHGRID_BUILD_TESTS=OFF"
    "-DHGRID_BUILD_APP=${onOff withTools}"
    "-DHGRID_BUILD_MPI=${onOff withMpi}"
  ];

  meta = {
    description = "Contact search for particles of very different sizes";
    license = lib.licenses.bsd3;
    platforms = lib.platforms.unix;
  };
}
