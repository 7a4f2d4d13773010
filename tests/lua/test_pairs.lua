-- SPDX-FileCopyrightText: The libhgrid developers
-- SPDX-License-Identifier: BSD-3-Clause
-- Pairs against brute force, through all changes of the particles and all kinds of boxes.
local hgrid = require("hgrid")
local oracle = require("oracle")

local EDGE, LARGEST = 2 ^ 20 // 1 | 0, 2 ^ 17 // 1 | 0

local whole, x, r = oracle.scene(1, 250, 3, EDGE, LARGEST)
local grid = hgrid.Grid()
grid:insert(x, r)
local set, count = oracle.pairs(whole)
oracle.check(grid:query_pairs(), set, count, "open space")
for _, pair in ipairs(grid:query_pairs()) do
  assert(math.type(pair[1]) == "integer" and pair[1] < pair[2], "ids are integers, a < b")
end

-- Ids count from 1, or from where the definition says.
grid = hgrid.Grid{index_base = 0}
grid:set(x, r)
oracle.check(grid:query_pairs(), oracle.pairs(whole, {base = 0}), count, "ids from 0")

-- Changes: new places, new radii, less and more particles.
local other_whole, other_x, other_r = oracle.scene(2, 250, 3, EDGE, LARGEST)
grid = hgrid.Grid{thread_count = 1, pair_order = hgrid.HG_ORDER_ID}
grid:insert(x, r)
grid:move(other_x)
set, count = oracle.pairs({x = other_whole.x, r = whole.r})
oracle.check(grid:query_pairs(), set, count, "moved")
grid:move(other_x, other_r)
set, count = oracle.pairs(other_whole)
oracle.check(grid:query_pairs(), set, count, "moved and grown")
local former
for _, pair in ipairs(grid:query_pairs()) do
  assert(not former or former[1] < pair[1] or (former[1] == pair[1] and former[2] < pair[2]), "ascending")
  former = pair
end
grid:remove({1, 3, 5})
for _, pair in ipairs(grid:query_pairs()) do
  for _, id in ipairs(pair) do assert(id ~= 1 and id ~= 3 and id ~= 5, "removed ids are gone") end
end
assert(grid:stats().particle_count == 247)
grid:clear()
assert(#grid:query_pairs() == 0)
grid:insert({}, {})
grid:insert(other_x, other_r)
oracle.check(grid:query_pairs(), set, count, "after clear")

-- Periodic axes, a margin, spheres that touch, two dimensions.
grid = hgrid.Grid{periodic = {true, false, true}, box_min = {0, 0, 0}, box_max = {1, 1, 1}, margin = 2 ^ -6}
grid:insert(x, r)
set, count = oracle.pairs(whole, {period = {EDGE, false, EDGE}, margin = 2 ^ 14 // 1 | 0})
oracle.check(grid:query_pairs(), set, count, "periodic with a margin")

local flat, flat_x, flat_r = oracle.scene(3, 300, 2, 64, 4)
for k = 1, #flat_r do
  flat_x[k] = {flat.x[k][1], flat.x[k][2]}
  flat_r[k] = flat.r[k]
end
for _, touching in ipairs{false, true} do
  grid = hgrid.Grid{dimension = 2, touching = touching, periodic = {1, 1}, box_min = {0, 0}, box_max = {64, 64}}
  grid:insert(flat_x, flat_r)
  set, count = oracle.pairs(flat, {period = {64, 64}, touching = touching})
  oracle.check(grid:query_pairs(), set, count, "a lattice, touching: " .. tostring(touching))
end

-- A box that changes: images above a sheared square slide to the right.
grid = hgrid.Grid{dimension = 2, periodic = {true, true}, box_min = {0, 0}, box_max = {1, 1}}
grid:insert({{0.2, 0.1}, {0.7, 0.9}}, {0.12, 0.12})
for step, wanted in ipairs{0, 0, 1} do
  grid:set_box({0, 0}, {1, 1}, (step - 1) / 4)
  assert(#grid:query_pairs() == wanted, "sheared")
end

-- Groups and bodies.
grid = hgrid.Grid()
grid:insert({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, {0.6, 0.6, 0.6})
grid:set_groups({0, 1, 1})
grid:set_group_pair(1, 1, false)
assert(#grid:query_pairs() == 1)
grid:set_group_pair(1, 1, true)
grid:set_bodies({4, 4, -1})
assert(grid:query_pairs()[1][1] == 2)
grid:set_bodies()
grid:set_groups({-1, -1, -1})
assert(#grid:query_pairs() == 0)
grid:set_groups(nil)
assert(#grid:query_pairs() == 2)
