// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
#include "mpi/local_search.hpp"

#include "mpi/failure.hpp"

#include <hgrid/mpi.h>

#include <algorithm>
#include <cmath>

namespace hgrid::mpi {
namespace {

constexpr int32_t kGroups = HG_MPI_MAX_GROUPS;
// Where the table of group pairs has one.
size_t place_of(int32_t a, int32_t b) { return static_cast<size_t>(a) * kGroups + static_cast<size_t>(b); }
static_assert(2 * kGroups <= HG_MAX_GROUPS, "ghosts of a group are in another one, so that they do not meet");

bool is_tilted(const hg_grid_def &def) { return def.tilt[0] != 0 || def.tilt[1] != 0 || def.tilt[2] != 0; }

}  // namespace

GridHandle make_grid(const hg_grid_def &def) {
  hg_grid *grid = nullptr;
  check(hg_create(&def, &grid));
  return GridHandle(grid);
}

struct LocalSearch::Visit {
  const LocalSearch *search;
  hg_pair_visitor *visit;
  void *context;
  int64_t count;
  bool stopped;
};

LocalSearch::LocalSearch(const hg_grid_def &def) : def_(def), interacts_(size_t{kGroups} * kGroups, 1) {
  // The caller's array need not outlive the call; other rules do not read it.
  if (def.level_rule == HG_LEVELS_USER) {
    cell_sizes_.assign(def.cell_sizes, def.cell_sizes + def.level_count);
    def_.cell_sizes = cell_sizes_.data();
  }
  open(opened_);
}

// A periodic axis whose particles all lie so close together that no pair reaches across the face is searched as an open
// one, which is exact and cheaper. Edges of a tilted cell also lead along other axes, and other accuracies round
// differently without a shift: these keep their axes.
LocalSearch::Axes LocalSearch::axes_to_open(const Particles &particles) const {
  Axes axes{false, false, false};
  if (def_.accuracy != HG_EXACT || is_tilted(def_) || particles.count() == 0) return axes;
  double radius[2] = {0, 0};
  for (const double r : particles.radii) {
    radius[1] = std::max(radius[1], std::min(radius[0], r));
    radius[0] = std::max(radius[0], r);
  }
  const double reach = radius[0] + (def_.interaction == HG_MAX_RANGE ? 0 : radius[1]) + def_.margin;
  for (size_t axis = 0; axis < particles.dimension; axis++) {
    if (def_.periodic[axis] == 0) continue;
    double low = particles.centers[axis], high = low;
    for (size_t k = 0; k < particles.count(); k++) {
      low = std::min(low, particles.center(k)[axis]);
      high = std::max(high, particles.center(k)[axis]);
    }
    const double scale =
        std::fabs(def_.box_min[axis]) + std::fabs(def_.box_max[axis]) + std::fabs(low) + std::fabs(high);
    axes[axis] = high - low + reach + def_.skin + 0x1p-48 * (scale + reach) < def_.box_max[axis] - def_.box_min[axis];
  }
  return axes;
}

void LocalSearch::open(const Axes &axes) {
  hg_grid_def def = def_;
  for (int axis = 0; axis < 3; axis++) {
    if (!axes[static_cast<size_t>(axis)]) continue;
    def.periodic[axis] = 0;
    def.box_min[axis] = def.box_max[axis] = 0;
  }
  GridHandle grid = make_grid(def);
  for (int32_t a = 0; a < kGroups; a++) {
    for (int32_t b = 0; b < kGroups; b++) {
      if (interacts_[place_of(a, b)] == 0) {
        if (a <= b) check(hg_set_group_pair(grid.get(), a, b, 0));
        check(hg_set_group_pair(grid.get(), a, kGroups + b, 0));
      }
      if (a <= b) check(hg_set_group_pair(grid.get(), kGroups + a, kGroups + b, 0));
    }
  }
  grid_ = std::move(grid);
  opened_ = axes;
}

void LocalSearch::set(const Particles &particles, size_t owned) {
  owned_ = owned;
  ranking_radii_ = particles.radii;
  gids_ = particles.gids;
  const Axes axes = axes_to_open(particles);
  if (axes != opened_) open(axes);
  fill(particles);
}

void LocalSearch::fill(const Particles &particles) {
  pair_count_ = 0;
  check(hg_set(grid_.get(), particles.count(), particles.centers.data(), particles.radii.data()));
  set_groups(particles);
  set_bodies(particles);
}

void LocalSearch::move(const Particles &particles) {
  const Axes axes = axes_to_open(particles);
  bool still_open = true;
  for (size_t axis = 0; axis < 3; axis++) still_open = still_open && (axes[axis] || !opened_[axis]);
  if (still_open) {
    check(hg_move(grid_.get(), particles.count(), particles.centers.data(), particles.radii.data()));
    return;
  }
  open(axes);
  fill(particles);
}

void LocalSearch::set_groups(const Particles &particles) {
  groups_ = particles.groups;
  for (size_t k = owned_; k < groups_.size(); k++) {
    if (groups_[k] >= 0) groups_[k] += kGroups;
  }
  check(hg_set_groups(grid_.get(), groups_.size(), groups_.data()));
}

void LocalSearch::set_bodies(const Particles &particles) {
  const auto &bodies = particles.bodies;
  const bool any = std::any_of(bodies.begin(), bodies.end(), [](int32_t body) { return body >= 0; });
  check(hg_set_bodies(grid_.get(), bodies.size(), any ? bodies.data() : nullptr));
}

void LocalSearch::set_group_pair(int32_t group_a, int32_t group_b, bool interacts) {
  for (const int32_t ghosts : {0, kGroups}) {
    check(hg_set_group_pair(grid_.get(), group_a, ghosts + group_b, interacts ? 1 : 0));
    check(hg_set_group_pair(grid_.get(), ghosts + group_a, group_b, interacts ? 1 : 0));
  }
  interacts_[place_of(group_a, group_b)] = interacts ? 1 : 0;
  interacts_[place_of(group_b, group_a)] = interacts ? 1 : 0;
}

bool LocalSearch::is_own(const hg_pair &pair) const {
  // a < b, and of two ghosts the grid makes no pair: a is owned.
  const auto a = static_cast<size_t>(pair.a - def_.index_base), b = static_cast<size_t>(pair.b - def_.index_base);
  if (b < owned_) return true;
  const double ra = ranking_radii_[a], rb = ranking_radii_[b];
  return ra != rb ? ra < rb : gids_[a] < gids_[b];
}

const std::vector<hg_pair> &LocalSearch::pairs() {
  const hg_pair *found = nullptr;
  size_t count = 0;
  check(hg_query_pairs(grid_.get(), &found, &count));
  pairs_.clear();
  std::copy_if(found, found + count, std::back_inserter(pairs_), [&](const hg_pair &pair) { return is_own(pair); });
  pair_count_ = static_cast<int64_t>(pairs_.size());
  return pairs_;
}

int32_t LocalSearch::forward_batch(void *context, const hg_pair *pairs, size_t count) {
  auto *visit = static_cast<Visit *>(context);
  std::array<hg_pair, 1024> own;
  size_t filled = 0;
  const auto hand_on = [&] {
    if (filled == 0) return false;
    visit->count += static_cast<int64_t>(filled);
    visit->stopped = visit->visit(visit->context, own.data(), filled) != 0;
    filled = 0;
    return visit->stopped;
  };
  for (size_t k = 0; k < count; k++) {
    if (!visit->search->is_own(pairs[k])) continue;
    own[filled++] = pairs[k];
    if (filled == own.size() && hand_on()) return 1;
  }
  return hand_on() ? 1 : 0;
}

void LocalSearch::visit(hg_pair_visitor *visitor, void *context) {
  Visit visit{this, visitor, context, 0, false};
  visited_ = true;
  const hg_status status = hg_visit_pairs(grid_.get(), forward_batch, &visit);
  visited_ = false;
  check(status);
  if (!visit.stopped) pair_count_ = visit.count;
}

}  // namespace hgrid::mpi
