-- SPDX-FileCopyrightText: The libhgrid developers
-- SPDX-License-Identifier: BSD-3-Clause
-- Grids that nobody holds any more are freed, those that failed as well: the memory of the process stays bounded.
local hgrid = require("hgrid")

-- Kilobytes that are resident, as Linux tells; nil elsewhere.
local function resident()
  local file = io.open("/proc/self/status")
  if not file then return nil end
  local text = file:read("a")
  file:close()
  return tonumber(text:match("VmRSS:%s*(%d+) kB"))
end

local x, r = {}, {}
for k = 1, 5000 do
  x[k], r[k] = {k % 17, k % 19, k % 23}, 0.7
end
local ragged = {table.unpack(x)}
ragged[#ragged + 1] = {1, 2}
local function round()
  local grid = hgrid.Grid()
  grid:insert(x, r)
  local count = #grid:query_pairs()
  assert(not pcall(grid.insert, grid, x, {1}))
  for _ = 1, 10 do assert(not pcall(grid.insert, grid, ragged, r)) end
  assert(not pcall(hgrid.Grid, {cell_sizes = {1, 2}, perodic = 1}))
  return count
end

local count = round()
assert(count > 0)
collectgarbage()
local before = resident()
for _ = 1, 60 do
  assert(round() == count)
  collectgarbage()
end
local after = resident()
if before then
  assert(after < before + 20000, "from " .. before .. " kB to " .. after .. " kB")
  print(before, after)
end

-- Results are Lua's own: they outlive their grid.
local grid = hgrid.Grid()
grid:insert(x, r)
local list = grid:query_pairs()
grid = nil
collectgarbage()
assert(#list == count and list[count][1] < list[count][2])
