% SPDX-FileCopyrightText: The libhgrid developers
% SPDX-License-Identifier: BSD-3-Clause
% Failures are errors of Octave with the text of the library and its status as identifier; they change nothing.
1;
function refused(status, text, call)
  try
    call();
  catch caught
    assert(caught.identifier, ["hgrid:HG_ERR_" status]);
    assert(! isempty(strfind(caught.message, text)), [caught.message " is not " text]);
    return
  end
  error("not refused: %s", text);
end
function fail(grid, list)
  refused("STATE", "visit", @() grid.query_pairs());
  refused("STATE", "a grid cannot be closed by a visitor of its own", @() grid.close());
  error("mine:own", "from the visitor");
end
hgrid;

grid = hgrid.Grid();
grid.insert([0 0 0; 1 0 0], [0.6 0.6]);

% The library's own.
refused("ARGUMENT", "radii[1] = -1 is negative", @() grid.insert([0 0 0; 1 0 0], [1 -1]));
refused("ARGUMENT", "is not finite", @() grid.insert([0 NaN 0], 1));
refused("NOT_FOUND", "7", @() grid.remove(7));
refused("ARGUMENT", "def.dimension = 4 is not in [2, 3]", @() hgrid.Grid(struct("dimension", 4)));

% Shapes and types.
refused("ARGUMENT", "centers must have 3 numbers in each row, not 2", @() grid.insert([0 0], 1));
refused("ARGUMENT", "radii must hold 1 numbers, not 2", @() grid.insert([0 0 0], [1 2]));
refused("ARGUMENT", "centers is a cell, not a real matrix", @() grid.insert({0, 0, 0}, 1));
refused("ARGUMENT", "centers is a double, not a real matrix", @() grid.insert([0 0 1i], 1));
refused("ARGUMENT", "centers has 3 dimensions", @() grid.insert(zeros(1, 3, 2), 1));
refused("ARGUMENT", "centers holds 9223372036854775805, an integer that no double holds", ...
        @() grid.insert([intmax("int64") - int64(2), int64([0 0])], 1));
refused("ARGUMENT", "an integer that no double holds", @() grid.insert(intmax("uint64") * [1 1 1], 1));
refused("ARGUMENT", "ids holds 0.5, which is no integer", @() grid.remove(0.5));
refused("ARGUMENT", "ids[0] = 4294967296 does not fit in 32 bits", @() grid.remove(2^32));
refused("ARGUMENT", "radius must be one number", @() grid.query_sphere([0 0 0], [1 2]));
refused("ARGUMENT", "a definition is a struct", @() hgrid.Grid(3));
refused("ARGUMENT", "a definition has no member 'perodic'", @() hgrid.Grid(struct("perodic", 1)));
refused("ARGUMENT", "periodic must hold 3 numbers, as dimension is not 2", ...
        @() hgrid.Grid(struct("periodic", [1 1], "box_max", [1 1 1])));
refused("ARGUMENT", "cell_sizes", @() hgrid.Grid(struct("cell_sizes", [2 1])));
assert(numel(hgrid.Grid(struct("cell_sizes", [1 2 4])).levels()), 3);
assert(grid.query_pairs(), [1 2]);

% Errors of visitors pass through.
try
  grid.visit_pairs(@(list) fail(grid, list));
  error("the visitor did not fail");
catch caught
  assert(caught.identifier, "mine:own");
end
assert(grid.query_pairs(), [1 2]);

grid.close();
refused("STATE", "the grid is closed", @() grid.query_pairs());
