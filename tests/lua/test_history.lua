-- SPDX-FileCopyrightText: The libhgrid developers
-- SPDX-License-Identifier: BSD-3-Clause
-- Data of contacts follow them from list to list; places count from 1, 0 is that of a new contact.
local hgrid = require("hgrid")

local function same(found, wanted)
  assert(#found == #wanted)
  for k = 1, #wanted do
    if type(wanted[k]) == "table" then same(found[k], wanted[k]) else assert(found[k] == wanted[k]) end
  end
end

local history = hgrid.History()
assert(not pcall(history.carry, history, {}), "nothing was matched yet")
same(history:update({{1, 2}, {2, 3}}), {0, 0})
same(history:update({{2, 3}, {3, 4}, {1, 2}}), {2, 0, 1})
same(history:carry({0.5, 0.25}), {0.25, 0, 0.5})
same(history:carry({{1, 2}, {3, 4}}), {{3, 4}, {0, 0}, {1, 2}})
same(history:contacts(), {{2, 3}, {3, 4}, {1, 2}})
local contacts, places = history:ended()
same(contacts, {})
same(history:update({{1, 2}}), {3})
contacts, places = history:ended()
same(contacts, {{2, 3}, {3, 4}})
same(places, {1, 2})

-- Sub-keys of any size tell contacts of the same two apart.
local far = math.maxinteger
same(history:update({{1, 2, 0}, {1, 2, far}}), {1, 0})
same(history:contacts(), {{1, 2, 0}, {1, 2, far}})
local done, message = pcall(history.update, history, {{1, 2, 5}, {1, 2, 5}})
assert(not done and message:find("keys[1] = (1, 2, 5) is already listed as keys[0]", 1, true), message)
done, message = pcall(history.update, history, {{1, 2, 5, 6}})
assert(not done and message:find("2 or 3 numbers", 1, true), message)
done, message = pcall(history.carry, history, {1, 2, 3})
assert(not done and message:find("items must have 1 rows", 1, true), message)

history:restore({{5, 6}})
same(history:update({{5, 6}, {7, 8}}), {1, 0})
history:clear()
same(history:update({{5, 6}}), {0})
