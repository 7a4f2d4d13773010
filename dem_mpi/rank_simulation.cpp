// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The engine over ranks: the order of work within a step.
#include "dem_mpi/rank_simulation.hpp"

#include "dem/engine/snapshots.hpp"
#include "dem/setup/space_order.hpp"
#include "dem/setup/time_step.hpp"
#include "dem_mpi/springs.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace dem::ranks {
namespace {

void need(hg_status status) {
  if (status != HG_OK) throw Error(std::string(hg_status_string(status)) + ": " + hg_last_error());
}

std::unique_ptr<RankEngine> make(const RankPlan &plan, const std::vector<Checkpoint> *parts) {
  plan.ranks.together([&] {
    check_setup(plan.setup);
    require_time_step(plan.setup);
    const std::string fault = fault_over_ranks(plan.setup);
    if (!fault.empty()) throw Error(fault);
    if (plan.setup.count() > INT32_MAX) throw Error("there are 2^31 particles or more");
  });
  const std::vector<uint32_t> order = space_order(plan.setup);
  const Setup sorted = reordered(plan.setup, order);
  if (sorted.dimension == 2) return std::make_unique<RankSimulation<2>>(plan, sorted, order, parts);
  return std::make_unique<RankSimulation<3>>(plan, sorted, order, parts);
}

}  // namespace

std::string fault_over_ranks(const Setup &setup) {
  const std::string not_yet = " is not done over ranks yet: hgrid run does it";
  const EffectSet moving = setup.effects & (kShear | kGrowth);
  if (moving != 0) return tables_of(moving) + not_yet;
  if (has(setup.effects, kSurfaces)) return "[[wall]]" + not_yet + "; walls of the [box] are";
  if (setup.scheme.stages.size() > 1 || setup.scheme.shared_drift != 0)
    return "the scheme " + setup.scheme.name + " of [time]" + not_yet;
  if (setup.exchanges()) return "[[inflow]] and [[removal]]" + not_yet;
  if (setup.beginning.step > 0) return "[[stage]]" + not_yet;
  return "";
}

std::unique_ptr<RankEngine> make_rank_engine(const RankPlan &plan) { return make(plan, nullptr); }

std::unique_ptr<RankEngine> make_rank_engine(const RankPlan &plan, const std::vector<Checkpoint> &parts) {
  return make(plan, &parts);
}

template <int D>
RankSimulation<D>::RankSimulation(const RankPlan &plan, const Setup &sorted, const std::vector<uint32_t> &numbers,
                                  const std::vector<Checkpoint> *parts)
    : setup_(without_particles(sorted)),
      ranks_(plan.ranks),
      count_of_all_(sorted.count()),
      boundary_(make_boundary<D, double>(sorted)),
      body_force_(make_body_force<D, double>(sorted)),
      wall_laws_(sorted, Partner::kWall),
      wall_kernel_(find_wall_kernel<D, double>(sorted.effects)),
      motion_kernel_(find_motion_kernel<D, double>(sorted.effects)),
      slack_(rounding_slack<double>(sorted)),
      skin_(usable_skin(sorted, slack_)),
      room_(skin_ / 2, true),
      pairs_(sorted),
      sums_(deepest_force(sorted), *std::max_element(sorted.radii.begin(), sorted.radii.end()),
            has(sorted.effects, kFriction)),
      wall_history_(sorted.effects),
      fastest_allowed_(dem::fastest_allowed(sorted)),
      balance_every_(plan.balance_every) {
  if (parts != nullptr) {
    restore(*parts);
  } else {
    take_share(sorted, numbers);
  }
  make_world();
}

// Particles that are neighbours along the curve.
template <int D>
void RankSimulation<D>::take_share(const Setup &sorted, const std::vector<uint32_t> &numbers) {
  const auto rank = static_cast<size_t>(ranks_.rank()), size = static_cast<size_t>(ranks_.size());
  const size_t first = sorted.count() * rank / size, last = sorted.count() * (rank + 1) / size;
  owned_ = last - first;
  bodies_.resize(owned_, setup_.effects);
  for (size_t name = first; name < last; name++) {
    set_body(sorted, name, bodies_, name - first);
    names_.push_back(static_cast<int64_t>(name));
    numbers_.push_back(static_cast<int64_t>(numbers[name]));
  }
}

// The margin is that of lists which last some steps; ghosts are chosen with each list, so they need no skin.
template <int D>
void RankSimulation<D>::make_world() {
  hg_grid_def def = contact_grid_def(setup_, contact_range(setup_) + skin_ + slack_);
  def.accuracy = HG_EXACT;
  def.skin = 0;
  hg_mpi *made = nullptr;
  need(hg_mpi_create(ranks_.comm(), &def, nullptr, &made));
  world_.reset(made);
}

// A fault of this rank alone; the others learn of it when they next meet.
template <int D>
void RankSimulation<D>::note(const std::string &fault) {
  if (fault_.empty()) fault_ = "at step " + std::to_string(steps_) + " " + fault;
}

template <int D>
void RankSimulation<D>::tell_faults() {
  ranks_.together([&] {
    if (!fault_.empty()) throw Error(fault_);
  });
}

template <int D>
void RankSimulation<D>::check_speed() {
  for (size_t i = 0; i < owned_; i++) {
    const double approach = 2 * bodies_.velocity(i).norm();
    if (approach <= fastest_allowed_) continue;
    note(speed_fault(setup_, approach, fastest_allowed_));
  }
}

template <int D>
void RankSimulation<D>::run(uint64_t steps) {
  constexpr uint64_t kStepsPerLook = 16;
  for (; steps > 0; steps--) {
    if (fastest_allowed_ < kInfinity && steps_ % kStepsPerLook == 0) check_speed();
    find_forces();
    Stage stage = setup_.scheme.stages.front();
    if (steps_ == 0) stage.kick -= setup_.scheme.shared_kick;
    advance(stage);
    steps_++;
  }
  tell_faults();
}

template <int D>
void RankSimulation<D>::advance(const Stage &stage) {
  last_drift_ = stage.drift * setup_.time_step;
  const MotionTask<D, double> task{&bodies_, body_force_, stage.kick * setup_.time_step, last_drift_};
  const double fastest = motion_kernel_(task, 0, owned_);
  room_.spend(std::sqrt(fastest) * std::abs(last_drift_));
  met_ = forces_known_ = false;
}

template <int D>
bool RankSimulation<D>::lists_hold() {
  // A fault here ends all ranks, so one word tells both.
  const bool fine = fault_.empty(), hold = listed_ && room_.holds(bodies_, 1);
  const int64_t worst = ranks_.largest(int64_t{!fine ? 2 : !hold ? 1 : 0});
  if (worst == 2) tell_faults();
  return worst == 0;
}

template <int D>
void RankSimulation<D>::meet() {
  if (met_) return;
  if (lists_hold()) {
    send_ghosts();
  } else {
    renew(false);
    if (ranks_.size() > 1 && balance_every_ > 0 && steps_ >= next_balance_) {
      renew(true);
      next_balance_ = steps_ + balance_every_;
    }
  }
  met_ = true;
}

template <int D>
std::vector<double> RankSimulation<D>::packed_centers() const {
  std::vector<double> centers;
  centers.reserve(owned_ * D);
  for (size_t i = 0; i < owned_; i++)
    centers.insert(centers.end(), bodies_.places[i].numbers, bodies_.places[i].numbers + D);
  return centers;
}

template <int D>
std::vector<double> RankSimulation<D>::radii() const {
  std::vector<double> result;
  result.reserve(bodies_.count());
  for (size_t i = 0; i < bodies_.count(); i++) result.push_back(bodies_.radius(i));
  return result;
}

// New lists for the present places; with new owners before.
template <int D>
void RankSimulation<D>::renew(bool with_balance) {
  pairs_.pack();
  wall_history_.pack(wall_names());
  const std::vector<double> centers = packed_centers();
  if (!listed_) {
    need(hg_mpi_set(world_.get(), owned_, names_.data(), centers.data(), radii().data()));
  } else {
    need(hg_mpi_move(world_.get(), owned_, centers.data(), nullptr, nullptr));
  }
  listed_ = true;
  if (with_balance) balance();
  size_t ghosts = 0, count = 0;
  const int64_t *ghost_names = nullptr;
  need(hg_mpi_ghosts(world_.get(), &ghosts, &ghost_names, nullptr, nullptr, nullptr));
  names_.resize(owned_);
  if (ghosts > 0) names_.insert(names_.end(), ghost_names, ghost_names + ghosts);
  bodies_.resize(owned_ + ghosts, setup_.effects);
  if (has(setup_.effects, kMaterials)) {
    uint8_t *materials = bodies_.materials.data();
    need(hg_mpi_forward(world_.get(), sizeof *materials, materials, materials + owned_));
  }
  prepare_travel();
  send_ghosts();
  const hg_pair *found = nullptr;
  ranks_.together([&] {
    need(hg_mpi_query_pairs(world_.get(), &found, &count));
    pairs_.list(found, count, names_);
    list_walls();
    room_.renew(bodies_);
    sums_.clear(bodies_.count());
  });
}

template <int D>
void RankSimulation<D>::list_walls() {
  walls_.clear();
  wall_names_.clear();
  if (has(setup_.effects, kWalls)) {
    const WallReach<D, double> reach(boundary_, contact_range(setup_) + skin_ / 2 + slack_);
    reach.list_all(bodies_, owned_, walls_);
    const auto name = [&](const hg_pair &wall) { return names_[static_cast<size_t>(wall.a)]; };
    std::sort(walls_.begin(), walls_.end(),
              [&](const hg_pair &x, const hg_pair &y) { return name(x) != name(y) ? name(x) < name(y) : x.b < y.b; });
    for (const hg_pair &wall : walls_) wall_names_.push_back({static_cast<int32_t>(name(wall)), wall.b});
  }
  wall_history_.unpack(wall_names(), {{0, walls_.size(), nullptr}});
}

// Of the owned rows those that are ghosts anywhere, and room for what travels of them in each step.
template <int D>
void RankSimulation<D>::prepare_travel() {
  const size_t ghosts = bodies_.count() - owned_;
  const std::vector<double> ones(ghosts, 1.0);
  std::vector<double> asked(owned_, 0.0);
  need(hg_mpi_reverse_add(world_.get(), 1, ones.data(), asked.data()));
  travelling_.clear();
  for (size_t i = 0; i < owned_; i++) {
    if (asked[i] > 0) travelling_.push_back(i);
  }
  leaving_.resize(travel_rows() * owned_);
  arriving_.resize(travel_rows() * ghosts);
}

// Place with radius, velocity with inverse mass, spin.
template <int D>
void RankSimulation<D>::send_ghosts() {
  const size_t width = travel_rows();
  for (const size_t i : travelling_) {
    Row<double> *row = &leaving_[width * i];
    row[0] = bodies_.places[i];
    row[1] = bodies_.moves[i].speed;
    if (rotates()) row[2] = bodies_.turns[i].speed;
  }
  need(hg_mpi_forward(world_.get(), width * sizeof(Row<double>), leaving_.data(), arriving_.data()));
  for (size_t i = owned_; i < bodies_.count(); i++) {
    const Row<double> *row = &arriving_[width * (i - owned_)];
    bodies_.places[i] = row[0];
    bodies_.moves[i].speed = row[1];
    if (rotates()) bodies_.turns[i].speed = row[2];
  }
}

template <int D>
template <class Rows>
void RankSimulation<D>::migrate(Rows &rows, size_t count, size_t width) {
  Rows after(count * width);
  need(hg_mpi_migrate(world_.get(), width * sizeof rows[0], rows.data(), after.data()));
  rows.swap(after);
}

template <int D>
void RankSimulation<D>::balance() {
  const std::vector<double> known_radii = radii();
  size_t count = 0;
  const hg_status status = hg_mpi_balance(world_.get(), nullptr, &count);
  if (status == HG_ERR_STATE) {  // the library was built without Zoltan
    balance_fault_ = hg_last_error();
    balance_every_ = 0;
    return;
  }
  need(status);
  const size_t owned_before = owned_;
  migrate_history(count, known_radii, owned_before);
  migrate(bodies_.places, count);
  migrate(bodies_.moves, count);
  if (rotates()) migrate(bodies_.turns, count);
  if (has(setup_.effects, kMaterials)) migrate(bodies_.materials, count);
  migrate(numbers_, count);
  owned_ = count;
}

// Names come to be those of the particles as they are owned now.
template <int D>
void RankSimulation<D>::migrate_history(size_t count, const std::vector<double> &radii_before, size_t owned_before) {
  std::vector<Spring> springs;
  size_t width = 0;
  std::vector<std::vector<Spring>> of;
  ranks_.together([&] {
    of = springs_of({&names_, &radii_before, owned_before}, pairs_.memory(), wall_history_.memory_of(wall_names()), D);
    for (const auto &own : of) width = std::max(width, own.size());
  });
  width = static_cast<size_t>(ranks_.largest(static_cast<int64_t>(width)));
  for (auto &own : of) {
    own.resize(width);
    springs.insert(springs.end(), own.begin(), own.end());
  }
  if (width > 0) migrate(springs, count, width);
  const int64_t *names = nullptr;
  need(hg_mpi_owned(world_.get(), nullptr, &names, nullptr, nullptr));
  names_.assign(names, names + count);
  ranks_.together([&] {
    const Memories memories = memories_of(names_, springs, width, D);
    pairs_.remember(memories.pairs);
    wall_history_.begin(memories.walls);
  });
}

// Walls first, as in dem::Simulation; then what all pairs do, wherever they are found.
template <int D>
void RankSimulation<D>::find_forces() {
  if (forces_known_) return;
  meet();
  const ContactTask<D, double> of_walls{&bodies_,           &boundary_,  wall_laws_.all().data(),
                                        wall_laws_.width(), last_drift_, contact_range(setup_)};
  wall_kernel_(of_walls, {walls_.data(), 0, walls_.size(), 0, owned_, wall_history_.part(0)});
  pairs_.add(bodies_, boundary_, last_drift_, sums_);
  need(hg_mpi_reverse_add(world_.get(), sums_.columns(), sums_.of(owned_), sums_.of(0)));
  bool exact = true;
  for (size_t i = 0; i < owned_; i++) exact &= sums_.give(i, bodies_.moves[i], rotates() ? &bodies_.turns[i] : nullptr);
  sums_.clear_from(owned_);
  if (!exact) {
    note("contacts push a particle with more than " + text(sums_.most()) +
         ", or with no number: the time step is too large, or particles start inside each other");
  }
  forces_known_ = true;
}

template <int D>
hg_mpi_stats RankSimulation<D>::stats() const {
  hg_mpi_stats stats{};
  need(hg_mpi_get_stats(world_.get(), &stats, sizeof stats));
  return stats;
}

template class RankSimulation<2>;
template class RankSimulation<3>;

}  // namespace dem::ranks
