% SPDX-FileCopyrightText: The libhgrid developers
% SPDX-License-Identifier: BSD-3-Clause
% All pairs of spheres, ascending, ids from 1. period: of each axis, Inf where it is open.
function list = brute_force(x, r, margin, period, touching)
  [a, b] = find(triu(true(rows(x)), 1));
  gap = abs(x(a, :) - x(b, :));
  if ! isempty(period)
    gap = min(gap, period - gap);
  end
  distance = sum(gap .^ 2, 2);
  reach = (r(a) + r(b) + margin) .^ 2;
  met = distance < reach | (touching & distance == reach);
  list = sortrows([a(met), b(met)]);
  assert(rows(list) > 0, "a scene without pairs tests nothing");
end
