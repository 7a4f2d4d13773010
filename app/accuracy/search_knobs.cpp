// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause

// The list of the search's knobs.
#include "accuracy/search_knobs.hpp"

#include "accuracy/rule_knob.hpp"
#include "accuracy/skin_knob.hpp"

namespace accuracy {

const std::vector<Knob> &search_knobs() {
  static const std::vector<Knob> knobs = {
      {"accuracy", "How overlap is decided",
       "`hg_grid_def.accuracy`. Error: pairs missing or extra over pairs, against the truth in whole numbers. Time: "
       "one search of a larger system of the same kind, one thread.",
       measure_rules},
      {"skin", "When stored candidates are searched anew",
       "All fly straight on, the fastest by 0.01 of the smallest radius per step, for 60 steps. `skin`: the library's "
       "criterion, `hg_grid_def.skin`; `every k steps`: a list with the margin 0.1 kept for k steps and filtered by "
       "distance. Error: contacts missed against a fresh search in each step, and the deepest of them, its overlap "
       "over "
       "the smaller radius. Time: per step.",
       measure_skins}};
  return knobs;
}

}  // namespace accuracy
