-- SPDX-FileCopyrightText: The libhgrid developers
-- SPDX-License-Identifier: BSD-3-Clause
-- Random spheres on a lattice of 2^-20, and every pair of them by brute force in integers.
local oracle = {}

oracle.UNIT = 2 ^ -20

-- Particles with integer coordinates below `edge` and radii up to `largest`, and the same as the library takes them.
function oracle.scene(seed, count, dimension, edge, largest)
  math.randomseed(seed)
  local whole = {x = {}, r = {}}
  local x, r = {}, {}
  for k = 1, count do
    whole.x[k], x[k] = {}, {}
    for axis = 1, dimension do
      whole.x[k][axis] = math.random(0, edge - 1)
      x[k][axis] = whole.x[k][axis] * oracle.UNIT
    end
    whole.r[k] = math.floor(largest * 100 ^ -math.random())
    r[k] = whole.r[k] * oracle.UNIT
  end
  return whole, x, r
end

-- The squared distance, to the nearest image on axes that have a period (shorter ones than `period` / 2 alone meet).
local function square(a, b, period)
  local sum = 0
  for axis = 1, #a do
    local gap = math.abs(a[axis] - b[axis])
    if period and period[axis] then gap = math.min(gap, period[axis] - gap) end
    sum = sum + gap * gap
  end
  return sum
end

-- Whether two spheres overlap; `touching` counts those that touch.
function oracle.meets(xa, ra, xb, rb, options)
  local reach = ra + rb + (options.margin or 0)
  local distance = square(xa, xb, options.period)
  return distance < reach * reach or (options.touching == true and distance == reach * reach)
end

-- All pairs as a set of "a b", ids from `base`.
function oracle.pairs(whole, options)
  options = options or {}
  local base = options.base or 1
  local found, count = {}, 0
  for a = 1, #whole.r do
    for b = a + 1, #whole.r do
      if oracle.meets(whole.x[a], whole.r[a], whole.x[b], whole.r[b], options) then
        found[(a - 1 + base) .. " " .. (b - 1 + base)] = true
        count = count + 1
      end
    end
  end
  return found, count
end

-- Fails unless the list holds each pair of the set once and no other.
function oracle.check(list, set, count, what)
  assert(count > 0, what .. ": a scene without pairs tests nothing")
  local seen = {}
  for _, pair in ipairs(list) do
    local name = pair[1] .. " " .. pair[2]
    assert(set[name], what .. ": " .. name .. " is no pair")
    assert(not seen[name], what .. ": " .. name .. " stands twice")
    seen[name] = true
  end
  assert(#list == count, what .. ": " .. #list .. " pairs instead of " .. count)
end

return oracle
