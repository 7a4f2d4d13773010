# SPDX-FileCopyrightText: The libhgrid developers
# SPDX-License-Identifier: BSD-3-Clause
# The version of the package that packaging/nix/package.nix describes, with nothing of what it is built with.
let
  package = import ../../packaging/nix/package.nix;
  nothing = builtins.mapAttrs (_: _: null) (builtins.functionArgs package);
  keepIf = wanted: value: if wanted then value else [ ];
in
(package (
  nothing
  // {
    lib = {
      cleanSource = path: path;
      optional = wanted: value: keepIf wanted [ value ];
      optionals = keepIf;
      licenses.bsd3 = "BSD-3-Clause";
      platforms.unix = [ ];
    };
    stdenv.mkDerivation = described: builtins.deepSeq described described;
    withTools = true;
    withMpi = true;
  }
)).version
