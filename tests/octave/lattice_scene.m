% SPDX-FileCopyrightText: The libhgrid developers
% SPDX-License-Identifier: BSD-3-Clause
% Random spheres whose coordinates and radii are multiples of 2^-20, so that brute force in doubles is exact.
function [x, r] = lattice_scene(seed, count, dimension, edge, largest)
  rand("twister", seed);
  x = floor(edge * 2^20 * rand(count, dimension)) / 2^20;
  r = floor(largest * 2^20 * 100 .^ -rand(count, 1)) / 2^20;
end
