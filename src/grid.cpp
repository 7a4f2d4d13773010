// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
#include "src/grid.hpp"

#include "src/base/error.hpp"
#include "src/base/parallel.hpp"
#include "src/pairs/pair_visit.hpp"
#include "src/search/contact_visit.hpp"
#include "src/search/direct_visit.hpp"
#include "src/search/skin.hpp"

#include <algorithm>
#include <cstring>

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

}  // namespace

Grid::Grid(const Definition &definition, const hg_allocator &allocator)
    : definition_(definition),
      threads_(usable_threads(definition.thread_count)),
      memory_(allocator),
      store_(memory_,
             InputCheck(definition.domain, definition.interaction, definition.levels.largest_diameter(), threads_),
             ShortCell(definition.domain, definition.interaction), definition.domain.dimension, definition.index_base),
      participants_(memory_),
      given_(memory_),
      overlap_(definition.interaction, definition.accuracy, definition.domain),
      level_choice_(memory_, definition.levels, definition.interaction),
      index_(memory_, definition.domain, definition.interaction),
      scratch_(memory_),
      tasks_(memory_),
      candidates_(memory_, threads_),
      search_(index_, tasks_, store_, overlap_),
      filter_(candidates_, store_, overlap_),
      pool_(memory_, threads_),
      pairs_(memory_),
      order_(memory_),
      vectors_(memory_),
      spatial_order_(memory_),
      rows_{NeighborRows(memory_), NeighborRows(memory_)},
      by_slot_(memory_) {}

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
  double distance = 0;
  store_.move(count, centers, same ? nullptr : radii, candidates_.counts_motion() ? &distance : nullptr);
  if (candidates_.counts_motion()) candidates_.add_motion(distance);
  changed(radii != nullptr && !same);
}

void Grid::set(size_t count, const double *centers, const double *radii) {
  if (count > 0 && count == store_.live_count() && store_.is_as_set()) {
    move(count, centers, radii);
    return;
  }
  store_.set(count, centers, radii);
  changed(true);
  candidates_.drop();
}

// A count that cannot be is refused before so much is copied.
void Grid::insert_arrays(size_t count, const hg_array *centers, const hg_array *radius) {
  store_.check_insert(count);
  given_.gather(count, dimension(), centers, radius);
  insert(count, given_.centers(), given_.radii());
}

void Grid::move_arrays(size_t count, const hg_array *centers, const hg_array *radius) {
  store_.check_count(count);
  given_.gather(count, dimension(), centers, radius);
  move(count, given_.centers(), radius != nullptr ? given_.radii() : nullptr);
}

void Grid::set_arrays(size_t count, const hg_array *centers, const hg_array *radius) {
  store_.check_set(count);
  given_.gather(count, dimension(), centers, radius);
  set(count, given_.centers(), given_.radii());
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

void Grid::set_box(const double *box_min, const double *box_max, const double *tilt) {
  const Domain domain = change_box(definition_.domain, box_min, box_max, tilt);
  store_.set_cell(domain, ShortCell(domain, definition_.interaction));
  definition_.domain = domain;
  overlap_.set_domain(domain);
  if (candidates_.keep_in(domain)) {
    index_.set_cell(domain);
  } else {
    candidates_.drop();
  }
  changed(false);
}

void Grid::set_groups(size_t count, const int32_t *groups) {
  if (store_.set_groups(count, groups)) others_meet();
}

void Grid::set_group_pair(int32_t a, int32_t b, bool meet) {
  if (group_table_.meet(a, b) == meet) return;
  group_table_.set(a, b, meet);
  others_meet();
}

void Grid::set_bodies(size_t count, const int32_t *bodies) {
  if (store_.set_bodies(count, bodies)) others_meet();
}

void Grid::others_meet() {
  changed(true);
  candidates_.drop();
}

void Grid::changed(bool radii) {
  built_ = false;
  if (radii) {
    level_choice_.radii_changed();
    scratch_.population.counted = false;
    participants_.groups_changed();
  }
  grown_ = grown_ || radii;
  pairs_found_ = false;
  vectors_.forget();
  spatial_order_.forget();
  rows_made_[HG_HALF] = rows_made_[HG_FULL] = false;
}

void Grid::build() {
  const std::lock_guard lock(mutex_);
  build_locked();
}

BuiltGrid Grid::built() {
  build();
  return {store_, overlap_, index_, candidates_, threads_};
}

void Grid::build_locked() {
  if (built_) return;
  // While the candidates hold, the index does too: its reach is wider by the skin.
  if (candidates_.update(store_, grown_)) {
    built_ = true;
    return;
  }
  store_.compact();
  const Domain &domain = definition_.domain;
  const Participants particles = participants_.of(store_, group_table_, threads_);
  const Bounds bounds = bounds_of(particles, domain, threads_);
  const FilledVolume volume = FilledVolume::of(bounds, domain.dimension);
  const double skin = skin_pays_ ? usable_skin(definition_.skin, definition_.interaction, domain, bounds,
                                               definition_.accuracy, particles.count())
                                 : 0;
  index_.domain = domain;
  index_.interaction = definition_.interaction.widened(skin);
  // Without particles a box has no resolution that its period could be counted in. Images may lie as far outside of it
  // as particles reach.
  if (particles.count() > 0) {
    const double images = domain.any_periodic ? 2 : 1;
    index_.map = FixedPoint::over(bounds, domain, images * index_.interaction.diameter(bounds.max_radius));
  }
  plan_ = level_choice_.choose(particles, index_.map, volume, index_.interaction);
  build_index(index_, scratch_, particles, plan_, threads_);
  tasks_.list(index_);
  describe_levels(volume);
  stats_.build_count++;
  built_ = true;
  grown_ = false;
}

void Grid::describe_levels(const FilledVolume &volume) {
  for (int h = 0; h < index_.insertion_levels; h++) levels_[h] = {plan_.levels[h].cell_size, 0, 0, 0};
  for (int h = 0; h < index_.level_count; h++) {
    const IndexLevel &level = index_.levels[h];
    hg_level &all = levels_[level.insertion_level];
    all.largest_radius = std::max(all.largest_radius, level.largest_radius);
    all.particle_count += level.end - level.begin;
  }
  for (int h = 0; h < index_.insertion_levels; h++) {
    levels_[h].occupancy = occupancy(levels_[h].particle_count, levels_[h].cell_size, volume);
  }
}

Grid::Answer Grid::answer_locked() {
  build_locked();
  Answer answer;
  if (candidates_.kept()) {
    if (definition_.pair_order == HG_ORDER_ID) {
      built_ = false;  // if they are dropped: the index alone is not where the particles are now
      candidates_.ascend(order_);
      built_ = true;
    }
    answer.source = &filter_;
    return answer;
  }
  answer.searched = true;
  const bool wide = index_.interaction.margin > definition_.interaction.margin;
  if (wide && skin_pays_) {
    // If not, the wide index serves for this answer; the next one is made without a skin.
    skin_pays_ = candidates_.collect(index_, tasks_, store_, definition_.interaction, pool_, answer.collected);
  }
  answer.source = candidates_.kept() ? static_cast<const PairSource *>(&filter_) : &search_;
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
  const SearchCounts counts = pairs_.gather(*answer.source, pool_, store_.slots());
  if (definition_.pair_order == HG_ORDER_ID && !candidates_.ascending()) {
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

PairGeometry Grid::geometry() const {
  return {definition_.domain, store_, overlap_, definition_.interaction.diameter(store_.summary().radius.greatest)};
}

void Grid::find_vectors_locked() {
  find_pairs_locked();
  if (vectors_.found() || pairs_.count() == 0) return;
  vectors_.find(geometry(), store_, pairs_.data(), pairs_.count(), definition_.domain.dimension, threads_);
}

void Grid::query_pair_vectors(const double **vectors, const int32_t **shifts) {
  const std::lock_guard lock(mutex_);
  find_vectors_locked();
  if (vectors != nullptr) *vectors = pairs_.count() == 0 ? nullptr : vectors_.vectors();
  if (shifts != nullptr) *shifts = pairs_.count() == 0 ? nullptr : vectors_.shifts();
}

void Grid::copy_pairs(size_t capacity, int32_t *a, int32_t *b, size_t *count) {
  const std::lock_guard lock(mutex_);
  find_pairs_locked();
  *count = pairs_.count();
  if (*count > capacity) fail(HG_ERR_CAPACITY, "%zu pairs, but capacity is %zu", *count, capacity);
  if (*count == 0) return;
  if (a == nullptr) fail(HG_ERR_NULL, "a is NULL");
  if (b == nullptr) fail(HG_ERR_NULL, "b is NULL");
  for (size_t p = 0; p < *count; p++) {
    a[p] = pairs_.data()[p].a;
    b[p] = pairs_.data()[p].b;
  }
}

// With many images a pair of ids does not tell which of them is meant: then the list tells it.
void Grid::visit_contacts(hg_contact_visitor *visit, void *context) {
  build();
  if (store_.slots() == 0 || visit_direct_contacts(visit, context)) return;
  const PairGeometry shape = geometry();
  ContactVisit contacts(shape, store_, definition_.domain.dimension, memory_, visit, context);
  if (shape.many_images()) {
    const double *vectors = nullptr;
    query_pair_vectors(&vectors, nullptr);
    const VisitScope scope(this);
    contacts.take(pairs_.data(), vectors, pairs_.count());
    return;
  }
  const auto take = [](void *all, const hg_pair *pairs, size_t count) -> int32_t {
    return static_cast<ContactVisit *>(all)->take(pairs, count) ? 0 : 1;
  };
  visit_pairs(take, &contacts);
}

// Contacts straight from direct candidates. False, and nothing is visited, if others have to answer.
bool Grid::visit_direct_contacts(hg_contact_visitor *visit, void *context) {
  const bool in_order = definition_.pair_order == HG_ORDER_ID;
  Answer answer;
  {
    const std::lock_guard lock(mutex_);
    build_locked();
    if (!candidates_.direct() || (in_order && pairs_found_)) return false;
    answer = answer_locked();
    if (in_order && !candidates_.ascending()) return false;
  }
  DirectVisit contacts(filter_, candidates_, store_, memory_, visit, context);
  {
    const VisitScope scope(this);
    contacts.run();
  }
  const std::lock_guard lock(mutex_);
  count_answer(answer, contacts.counts(), contacts.visited());
  return true;
}

void Grid::query_order(const int32_t **ids, size_t *count) {
  const BuiltGrid grid = built();
  const std::lock_guard lock(mutex_);
  if (!spatial_order_.found()) spatial_order_.find(grid);
  *count = store_.slots();
  *ids = *count == 0 ? nullptr : spatial_order_.ids();
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
  const bool ascending = definition_.pair_order == HG_ORDER_ID;
  if (store_.contiguous()) {
    rows.build(pairs, pairs_.count(), store_.slots(), store_.id_offset(), list, ascending);
  } else {
    by_slot_.require_room(pairs_.count());
    for (size_t p = 0; p < pairs_.count(); p++) {
      by_slot_[p] = {static_cast<int32_t>(store_.find(pairs[p].a)), static_cast<int32_t>(store_.find(pairs[p].b))};
    }
    rows.build(by_slot_.data(), pairs_.count(), store_.slots(), 0, list, ascending);
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

void Grid::copy_neighbors(int32_t list, size_t capacity, int32_t *offsets, int32_t *neighbors, size_t *count) {
  const std::lock_guard lock(mutex_);
  make_rows_locked(list);
  NeighborRows &rows = rows_[list];
  const int64_t *row_ends = rows.offsets();
  *count = static_cast<size_t>(row_ends[store_.slots()]);
  if (*count > INT32_MAX) fail(HG_ERR_LIMIT, "%zu neighbours are more than offsets of 32 bits can count", *count);
  std::copy(row_ends, row_ends + store_.slots() + 1, offsets);
  if (*count > capacity) fail(HG_ERR_CAPACITY, "%zu neighbours, but capacity is %zu", *count, capacity);
  if (*count == 0) return;
  if (neighbors == nullptr) fail(HG_ERR_NULL, "neighbors is NULL");
  std::copy(rows.neighbors(), rows.neighbors() + *count, neighbors);
}

void Grid::query_levels(const hg_level **levels, size_t *count) {
  build();
  *levels = levels_;
  *count = static_cast<size_t>(index_.insertion_levels);
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
  stats.level_count = index_.insertion_levels;
  stats.row_count = index_.row_count;
  stats.cell_count = index_.cell_count;
  stats.stored_count = static_cast<int64_t>(candidates_.count());
  stats.byte_count = memory_.bytes() + static_cast<int64_t>(sizeof(Grid));
  return stats;
}

}  // namespace hg
