-- SPDX-FileCopyrightText: The libhgrid developers
-- SPDX-License-Identifier: BSD-3-Clause
-- Finds the contacts among spheres whose radii differ by a factor of a hundred.
local hgrid = require("hgrid")

math.randomseed(1)
local x, r = {}, {}
for k = 1, 10000 do
  x[k] = {math.random(), math.random(), math.random()} -- centres in the unit cube
  r[k] = 0.001 / (1 - 0.99 * math.random()) -- radii from 0.001 to 0.1
end

local grid = hgrid.Grid{periodic = {true, true, false}, box_min = {0, 0, 0}, box_max = {1, 1, 1}}
grid:insert(x, r)
local contacts = grid:query_pairs() -- a list of {a, b}
print(#contacts .. " contacts on " .. #grid:levels() .. " levels")
