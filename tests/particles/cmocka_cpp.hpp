// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// cmocka for C++: its header needs these before it and the C linkage around it.
#pragma once

#include <csetjmp>
#include <cstdarg>
#include <cstddef>
#include <cstdint>

extern "C" {
#include <cmocka.h>
}

// These macros of cmocka would rewrite member functions of the same names, in the standard library too.
#undef fail
#undef skip

// The test that a check is true. It asserts when no object of the check is alive any more: a failed assertion leaves by
// longjmp, which skips destructors.
template <bool (*Check)()>
void passes(void **) {
  const bool ok = Check();
  assert_true(ok);
}
