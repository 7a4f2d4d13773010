% SPDX-FileCopyrightText: The libhgrid developers
% SPDX-License-Identifier: BSD-3-Clause
% Finds the contacts among spheres whose radii differ by a factor of a hundred, in Octave.
hgrid;

rand("twister", 1);
x = rand(10000, 3);                    % centres in the unit cube
r = 0.001 ./ (1 - 0.99 * rand(10000, 1)); % radii from 0.001 to 0.1

grid = hgrid.Grid(struct("periodic", [1 1 0], "box_min", [0 0 0], "box_max", [1 1 1]));
grid.insert(x, r);
contacts = grid.query_pairs();         % m x 2
printf("%d contacts on %d levels\n", rows(contacts), numel(grid.levels()));
