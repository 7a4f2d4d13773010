// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
#include "src/grid.hpp"

#include "src/base/error.hpp"
#include "src/base/parallel.hpp"
#include "src/base/sign.hpp"
#include "src/pairs/pair_visit.hpp"
#include "src/search/pair_search.hpp"
#include "src/search/sphere_search.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

namespace hg {
namespace {

// The visits that this thread is inside of, innermost first.
struct Visit {
  const Grid *grid;
  const Visit *outer;
};
thread_local const Visit *current_visit = nullptr;

class VisitScope {
 public:
  explicit VisitScope(const Grid *grid) : visit_{grid, current_visit} { current_visit = &visit_; }
  ~VisitScope() { current_visit = visit_.outer; }
  VisitScope(const VisitScope &) = delete;
  VisitScope &operator=(const VisitScope &) = delete;

 private:
  Visit visit_;
};

double largest_diameter(const Definition &definition) {
  return definition.level_rule == HG_LEVELS_USER ? definition.cell_sizes[definition.level_count - 1]
                                                 : std::numeric_limits<double>::infinity();
}

// S such that S^d is the volume the particles fill; by roots first, so that no product overflows.
double mean_edge(const Bounds &bounds, int dimension) {
  double edge = 1;
  for (int k = 0; k < dimension; k++) edge *= std::pow(bounds.width[k], 1.0 / dimension);
  return edge;
}

constexpr double kFittedPrecision = 1e-3;  // of m(L) for HG_LEVELS_AUTO, whose cost model is no better

}  // namespace

Grid::Grid(const Definition &definition, const hg_allocator &allocator)
    : definition_(definition),
      threads_(usable_threads(definition.thread_count)),
      memory_(allocator),
      store_(memory_, definition.domain, definition.interaction, definition.index_base, largest_diameter(definition),
             threads_),
      overlap_(definition.interaction, definition.accuracy, definition.domain),
      classes_(memory_),
      scratch_(memory_),
      index_(memory_),
      candidates_(memory_, threads_),
      search_(index_, store_, overlap_),
      filter_(candidates_, store_, overlap_),
      workers_(memory_, threads_),
      pairs_(memory_),
      order_(memory_),
      rows_{NeighborRows(memory_), NeighborRows(memory_)},
      by_slot_(memory_) {
  index_.interaction = definition.interaction;
  index_.domain = definition.domain;
}

bool Grid::is_visited() const {
  for (const Visit *visit = current_visit; visit != nullptr; visit = visit->outer) {
    if (visit->grid == this) return true;
  }
  return false;
}

void Grid::insert(size_t count, const double *centers, const double *radii) {
  store_.insert(count, centers, radii);
  changed(true);
  candidates_.drop();
}

void Grid::move(size_t count, const double *centers, const double *radii) {
  // Many callers give the same radii in each step; that is no reason to choose levels anew or to look for growth.
  const bool same = radii != nullptr && count > 0 && count == store_.slots() && count == store_.live_count() &&
                    std::memcmp(radii, store_.radii(), count * sizeof *radii) == 0;
  store_.move(count, centers, same ? nullptr : radii);
  changed(radii != nullptr && !same);
}

void Grid::remove(size_t count, const int32_t *ids) {
  store_.remove(count, ids);
  changed(true);
  candidates_.drop();
}

void Grid::clear() {
  store_.clear();
  changed(true);
  candidates_.drop();
  skin_pays_ = true;
}

void Grid::changed(bool radii) {
  built_ = false;
  classes_made_ = classes_made_ && !radii;
  grown_ = grown_ || radii;
  pairs_found_ = false;
  rows_made_[HG_HALF] = rows_made_[HG_FULL] = false;
}

void Grid::build() {
  const std::lock_guard lock(mutex_);
  build_locked();
}

void Grid::build_locked() {
  if (built_) return;
  // While the candidates hold, the index does too: its reach is wider by the skin.
  if (candidates_.follow(store_, grown_)) {
    built_ = true;
    return;
  }
  store_.compact();
  const Bounds bounds = bounds_of(store_, definition_.domain, threads_);
  const double skin = skin_pays_ ? usable_skin(definition_.skin, definition_.interaction, definition_.domain, bounds,
                                               definition_.accuracy, store_.slots())
                                 : 0;
  index_.interaction = definition_.interaction.widened(skin);
  LevelRequest request;
  request.dimension = definition_.dimension;
  request.level_count = definition_.level_count;
  request.cell_overhead = definition_.cell_overhead;
  request.edge = mean_edge(bounds, definition_.dimension);
  request.precision = definition_.level_rule == HG_LEVELS_PAPER ? 0 : kFittedPrecision;
  request.interaction = index_.interaction;
  plan_ = plan(request, bounds);
  build_index(index_, scratch_, store_, bounds, plan_, threads_);
  describe_levels(request);
  stats_.build_count++;
  built_ = true;
  grown_ = false;
}

LevelPlan Grid::plan(LevelRequest request, const Bounds &bounds) {
  if (definition_.level_rule == HG_LEVELS_USER) {
    LevelPlan levels = user_levels(definition_.cell_sizes, definition_.level_count, definition_.interaction);
    const double skin = request.interaction.margin - definition_.interaction.margin;
    for (int h = 0; skin > 0 && h < levels.level_count; h++) {
      levels.levels[h].cell_size = (levels.levels[h].cell_size + skin) * (1 + 0x1p-40);
    }
    return levels;
  }
  if (!classes_made_ && definition_.level_rule == HG_LEVELS_PAPER) {
    classes_.sort_radii(store_.radii(), store_.slots());
  } else if (!classes_made_) {
    classes_.bin_radii(store_.radii(), store_.slots());
  }
  classes_made_ = true;
  if (!definition_.counts_work || store_.slots() == 0) return plan_levels(classes_, request);
  const Interaction &interaction = request.interaction;
  const Frame frame = Frame::over(bounds, definition_.domain, interaction.diameter(bounds.max_radius));
  // One size leaves no choice that would be worth a sample.
  const Filling filling = classes_.count() == 1 ? Filling::even(frame.extent, definition_.dimension)
                                                : Filling::sample(store_, definition_.domain, frame);
  const LevelCost work(classes_, interaction, frame, definition_.dimension, filling);
  request.work = &work;
  request.prices = definition_.prices;
  return plan_levels(classes_, request);
}

void Grid::describe_levels(const LevelRequest &request) {
  for (int h = 0; h < index_.level_count; h++) {
    const IndexLevel &level = index_.levels[h];
    const int64_t particles = level.end - level.begin;
    levels_[h].cell_size = level.plan.cell_size;
    levels_[h].largest_radius = level.largest_radius;
    levels_[h].occupancy = occupancy(particles, level.plan.cell_size, request);
    levels_[h].particle_count = particles;
  }
}

Grid::Answer Grid::answer_locked() {
  build_locked();
  Answer answer;
  if (candidates_.kept()) {
    answer.source = &filter_;
    return answer;
  }
  answer.searched = true;
  const bool wide = index_.interaction.margin > definition_.interaction.margin;
  if (wide && skin_pays_) {
    // If not, the wide index serves for this answer; the next one is made without a skin.
    skin_pays_ = candidates_.collect(index_, store_, definition_.interaction, workers_, answer.collected);
  }
  if (candidates_.kept()) {
    answer.source = &filter_;
  } else {
    answer.source = &search_;
  }
  return answer;
}

void Grid::count_answer(const Answer &answer, const SearchCounts &counts, size_t pairs) {
  const bool collected = answer.searched && answer.source == &filter_;
  stats_.candidate_count = collected ? answer.collected.candidates : counts.candidates;
  stats_.undecided_count = counts.undecided;
  stats_.exact_count = counts.exact;
  stats_.pair_count = static_cast<int64_t>(pairs);
  if (answer.searched) {
    stats_.search_count++;
  } else {
    stats_.filter_count++;
  }
}

void Grid::find_pairs_locked() {
  build_locked();
  if (pairs_found_) return;
  const Answer answer = answer_locked();
  const SearchCounts counts = pairs_.gather(*answer.source, workers_, store_.slots());
  if (definition_.pair_order == HG_ORDER_ID) {
    order_.ascend(pairs_.data(), pairs_.count(), store_.slots(), store_.id_offset());
  }
  to_ids(pairs_.data(), pairs_.count(), store_);
  count_answer(answer, counts, pairs_.count());
  pairs_found_ = true;
}

void Grid::query_pairs(const hg_pair **pairs, size_t *count) {
  const std::lock_guard lock(mutex_);
  find_pairs_locked();
  *pairs = pairs_.count() == 0 ? nullptr : pairs_.data();
  *count = pairs_.count();
}

void Grid::visit_pairs(hg_pair_visitor *visit, void *context) {
  if (definition_.pair_order == HG_ORDER_ID) {
    const hg_pair *pairs = nullptr;
    size_t count = 0;
    query_pairs(&pairs, &count);
    const VisitScope scope(this);
    visit_list(pairs, count, visit, context);
    return;
  }
  Answer answer;
  {
    const std::lock_guard lock(mutex_);
    answer = answer_locked();
  }
  VisitResult result;
  {
    const VisitScope scope(this);
    result = visit_source(*answer.source, store_, memory_, visit, context);
  }
  const std::lock_guard lock(mutex_);
  count_answer(answer, result.counts, result.pairs);
}

void Grid::make_rows_locked(int32_t list) {
  find_pairs_locked();
  if (rows_made_[list]) return;
  NeighborRows &rows = rows_[list];
  const hg_pair *pairs = pairs_.data();
  if (store_.contiguous()) {
    rows.build(pairs, pairs_.count(), store_.slots(), store_.id_offset(), list);
  } else {
    by_slot_.require_room(pairs_.count());
    for (size_t p = 0; p < pairs_.count(); p++) {
      by_slot_[p] = {static_cast<int32_t>(store_.find(pairs[p].a)), static_cast<int32_t>(store_.find(pairs[p].b))};
    }
    rows.build(by_slot_.data(), pairs_.count(), store_.slots(), 0, list);
    const auto count = static_cast<size_t>(rows.offsets()[store_.slots()]);
    for (size_t k = 0; k < count; k++) rows.neighbors()[k] = store_.id(static_cast<size_t>(rows.neighbors()[k]));
  }
  rows_made_[list] = true;
}

void Grid::query_neighbors(int32_t list, const int64_t **offsets, const int32_t **neighbors) {
  const std::lock_guard lock(mutex_);
  make_rows_locked(list);
  *offsets = rows_[list].offsets();
  *neighbors = rows_[list].neighbors();
}

size_t Grid::query_sphere(const Ball &sphere, Buffer<int32_t> &found) {
  for (int k = 0; k < definition_.dimension; k++) {
    const double x = sphere.center[k];
    if (!std::isfinite(x)) fail(HG_ERR_ARGUMENT, "center[%d] = %g is not finite", k, x);
    if (!(std::fabs(definition_.domain.wraps(k, x)) <= kMaxWraps)) {
      fail(HG_ERR_ARGUMENT, "center[%d] = %g: more than 2^20 box lengths outside the periodic box", k, x);
    }
  }
  if (!std::isfinite(sphere.radius) || is_negative(sphere.radius)) {
    fail(HG_ERR_ARGUMENT, "radius = %g is not finite and >= 0", sphere.radius);
  }
  build();
  const size_t count = search_sphere(index_, store_, overlap_, candidates_, sphere, found);
  for (size_t k = 0; k < count; k++) found[k] = store_.id(static_cast<size_t>(found[k]));
  std::sort(found.data(), found.data() + count);
  return count;
}

void Grid::query_levels(const hg_level **levels, size_t *count) {
  build();
  *levels = levels_;
  *count = static_cast<size_t>(index_.level_count);
}

void Grid::query_level_costs(const hg_level_cost **costs, size_t *count) {
  build();
  *costs = plan_.costs;
  *count = static_cast<size_t>(plan_.cost_count);
}

hg_grid_stats Grid::stats() {
  const std::lock_guard lock(mutex_);
  hg_grid_stats stats = stats_;
  stats.particle_count = static_cast<int64_t>(store_.live_count());
  stats.level_count = index_.level_count;
  stats.row_count = index_.row_count;
  stats.cell_count = index_.cell_count;
  stats.stored_count = static_cast<int64_t>(candidates_.count());
  stats.byte_count = memory_.bytes() + static_cast<int64_t>(sizeof(Grid));
  return stats;
}

}  // namespace hg
