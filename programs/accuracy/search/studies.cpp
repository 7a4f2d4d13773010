// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
#include "programs/accuracy/search/studies.hpp"

namespace accuracy {

const std::vector<Study> &search_studies() {
  static const std::vector<Study> studies = {
      {"accuracy", "How overlap is decided",
       "`hg_grid_def.accuracy`. Error: pairs missing or extra over pairs, against the exact truth. Time: one search of "
       "a larger system of the same kind, one thread.",
       measure_decision_rules},
      {"skin", "When stored candidates are searched anew",
       "All fly straight on, the fastest by 0.01 of the smallest radius per step, for 60 steps. `skin`: the library's "
       "criterion, `hg_grid_def.skin`; `every k steps`: a list with the margin 0.1 kept for k steps and filtered by "
       "distance. Error: contacts missed against a fresh search in each step, and the deepest of them, its overlap "
       "over the smaller radius. Time: per step.",
       measure_rebuild_criteria},
      {"optimiser", "How the levels are looked for",
       "Appendix A of the paper. Error: cost f = L (m + K), K = 0.3, of the levels chosen, all radii counted, over the "
       "least cost less 1. Time: that of choosing, sorting of radii included; for the library, what a build takes "
       "longer than with the same cells given.",
       measure_level_choices},
      {"levels", "How many levels?",
       "`hg_grid_def.level_count`. The pairs are the same: there is no error, only time. Time: one search, one thread.",
       measure_level_counts, "levels"},
      {"prefilter", "Boxes before spheres",
       "A plain loop over candidate pairs, all that lie within sqrt(3) diameters, with and without a comparison of "
       "bounding boxes first. Error: pairs that differ. Time: the loop alone.",
       measure_prefilter}};
  return studies;
}

}  // namespace accuracy
