/* SPDX-FileCopyrightText: The libhgrid developers
 * SPDX-License-Identifier: BSD-3-Clause */

/* A user in strict C99: the umbrella header alone, linked with the library. */
#include <hgrid/hgrid.h>

#include <stdio.h>

int main(void) {
  int major = -1, minor = -1, patch = -1;
  const hg_grid_def def = hg_default_grid_def();
  hg_version(&major, &minor, &patch);
  if (major != HG_VERSION_MAJOR || minor != HG_VERSION_MINOR || patch != HG_VERSION_PATCH) {
    (void)fprintf(stderr, "library %d.%d.%d, header %d.%d.%d\n", major, minor, patch, HG_VERSION_MAJOR,
                  HG_VERSION_MINOR, HG_VERSION_PATCH);
    return 1;
  }
  if (def.struct_size != sizeof def || def.dimension != 3) {
    (void)fprintf(stderr, "struct_size %u, dimension %d\n", (unsigned)def.struct_size, (int)def.dimension);
    return 1;
  }
  return 0;
}
