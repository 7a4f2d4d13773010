// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Refuses to compile with arithmetic that is not IEEE 754 double: pairs would depend on the compiler, and NaN would
// pass the checks of input.
#pragma once

#include <cfloat>

#if defined(__FAST_MATH__) || (defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__ > 0) || \
    defined(__ASSOCIATIVE_MATH__) || defined(__RECIPROCAL_MATH__) || defined(__NO_SIGNED_ZEROS__)
#error "libhgrid cannot be compiled with -ffast-math or a part of it; cmake/Flags.cmake switches all of it off"
#endif

static_assert(FLT_EVAL_METHOD == 0, "HG_DOUBLE is defined by double arithmetic without extended precision");
