// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
#include "mpi/world.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace hgrid::mpi {

World::World(MPI_Comm comm, const hg_grid_def &grid_def, const hg_mpi_def &def)
    : comm_(comm),
      grid_def_(grid_def),
      def_(def),
      rule_(grid_def),
      search_(grid_def),
      judge_(make_grid(grid_def)),
      ghosts_(comm),
      migration_(comm) {
  // The search has its own copy, for grids that it makes later.
  grid_def_.cell_sizes = nullptr;
  check_mpi(MPI_Comm_rank(comm_, &rank_), "MPI_Comm_rank");
  check_mpi(MPI_Comm_size(comm_, &size_), "MPI_Comm_size");
  largest_.resize(2 * static_cast<size_t>(size_));
  particles_.dimension = static_cast<size_t>(grid_def.dimension);
}

World::~World() {
  int finalized = 0;
  MPI_Finalized(&finalized);
  if (finalized == 0) MPI_Comm_free(&comm_);
}

void World::check_call() const {
  if (is_visited()) fail(HG_ERR_STATE, "the pairs are being visited: no call on the object from its visitor");
}

void World::check_usable() const {
  check_call();
  if (!usable_)
    fail(HG_ERR_STATE, "there are no particles: call hg_mpi_set first, also after a call that failed midway");
}

void World::check_numbers(size_t count, const double *centers, const double *radii) {
  if (count > 0) check_pointer(centers, "centers");
  const size_t d = particles_.dimension;
  for (size_t k = 0; k < count * d; k++) {
    if (!std::isfinite(centers[k])) fail(HG_ERR_ARGUMENT, "centers[%zu][%zu] is %g", k / d, k % d, centers[k]);
  }
  for (size_t k = 0; k < count && radii != nullptr; k++) {
    if (!std::isfinite(radii[k]) || radii[k] < 0) fail(HG_ERR_ARGUMENT, "radii[%zu] is %g", k, radii[k]);
  }
  // A particle far outside the periodic box is its owner's fault, and not that of ranks that get it as a ghost.
  if (may_be_outside(count, centers)) {
    const std::vector<double> points(count, 0.0);
    check(hg_set(judge_.get(), count, centers, points.data()));
  }
}

bool World::may_be_outside(size_t count, const double *centers) const {
  const size_t d = particles_.dimension;
  for (size_t axis = 0; axis < d; axis++) {
    if (grid_def_.periodic[axis] == 0) continue;
    // Tilts add up; the grid knows how.
    if (grid_def_.tilt[0] != 0 || grid_def_.tilt[1] != 0 || grid_def_.tilt[2] != 0) return true;
    const double far = 0x1p18 * rule_.cell().length(static_cast<int>(axis));
    for (size_t k = axis; k < count * d; k += d) {
      if (!(std::fabs(centers[k] - grid_def_.box_min[axis]) < far)) return true;
    }
  }
  return false;
}

// Whether two particles could meet twice depends on the two largest of all ranks, so that all decide alike.
void World::check_cell(size_t count, const double *radii) {
  double mine[2] = {-1, -1};
  for (size_t k = 0; k < count; k++) {
    mine[1] = std::max(mine[1], std::min(mine[0], radii[k]));
    mine[0] = std::max(mine[0], radii[k]);
  }
  check_mpi(MPI_Allgather(mine, 2, MPI_DOUBLE, largest_.data(), 2, MPI_DOUBLE, comm_), "MPI_Allgather");
  together(comm_, [&] {
    std::partial_sort(largest_.begin(), largest_.begin() + 2, largest_.end(), [](double p, double q) { return p > q; });
    const size_t present = largest_[1] >= 0 ? 2 : largest_[0] >= 0 ? 1 : 0;
    double centers[6] = {0, 0, 0, 0, 0, 0};
    for (size_t k = 0; k < 2 * particles_.dimension; k++) {
      const size_t axis = k % particles_.dimension;
      if (grid_def_.periodic[axis] != 0) centers[k] = grid_def_.box_min[axis];
    }
    const hg_status status = hg_set(judge_.get(), present, centers, largest_.data());
    if (status != HG_OK) {
      fail(status, "the two largest particles of all ranks, of radii %g and %g: %.150s", largest_[0], largest_[1],
           hg_last_error());
    }
  });
}

void World::set(size_t count, const int64_t *gids, const double *centers, const double *radii) {
  Particles fresh;
  together(comm_, [&] {
    check_call();
    if (count > INT32_MAX) fail(HG_ERR_LIMIT, "count = %zu is above 2^31 - 1", count);
    if (count > 0) {
      check_pointer(gids, "gids");
      check_pointer(radii, "radii");
    }
    check_numbers(count, centers, radii);
    const size_t d = particles_.dimension;
    fresh.dimension = d;
    if (count > 0) {
      fresh.gids.assign(gids, gids + count);
      fresh.centers.assign(centers, centers + count * d);
      fresh.radii.assign(radii, radii + count);
    }
    fresh.groups.assign(count, 0);
    fresh.bodies.assign(count, -1);
  });
  check_cell(count, radii);
  if (def_.verify != 0) check_unique(comm_, fresh.gids);
  usable_ = balanced_ = false;
  particles_ = std::move(fresh);
  owned_ = count;
  choose_ghosts();
  imbalance_ = imbalance_of(static_cast<double>(count));
}

double World::imbalance_of(double weight) const {
  double sum = 0, most = 0;
  check_mpi(MPI_Allreduce(&weight, &sum, 1, MPI_DOUBLE, MPI_SUM, comm_), "MPI_Allreduce");
  check_mpi(MPI_Allreduce(&weight, &most, 1, MPI_DOUBLE, MPI_MAX, comm_), "MPI_Allreduce");
  return sum > 0 ? most * size_ / sum : 1;
}

void World::choose_ghosts() {
  usable_ = false;
  std::optional<Selection> selection;
  together(comm_, [&] {
    particles_.resize(owned_);
    selection.emplace(rule_, owned_, particles_.centers.data(), particles_.radii.data());
    chosen_centers_ = particles_.centers;
    chosen_radii_ = particles_.radii;
  });
  const BoxesOfRanks boxes = gather_boxes(selection->boxes());
  std::vector<std::vector<int32_t>> rows;
  together(comm_, [&] { rows = selection->rows_for(boxes, static_cast<size_t>(rank_)); });
  ghosts_.plan(owned_, rows);
  const auto arriving = ghosts_.send<Traveller>([&](size_t row) { return particles_.pack(row, 0); });
  together(comm_, [&] {
    particles_.resize(owned_ + arriving.size());
    ghost_owners_.resize(arriving.size());
    for (size_t k = 0; k < arriving.size(); k++) {
      particles_.unpack(owned_ + k, arriving[k]);
      ghost_owners_[k] = ghosts_.source_of(k);
    }
    search_.set(particles_, owned_);
  });
  selection_count_++;
  usable_ = true;
}

BoxesOfRanks World::gather_boxes(const std::vector<SizeBox> &mine) const {
  const auto ranks = static_cast<size_t>(size_);
  std::vector<int> counts, places;
  BoxesOfRanks all;
  together(comm_, [&] {
    counts.resize(ranks);
    places.resize(ranks);
    all.begin.assign(ranks + 1, 0);
  });
  // In bytes: a box is 72 of them, and a rank has a few boxes.
  const int bytes = static_cast<int>(mine.size() * sizeof(SizeBox));
  check_mpi(MPI_Allgather(&bytes, 1, MPI_INT, counts.data(), 1, MPI_INT, comm_), "MPI_Allgather");
  together(comm_, [&] {
    for (size_t k = 0; k < ranks; k++) {
      const size_t end = all.begin[k] + static_cast<size_t>(counts[k]) / sizeof(SizeBox);
      if (end * sizeof(SizeBox) > INT32_MAX) fail(HG_ERR_LIMIT, "more than 2^31 - 1 bytes of boxes");
      places[k] = static_cast<int>(all.begin[k] * sizeof(SizeBox));
      all.begin[k + 1] = end;
    }
    all.boxes.resize(all.begin.back());
  });
  check_mpi(
      MPI_Allgatherv(mine.data(), bytes, MPI_BYTE, all.boxes.data(), counts.data(), places.data(), MPI_BYTE, comm_),
      "MPI_Allgatherv");
  return all;
}

bool World::moved_too_far(const double *centers, const double *radii) const {
  const double most = 0.5 * grid_def_.skin * (1 - 0x1p-40);
  const size_t d = particles_.dimension;
  for (size_t k = 0; k < owned_; k++) {
    double way = rule_.cell().distance_moved(&chosen_centers_[k * d], centers + k * d);
    if (radii != nullptr) way += std::max(0.0, radii[k] - chosen_radii_[k]);
    if (!(way <= most)) return true;
  }
  return false;
}

bool World::move(size_t count, const double *centers, const double *radii) {
  // Whether radii are new, and whether ghosts must be chosen anew: of this rank, then of any.
  Numbers any{0, 0};
  together_most(comm_, any, [&] {
    check_usable();
    if (count != owned_) fail(HG_ERR_ARGUMENT, "count = %zu, but this rank owns %zu particles", count, owned_);
    check_numbers(count, centers, radii);
    any[0] = radii != nullptr ? 1 : 0;
    // Radii that stay since an earlier move may have grown since ghosts were chosen.
    const double *now = radii != nullptr || count == 0 ? radii : particles_.radii.data();
    any[1] = moved_too_far(centers, now) ? 1 : 0;
  });
  if (any[0] != 0) check_cell(count, radii != nullptr ? radii : particles_.radii.data());
  usable_ = false;
  std::copy(centers, centers + count * particles_.dimension, particles_.centers.begin());
  if (radii != nullptr) std::copy(radii, radii + count, particles_.radii.begin());
  if (any[1] != 0) {
    choose_ghosts();
  } else {
    update_ghosts();
  }
  return any[1] != 0;
}

void World::update_ghosts() {
  struct Place {
    double center[3];
    double radius;
  };
  const size_t d = particles_.dimension;
  const auto arriving = ghosts_.send<Place>([&](size_t row) {
    Place place{{0, 0, 0}, particles_.radii[row]};
    std::copy_n(particles_.center(row), d, place.center);
    return place;
  });
  together(comm_, [&] {
    for (size_t k = 0; k < arriving.size(); k++) {
      std::copy(arriving[k].center, arriving[k].center + d, &particles_.centers[(owned_ + k) * d]);
      particles_.radii[owned_ + k] = arriving[k].radius;
    }
    search_.move(particles_);
  });
  update_count_++;
  usable_ = true;
}

std::vector<double> World::weights_of_pairs() {
  std::vector<double> weights(owned_, 1.0);
  const auto base = static_cast<size_t>(grid_def_.index_base);
  for (const hg_pair &pair : search_.pairs()) weights[static_cast<size_t>(pair.a) - base] += 2;
  return weights;
}

void World::balance(const double *weights) {
  // Whether this rank has weights, and whether it lacks them; one without particles need not say.
  Numbers any{0, 0};
  together_most(comm_, any, [&] {
    check_usable();
    any[weights != nullptr ? 0 : 1] = owned_ > 0 ? 1 : 0;
    for (size_t k = 0; k < owned_ && weights != nullptr; k++) {
      if (!std::isfinite(weights[k]) || weights[k] < 0) fail(HG_ERR_ARGUMENT, "weights[%zu] is %g", k, weights[k]);
    }
  });
  std::vector<double> used;
  together(comm_, [&] {
    if (any[0] != 0 && any[1] != 0) fail(HG_ERR_ARGUMENT, "weights are given on some ranks only");
    used = any[0] != 0 && owned_ > 0 ? std::vector<double>(weights, weights + owned_) : weights_of_pairs();
  });
  const std::vector<int32_t> owners = choose_owners(comm_, def_, rule_.cell(), particles_, used);
  usable_ = balanced_ = false;
  std::vector<std::vector<int32_t>> rows;
  together(comm_, [&] {
    rows.resize(static_cast<size_t>(size_));
    for (size_t k = 0; k < owned_; k++) rows[static_cast<size_t>(owners[k])].push_back(static_cast<int32_t>(k));
  });
  migration_.plan(owned_, rows);
  const auto arriving = migration_.send<Traveller>([&](size_t row) { return particles_.pack(row, used[row]); });
  double weight = 0;
  together(comm_, [&] {
    particles_.resize(arriving.size());
    for (size_t k = 0; k < arriving.size(); k++) {
      particles_.unpack(k, arriving[k]);
      weight += arriving[k].weight;
    }
  });
  owned_ = arriving.size();
  choose_ghosts();
  balanced_ = true;
  imbalance_ = imbalance_of(weight);
}

void World::migrate(size_t row_bytes, const void *before, void *after) {
  migration_.forward(row_bytes, before, after, [&] {
    check_usable();
    if (!balanced_) fail(HG_ERR_STATE, "no hg_mpi_balance since hg_mpi_set: there is nothing to follow");
  });
}

void World::forward(size_t row_bytes, const void *owned, void *ghosts) {
  ghosts_.forward(row_bytes, owned, ghosts, [&] { check_usable(); });
}

void World::add_back(size_t columns, const double *ghosts, double *owned) {
  ghosts_.add_back(columns, ghosts, owned, [&] { check_usable(); });
}

// New numbers of the owned particles, `none` if there are none, and of their ghosts.
void World::spread(size_t count, const int32_t *numbers, int32_t none, std::vector<int32_t> Particles::*column) {
  std::vector<int32_t> fresh;
  together(comm_, [&] {
    fresh.assign(particles_.count(), none);
    if (numbers != nullptr) std::copy(numbers, numbers + count, fresh.begin());
  });
  ghosts_.forward(sizeof(int32_t), fresh.data(), fresh.data() + owned_, [] {});
  particles_.*column = std::move(fresh);
}

void World::set_groups(size_t count, const int32_t *groups) {
  together(comm_, [&] {
    check_usable();
    if (groups == nullptr) return;
    if (count != owned_) fail(HG_ERR_ARGUMENT, "count = %zu, but this rank owns %zu particles", count, owned_);
    for (size_t k = 0; k < count; k++) {
      if (groups[k] < -1 || groups[k] >= HG_MPI_MAX_GROUPS) {
        fail(HG_ERR_ARGUMENT, "groups[%zu] is %d, not in -1 .. %d", k, static_cast<int>(groups[k]),
             HG_MPI_MAX_GROUPS - 1);
      }
    }
  });
  spread(count, groups, 0, &Particles::groups);
  usable_ = false;
  together(comm_, [&] { search_.set_groups(particles_); });
  usable_ = true;
}

void World::set_bodies(size_t count, const int32_t *bodies) {
  together(comm_, [&] {
    check_usable();
    if (bodies == nullptr) return;
    if (count != owned_) fail(HG_ERR_ARGUMENT, "count = %zu, but this rank owns %zu particles", count, owned_);
    for (size_t k = 0; k < count; k++) {
      if (bodies[k] < -1) fail(HG_ERR_ARGUMENT, "bodies[%zu] is %d, below -1", k, static_cast<int>(bodies[k]));
    }
  });
  spread(count, bodies, -1, &Particles::bodies);
  usable_ = false;
  together(comm_, [&] { search_.set_bodies(particles_); });
  usable_ = true;
}

void World::set_group_pair(int32_t group_a, int32_t group_b, int32_t interacts) {
  const int64_t told = (int64_t{group_a} * INT16_MAX + group_b) * INT16_MAX + interacts;
  together_of(comm_, told, "the pair of groups", [&] {
    check_call();
    for (const int32_t group : {group_a, group_b}) {
      if (group < 0 || group >= HG_MPI_MAX_GROUPS) {
        fail(HG_ERR_ARGUMENT, "the group %d is not in 0 .. %d", static_cast<int>(group), HG_MPI_MAX_GROUPS - 1);
      }
    }
    if (interacts != 0 && interacts != 1) fail(HG_ERR_ARGUMENT, "interacts is %d", static_cast<int>(interacts));
  });
  together(comm_, [&] { search_.set_group_pair(group_a, group_b, interacts != 0); });
}

hg_mpi_stats World::stats() const {
  hg_mpi_stats stats{};
  stats.owned_count = static_cast<int64_t>(owned_);
  stats.ghost_count = static_cast<int64_t>(particles_.count() - owned_);
  stats.pair_count = search_.pair_count();
  stats.send_rank_count = ghosts_.send_rank_count();
  stats.receive_rank_count = ghosts_.receive_rank_count();
  stats.sent_byte_count = ghosts_.sent_byte_count() + migration_.sent_byte_count();
  stats.selection_count = selection_count_;
  stats.update_count = update_count_;
  stats.opened_axis_count = search_.opened_axis_count();
  stats.imbalance = imbalance_;
  return stats;
}

}  // namespace hgrid::mpi
