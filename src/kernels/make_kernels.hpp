// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Puts the kernels of one instruction set together. Included once by the file of each instruction set.
#pragma once

#include "src/kernels/filter.hpp"
#include "src/kernels/follow.hpp"
#include "src/kernels/keys.hpp"
#include "src/kernels/search.hpp"
#include "src/kernels/survey.hpp"

namespace hg {
namespace {

template <class V>
constexpr KernelSet make_kernels(const char *name) {
  return {name,
          {{make_search<V, 2, false>(), make_search<V, 2, true>()},
           {make_search<V, 3, false>(), make_search<V, 3, true>()}},
          {survey<2>, survey<3>},
          {make_build<2>(), make_build<3>()},
          {{follow<2>, follow<3>}, {filter<V, false>, filter<V, true>}}};
}

}  // namespace
}  // namespace hg
