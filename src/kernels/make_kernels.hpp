// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Puts the kernels of one instruction set together. Included once by the file of each instruction set.
#pragma once

#include "src/kernels/build.hpp"
#include "src/kernels/chunk_build.hpp"
#include "src/kernels/chunk_search.hpp"
#include "src/kernels/direct.hpp"
#include "src/kernels/filter.hpp"
#include "src/kernels/images.hpp"
#include "src/kernels/input_check.hpp"
#include "src/kernels/order.hpp"
#include "src/kernels/search.hpp"
#include "src/kernels/sphere.hpp"
#include "src/kernels/update.hpp"

#include <type_traits>

namespace hg {
namespace {

// In place of doubles side by side.
struct NoDoubles {};

template <class Doubles, int D, class Rule>
constexpr DirectKernel make_direct() {
  if constexpr (std::is_same_v<Doubles, NoDoubles>) {
    return {nullptr, nullptr};
  } else {
    return {direct_pairs<Doubles, D, Rule>, direct_contacts<Doubles, D, Rule>};
  }
}

template <class V, class Doubles, class Sorter, class... Rules>
constexpr KernelSet make_kernels(const char *name, RuleList<Rules...>) {
  return {name,
          {check_input<2>, check_input<3>},
          {move_centers<2>, move_centers<3>},
          {make_build<2>(), make_build<3>()},
          {make_chunk_build<2>(), make_chunk_build<3>()},
          {find_images<2>, find_images<3>},
          {{make_search<V, 2, Rules>()...}, {make_search<V, 3, Rules>()...}},
          {{make_chunk_search<V, 2, Rules>()...}, {make_chunk_search<V, 3, Rules>()...}},
          {{find_hits<V, 2, Rules>...}, {find_hits<V, 3, Rules>...}},
          {update<2>, update<3>},
          {filter<V, Rules>...},
          {{make_direct<Doubles, 2, Rules>()...}, {make_direct<Doubles, 3, Rules>()...}},
          order<Sorter>};
}

template <class V, class Doubles, class Sorter>
constexpr KernelSet make_kernels(const char *name) {
  return make_kernels<V, Doubles, Sorter>(name, InteractionRules{});
}

}  // namespace
}  // namespace hg
