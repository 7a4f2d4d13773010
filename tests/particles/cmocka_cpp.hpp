// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The test that a check is true. It asserts when no object of the check is alive any more: a failed assertion leaves by
// longjmp, which skips destructors.
#pragma once

#include "tests/support/frame.h"

template <bool (*Check)()>
void passes(void **) {
  const bool ok = Check();
  assert_true(ok);
}
