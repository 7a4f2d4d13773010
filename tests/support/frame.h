/* SPDX-FileCopyrightText: The libhgrid developers
 * SPDX-License-Identifier: BSD-3-Clause */

/* cmocka, after the four headers that it expects before it (hence no sorting of includes here). Its version 1.1.5
 * does not declare itself as C for C++. */
#pragma once

/* clang-format off */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#ifdef __cplusplus
extern "C" {
#endif
#include <cmocka.h>
#ifdef __cplusplus
}
#endif
/* clang-format on */

#ifndef __cplusplus
/* The function of a test, which gets no state. */
#define TEST(name) static void name(__attribute__((unused)) void **state)
#else
/* This macro would rewrite hg::fail and member functions of the standard library. */
#undef fail

/* The test that a check is true. It asserts when no object of the check is alive any more: a failed assertion leaves by
 * longjmp, which skips destructors. */
template <bool (*Check)()>
void passes(void **) {
  const bool ok = Check();
  assert_true(ok);
}
#endif
