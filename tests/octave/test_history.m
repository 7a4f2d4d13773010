% SPDX-FileCopyrightText: The libhgrid developers
% SPDX-License-Identifier: BSD-3-Clause
% Data of contacts follow them from list to list; places count from 1, 0 is that of a new contact.
hgrid;
history = hgrid.History();
assert(history.update([1 2; 2 3]), [0; 0]);
assert(history.update([2 3; 3 4; 1 2]), [2; 0; 1]);
assert(history.carry([0.5; 0.25]), [0.25; 0; 0.5]);
assert(history.carry([1 2; 3 4]), [3 4; 0 0; 1 2]);
assert(history.contacts(), [2 3; 3 4; 1 2]);
assert(history.update([1 2]), 3);
[contacts, places] = history.ended();
assert(contacts, [2 3; 3 4]);
assert(places, [1; 2]);

% Sub-keys beyond what doubles hold come back as 64-bit integers.
keys = [int64([1 2 0]); int64([1 2 0]) + [int64(0) int64(0) intmax("int64")]];
assert(history.update(keys), [1; 0]);
assert(history.contacts(), keys);
history.restore([5 6]);
assert(history.update([5 6; 7 8]), [1; 0]);
history.clear();
assert(history.update([5 6]), 0);

% Grids that nobody holds any more are freed: each of these has 40 MB.
x = rand(400000, 3);
r = 0.001 * ones(400000, 1);
resident = @() str2double(regexp(fileread("/proc/self/status"), 'VmRSS:\s*(\d+)', "tokens"){1}{1});
for round = 1:12
  grid = hgrid.Grid();
  grid.insert(x, r);
  if round == 2 && exist("/proc/self/status", "file")
    before = resident();
  end
end
if exist("before", "var")
  assert(resident() < before + 200000);
end
