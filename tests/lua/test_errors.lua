-- SPDX-FileCopyrightText: The libhgrid developers
-- SPDX-License-Identifier: BSD-3-Clause
-- Failures are errors of Lua with the text of the library and the line of the script; they change nothing.
local hgrid = require("hgrid")

local function refused(text, call, ...)
  local done, message = pcall(call, ...)
  assert(not done, "not refused: " .. text)
  assert(type(message) == "string" and message:find(text, 1, true), "'" .. tostring(message) .. "' is not '" .. text .. "'")
  return message
end

local grid = hgrid.Grid()
grid:insert({{0, 0, 0}, {1, 0, 0}}, {0.6, 0.6})

-- The library's own.
local message = refused("radii[1] = -1 is negative", function() grid:insert({{0, 0, 0}, {1, 0, 0}}, {1, -1}) end)
assert(message:find("test_errors.lua:", 1, true), "the error names the line")
refused("is not finite", grid.insert, grid, {{0, 0 / 0, 0}}, {1})
refused("7", grid.remove, grid, {7})
refused("def.dimension = 4 is not in [2, 3]", hgrid.Grid, {dimension = 4})
refused("box", hgrid.Grid, {periodic = {true, true, true}})

-- Shapes and types.
refused("centers must have 3 numbers in each row, not 2", grid.insert, grid, {{0, 0}}, {1})
refused("radii must hold 1 numbers, not 2", grid.insert, grid, {{0, 0, 0}}, {1, 2})
refused("centers[2] is no list of as many numbers as centers[1]", grid.insert, grid, {{0, 0, 0}, {1, 0}}, {1, 1})
refused("centers[2] is no list", grid.insert, grid, {{0, 0, 0}, 4}, {1, 1})
refused("centers[1][2] is no number", grid.insert, grid, {{0, "1", 0}}, {1})
refused("centers[1][1] is an integer that no double holds", grid.insert, grid, {{(1 << 53) + 1, 0, 0}}, {1})
refused("centers[1][1] is an integer that no double holds", grid.insert, grid, {{math.maxinteger, 0, 0}}, {1})
refused("ids[1] is no integer", grid.remove, grid, {0.5})
refused("ids[0] = 4294967296 does not fit in 32 bits", grid.remove, grid, {1 << 32})
refused("groups must be a list of numbers, not 2 rows of 2", function() grid:set_groups({{0, 1}, {0, 1}}) end)
refused("radius is table", grid.query_sphere, grid, {0, 0, 0}, {})
refused("center must hold 3 numbers, not 2", grid.query_sphere, grid, {0, 0}, 1)
refused("high must have 1 rows", grid.query_boxes, grid, {{0, 0, 0}}, {})
refused("corners must have 9 numbers", grid.query_triangles, grid, {{0, 0, 0}})
refused("definition is", hgrid.Grid, 3)
refused("a definition has no member 'perodic'", hgrid.Grid, {perodic = {true}})
refused("periodic must hold 3 numbers, as dimension is not 2", hgrid.Grid, {periodic = {true, true}, box_max = {1, 1, 1}})
refused("margin must hold 1 numbers", hgrid.Grid, {margin = {1, 2}})
refused("touching is 0.5, not an integer", hgrid.Grid, {touching = 0.5})
refused("function expected", grid.visit_pairs, grid, 3)
refused("", grid.query_pairs, nil)
refused("", grid.query_pairs, {})
refused("", grid.query_pairs)
assert(#grid:query_pairs() == 1, "what is refused changes nothing")

-- Levels of the user.
assert(#hgrid.Grid{cell_sizes = {1, 2, 4}}:levels() == 3)
refused("cell_sizes", hgrid.Grid, {cell_sizes = {2, 1}})
refused("the last of cell_sizes", function() hgrid.Grid{cell_sizes = {1}}:insert({{0, 0, 0}}, {3}) end)

-- Errors of visitors pass through, of any type; the grid itself refuses calls meanwhile.
local thrown = {}
local done, caught = pcall(grid.visit_pairs, grid, function() error(thrown) end)
assert(not done and caught == thrown)
local calls = 0
grid:visit_contacts(function()
  calls = calls + 1
  refused("visit", grid.query_pairs, grid)
  refused("a grid cannot be closed by a visitor of its own", grid.close, grid)
end)
assert(calls == 1 and #grid:query_pairs() == 1)

grid:close()
grid:close()
refused("the grid is closed", grid.query_pairs, grid)
refused("the grid is closed", grid.insert, grid, {}, {})
refused("the grid is closed", grid.stats, grid)
