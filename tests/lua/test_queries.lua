-- SPDX-FileCopyrightText: The libhgrid developers
-- SPDX-License-Identifier: BSD-3-Clause
-- All other queries, against the pairs or against brute force.
local hgrid = require("hgrid")
local oracle = require("oracle")

local EDGE = 2 ^ 20 // 1 | 0
local whole, x, r = oracle.scene(4, 220, 3, EDGE, 2 ^ 17 // 1 | 0)
local grid = hgrid.Grid()
grid:insert(x, r)
local list = grid:query_pairs()
assert(#list > 0)

local function sorted(values)
  table.sort(values)
  return table.concat(values, " ")
end

-- Neighbours: half and full lists hold the pairs.
local half, full = {}, {}
for k = 1, #r do half[k], full[k] = {}, {} end
for _, pair in ipairs(list) do
  table.insert(half[pair[1]], pair[2])
  table.insert(full[pair[1]], pair[2])
  table.insert(full[pair[2]], pair[1])
end
for k, row in ipairs(grid:query_neighbors()) do assert(table.concat(row, " ") == sorted(half[k])) end
for k, row in ipairs(grid:query_neighbors(hgrid.HG_FULL)) do assert(table.concat(row, " ") == sorted(full[k])) end
assert(#grid:query_neighbors(hgrid.HG_FULL) == #r)

-- Vectors lead from a to b.
local vectors, shifts = grid:query_pair_vectors()
assert(#vectors == #list and #shifts == #list)
for k, pair in ipairs(list) do
  for axis = 1, 3 do
    assert(vectors[k][axis] == x[pair[2]][axis] - x[pair[1]][axis])
    assert(shifts[k][axis] == 0)
  end
end

-- Spheres, one and many, and verdicts.
local probes, probe_x, probe_r = oracle.scene(5, 20, 3, EDGE, 2 ^ 17 // 1 | 0)
local rows = grid:query_spheres(probe_x, probe_r)
local hits = 0
for k = 1, #probe_r do
  local wanted = {}
  for id = 1, #r do
    local meets = oracle.meets(probes.x[k], probes.r[k], whole.x[id], whole.r[id], {})
    assert(grid:overlap(probe_x[k], probe_r[k], x[id], r[id]) == meets)
    if meets then wanted[#wanted + 1] = id end
  end
  assert(table.concat(rows[k], " ") == table.concat(wanted, " "))
  assert(table.concat(grid:query_sphere(probe_x[k], probe_r[k]), " ") == table.concat(wanted, " "))
  hits = hits + #wanted
end
assert(hits > 0)

-- Boxes and triangles that hold all, or a far place.
rows = grid:query_boxes({{0, 0, 0}, {9, 9, 9}}, {{1, 1, 1}, {10, 10, 10}})
assert(#rows == 2 and #rows[1] == #r and #rows[2] == 0)
rows = grid:query_triangles({{x[7][1], x[7][2], x[7][3], 9, 9, 9, 9, 9, 8}})
local found = false
for _, id in ipairs(rows[1]) do found = found or id == 7 end
assert(found, "a triangle meets the sphere at its corner")

-- Visits: batches hold the pairs; a true answer ends them.
local visited = {}
grid:visit_pairs(function(batch)
  for _, pair in ipairs(batch) do visited[#visited + 1] = pair[1] .. " " .. pair[2] end
end)
assert(#visited == #list)
for k, pair in ipairs(list) do assert(visited[k] == pair[1] .. " " .. pair[2]) end

local place = 0
grid:visit_contacts(function(batch, steps, reach)
  for k, pair in ipairs(batch) do
    place = place + 1
    assert(pair[1] == list[place][1] and pair[2] == list[place][2])
    for axis = 1, 3 do assert(steps[k][axis] == vectors[place][axis]) end
    assert(reach[k] == r[pair[1]] + r[pair[2]])
  end
end)
assert(place == #list)
local calls = 0
grid:visit_contacts(function()
  calls = calls + 1
  return true
end)
assert(calls == 1)

-- What the grid tells of itself.
local order = grid:order()
assert(#order == #r and sorted(order):find("^1 2 3 "))
local levels, particles = grid:levels(), 0
for _, level in ipairs(levels) do particles = particles + level.particle_count end
assert(particles == #r and levels[1].cell_size > 0)
assert(#grid:level_costs() > 0 and grid:level_costs()[1].level_count == 1)
assert(grid:stats().pair_count == #list)
grid:build()
assert(hgrid.version():match("^%d+%.%d+%.%d+$"))
