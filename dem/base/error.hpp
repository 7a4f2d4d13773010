// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Failures of the engine: texts that name what is wrong and the value.
#pragma once

#include "particles/error.hpp"
#include "particles/text/number.hpp"

namespace dem {

using particles::Error;
using particles::text;

}  // namespace dem
