// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// A grid as the C interface knows it: particles, the index over them, and the results lent to the caller.
#pragma once

#include "src/base/memory.hpp"
#include "src/definition.hpp"
#include "src/exact/overlap.hpp"
#include "src/index/build_index.hpp"
#include "src/levels/level_choice.hpp"
#include "src/pairs/neighbor_rows.hpp"
#include "src/pairs/pair_list.hpp"
#include "src/pairs/pair_order.hpp"
#include "src/particles/bounds.hpp"
#include "src/particles/given_arrays.hpp"
#include "src/particles/participants.hpp"
#include "src/search/built_grid.hpp"
#include "src/search/candidate_filter.hpp"
#include "src/search/pair_geometry.hpp"
#include "src/search/pair_search.hpp"
#include "src/search/pair_vectors.hpp"
#include "src/search/spatial_order.hpp"
#include "src/search/sphere_search.hpp"

#include <hgrid/types.h>

#include <mutex>

namespace hg {

class Grid {
 public:
  Grid(const Definition &definition, const hg_allocator &allocator);

  void insert(size_t count, const double *centers, const double *radii);
  void move(size_t count, const double *centers, const double *radii);
  void set(size_t count, const double *centers, const double *radii);
  void remove(size_t count, const int32_t *ids);
  void clear();
  // The same, of particles in arrays of any stride and type.
  void insert_arrays(size_t count, const hg_array *centers, const hg_array *radius);
  void move_arrays(size_t count, const hg_array *centers, const hg_array *radius);
  void set_arrays(size_t count, const hg_array *centers, const hg_array *radius);
  void set_box(const double *box_min, const double *box_max, const double *tilt);

  void set_groups(size_t count, const int32_t *groups);
  void set_group_pair(int32_t a, int32_t b, bool meet);
  void set_bodies(size_t count, const int32_t *bodies);

  // The calls below build the index if it is out of date. They may run in parallel with each other.
  void build();
  // For queries of single places (search/), which keep no results here.
  BuiltGrid built();
  void query_pairs(const hg_pair **pairs, size_t *count);
  void visit_pairs(hg_pair_visitor *visit, void *context);
  void query_pair_vectors(const double **vectors, const int32_t **shifts);
  void copy_pairs(size_t capacity, int32_t *a, int32_t *b, size_t *count);
  void visit_contacts(hg_contact_visitor *visit, void *context);
  void query_order(const int32_t **ids, size_t *count);
  bool overlaps(const Ball &a, const Ball &b) const { return hg::overlaps(definition_.domain, overlap_, a, b); }
  void query_neighbors(int32_t list, const int64_t **offsets, const int32_t **neighbors);
  void copy_neighbors(int32_t list, size_t capacity, int32_t *offsets, int32_t *neighbors, size_t *count);
  void query_levels(const hg_level **levels, size_t *count);
  void query_level_costs(const hg_level_cost **costs, size_t *count);
  hg_grid_stats stats();

  // True on a thread that is inside a visitor of this grid.
  bool is_visited() const;
  const hg_allocator &allocator() const { return memory_.allocator(); }
  size_t dimension() const { return static_cast<size_t>(definition_.domain.dimension); }

 private:
  // What answers a query of pairs.
  struct Answer {
    const PairSource *source = nullptr;
    bool searched = false;   // else stored candidates are filtered
    SearchCounts collected;  // by that search, if it stored candidates
  };

  void others_meet();
  void changed(bool radii);  // or which slots there are
  void build_locked();
  void describe_levels(const FilledVolume &volume);
  Answer answer_locked();
  void count_answer(const Answer &answer, const SearchCounts &counts, size_t pairs);
  void find_pairs_locked();
  void find_vectors_locked();
  PairGeometry geometry() const;
  bool visit_direct_contacts(hg_contact_visitor *visit, void *context);
  void make_rows_locked(int32_t list);

  Definition definition_;
  int threads_;
  Memory memory_;
  std::mutex mutex_;  // makes queries of several threads on one grid take turns where they store results
  ParticleStore store_;
  GroupTable group_table_;
  ParticipantList participants_;
  GivenArrays given_;
  Overlap overlap_;

  LevelChoice level_choice_;
  LevelPlan plan_;
  hg_level levels_[HG_MAX_LEVELS];
  Index index_;
  BuildScratch scratch_;
  SearchTasks tasks_;
  bool built_ = false;

  StoredCandidates candidates_;
  bool grown_ = false;     // a radius may have changed since the index was built
  bool skin_pays_ = true;  // false once candidates were too many to keep

  PairSearch search_;
  CandidateFilter filter_;
  PairPool pool_;
  PairList pairs_;
  bool pairs_found_ = false;
  PairOrder order_;
  PairVectors vectors_;
  SpatialOrder spatial_order_;
  NeighborRows rows_[2];  // HG_HALF, HG_FULL
  bool rows_made_[2] = {false, false};
  Buffer<hg_pair> by_slot_;
  hg_grid_stats stats_{};
};

}  // namespace hg
