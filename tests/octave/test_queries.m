% SPDX-FileCopyrightText: The libhgrid developers
% SPDX-License-Identifier: BSD-3-Clause
% All other queries, against the pairs or against brute force.
1;
function done = count_batch(list, vectors, reach)
  global seen
  seen(end + 1, :) = [rows(list), rows(vectors), rows(reach)];
  done = false;
end
function done = stop_at_once(list)
  global seen
  seen(end + 1, :) = [rows(list), 0, 0];
  done = true;
end
function take_batch(list)
  global seen
  seen = [seen; list];
end
global seen

hgrid;
[x, r] = lattice_scene(4, 220, 3, 1, 0.125);
grid = hgrid.Grid();
grid.insert(x, r);
list = grid.query_pairs();
assert(rows(list) > 0);

% Neighbours in compressed rows, whose starts count from 1.
[offsets, ids] = grid.query_neighbors(hgrid.HG_FULL);
both = sortrows([list; fliplr(list)]);
assert(ids, both(:, 2));
assert(offsets, [1; 1 + cumsum(accumarray(both(:, 1), 1, [220, 1]))]);
[offsets, ids] = grid.query_neighbors();
assert(ids, sortrows(list)(:, 2));

% Vectors lead from a to b.
[vectors, shifts] = grid.query_pair_vectors();
assert(vectors, x(list(:, 2), :) - x(list(:, 1), :));
assert(shifts, zeros(rows(list), 3));

% Spheres, one and many, and verdicts.
[y, s] = lattice_scene(5, 20, 3, 1, 0.125);
[offsets, ids] = grid.query_spheres(y, s);
for k = 1:20
  met = find(sum((x - y(k, :)) .^ 2, 2) < (r + s(k)) .^ 2);
  assert(ids(offsets(k):offsets(k + 1) - 1), met(:));
  assert(grid.query_sphere(y(k, :), s(k)), met(:));
  for id = [1 50 met.']
    assert(grid.overlap(y(k, :), s(k), x(id, :).', r(id)), any(met == id));
  end
end
assert(numel(ids) > 0);

% Boxes and triangles that hold all, or a far place.
[offsets, ids] = grid.query_boxes([0 0 0; 9 9 9], [1 1 1; Inf Inf Inf]);
assert(offsets, [1; 221; 221]);
assert(ids, (1:220).');
[offsets, ids] = grid.query_triangles([x(7, :), 9 9 9, 9 9 8]);
assert(any(ids == 7));

% Visits.
seen = zeros(0, 2);
grid.visit_pairs(@take_batch);
assert(seen, list);
seen = zeros(0, 3);
grid.visit_contacts(@count_batch);
assert(sum(seen, 1), rows(list) * [1 1 1]);
seen = zeros(0, 3);
grid.visit_pairs(@stop_at_once);
assert(rows(seen), 1);

% What the grid tells of itself.
assert(sort(grid.order()), (1:220).');
levels = grid.levels();
assert(sum([levels.particle_count]), 220);
assert(levels(1).cell_size > 0);
assert(grid.level_costs()(1).level_count, 1);
assert(grid.stats().pair_count, rows(list));
grid.build();
assert(regexp(hgrid.version(), '^\d+\.\d+\.\d+$'), 1);
