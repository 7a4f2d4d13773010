// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// A user in C++11: the header needs no extern "C" of its own, and a lambda serves as visitor.
#include <hgrid/hgrid.h>

#include <iostream>

int main() {
  const double centers[] = {0, 0, 0, 1, 0, 0, 3, 0, 0};
  const double radii[] = {1, 1, 1};
  hg_grid *grid = nullptr;
  if (hg_create(nullptr, &grid) != HG_OK || hg_insert(grid, 3, centers, radii) != HG_OK) {
    std::cerr << hg_last_error() << '\n';
    return 1;
  }
  size_t count = 0;
  const hg_status status = hg_visit_pairs(
      grid,
      [](void *context, const hg_pair *, size_t batch) -> int32_t {
        *static_cast<size_t *>(context) += batch;
        return 0;
      },
      &count);
  hg_destroy(grid);
  // Spheres 1 and 2 touch exactly: no contact.
  if (status != HG_OK || count != 1) {
    std::cerr << hg_status_string(status) << ", contacts: " << count << ", expected 1\n";
    return 1;
  }
  return 0;
}
