% SPDX-FileCopyrightText: The libhgrid developers
% SPDX-License-Identifier: BSD-3-Clause
% Pairs against brute force, through all changes of the particles and all kinds of boxes.
hgrid;
[x, r] = lattice_scene(1, 250, 3, 1, 0.125);

grid = hgrid.Grid();
grid.insert(x, r);
wanted = brute_force(x, r, 0, [], false);
list = grid.query_pairs();
assert(class(list), "double");
assert(sortrows(list), wanted);
grid = hgrid.Grid(struct("index_base", 0));
grid.set(x, r.'); % lists may lie or stand
assert(sortrows(grid.query_pairs()), wanted - 1);

% Changes: new places, new radii, less and more particles.
[y, s] = lattice_scene(2, 250, 3, 1, 0.125);
grid = hgrid.Grid(struct("pair_order", hgrid.HG_ORDER_ID, "thread_count", 1));
grid.insert(x, r);
grid.move(y);
assert(grid.query_pairs(), brute_force(y, r, 0, [], false));
grid.move(y, s);
assert(grid.query_pairs(), brute_force(y, s, 0, [], false));
grid.remove([1 3 5]);
assert(grid.stats().particle_count, 247);
assert(! any(ismember(grid.query_pairs()(:), [1 3 5])));
grid.clear();
assert(grid.query_pairs(), zeros(0, 2));
grid.insert(zeros(0, 3), []);
grid.insert(y, s);
assert(grid.query_pairs(), brute_force(y, s, 0, [], false));

% Periodic axes, a margin, spheres that touch, two dimensions, integers and single precision.
definition = struct("periodic", [1 0 1], "box_min", [0 0 0], "box_max", [1 1 1], "margin", 2^-6);
grid = hgrid.Grid(definition);
grid.insert(x, r);
assert(sortrows(grid.query_pairs()), brute_force(x, r, 2^-6, [1 Inf 1], false));
[x, r] = lattice_scene(3, 300, 2, 64, 4);
x = floor(x);
r = floor(r) + 1;
for touching = [false true]
  definition = struct("dimension", 2, "touching", touching, "periodic", true(1, 2), "box_min", [0 0], "box_max", [64 64]);
  grid = hgrid.Grid(definition);
  grid.insert(int32(x), single(r));
  assert(sortrows(grid.query_pairs()), brute_force(x, r, 0, [64 64], touching));
end

% A box that changes: images above a sheared square slide to the right.
grid = hgrid.Grid(struct("dimension", 2, "periodic", [1 1], "box_min", [0 0], "box_max", [1 1]));
grid.insert([0.2 0.1; 0.7 0.9], [0.12 0.12]);
contacts = zeros(1, 3);
for step = 1:3
  grid.set_box([0 0], [1 1], (step - 1) / 4);
  contacts(step) = rows(grid.query_pairs());
end
assert(contacts, [0 0 1]);

% Groups and bodies.
grid = hgrid.Grid();
grid.insert([0 0 0; 1 0 0; 2 0 0], [0.6 0.6 0.6]);
grid.set_groups([0 1 1]);
grid.set_group_pair(1, 1, false);
assert(grid.query_pairs(), [1 2]);
grid.set_group_pair(1, 1, true);
grid.set_bodies([4 4 -1]);
assert(grid.query_pairs(), [2 3]);
grid.set_bodies();
grid.set_groups([-1 -1 -1]);
assert(grid.query_pairs(), zeros(0, 2));
grid.set_groups([]);
assert(sortrows(grid.query_pairs()), [1 2; 2 3]);
