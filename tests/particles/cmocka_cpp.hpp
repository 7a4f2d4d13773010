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
