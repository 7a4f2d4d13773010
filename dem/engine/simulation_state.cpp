// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Looking at a simulation, saving and restoring it.
#include "dem/base/error.hpp"
#include "dem/engine/acting_contacts.hpp"
#include "dem/engine/fingerprint.hpp"
#include "dem/engine/measure.hpp"
#include "dem/engine/simulation.hpp"
#include "dem/engine/snapshots.hpp"
#include "dem/engine/work.hpp"
#include "dem/setup/materials.hpp"
#include "dem/setup/space_order.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace dem {
namespace {

template <int D>
SurfaceState<D> surfaces_in(const Setup &setup, const Surfaces<D> &surfaces, const Snapshot &state) {
  SurfaceState<D> result;
  const PairView list = surfaces.pairs();
  std::vector<SurfaceTouch<D>> touches;
  for (size_t first = 0, end = 0; first < list.size(); first = end) {
    const auto i = static_cast<size_t>(list[first].a);
    while (end < list.size() && list[end].a == list[first].a) end++;
    find_touches<D>(surfaces.surfaces(), list.data(), first, end, vector_at<Vec<D, double>>(state.centers, i),
                    state.radii[i], contact_range(setup), touches);
    for (const SurfaceTouch<D> &touch : touches) {
      if (!touch.counts) continue;
      result.list.push_back(list[touch.place]);
      result.touches.push_back(touch);
      const Surface<D> &surface = surfaces.surfaces()[static_cast<size_t>(list[touch.place].b)];
      const WallPose<D> &pose = surfaces.pose_of(surface);
      const Vec<D, double> point =
          vector_at<Vec<D, double>>(state.centers, i) + touch.nearest.distance * touch.nearest.normal;
      result.walls.push_back(surface.wall);
      result.materials.push_back(surface.material);
      result.velocities.push_back(pose.velocity_at(point));
      result.spins.push_back(pose.spin);
    }
  }
  return result;
}

}  // namespace

template <int D, class Real>
double Simulation<D, Real>::lag() const {
  return steps_since_beginning() > 0 ? setup_.scheme.shared_kick * setup_.time_step : 0;
}

template <int D, class Real>
Snapshot Simulation<D, Real>::state_now() {
  if (lag() != 0) find_forces();
  return state_after(lag());
}

template <int D, class Real>
Snapshot Simulation<D, Real>::state_after(double time) const {
  const auto lead = static_cast<Real>(setup_.scheme.shared_drift * setup_.time_step);
  Snapshot state = snapshot_of(bodies_, bodies_.count(), setup_.effects, body_force_, static_cast<Real>(time), lead);
  state.time = this->time();
  state.image_offset = image_offset();
  state.material_ids = bodies_.materials;
  return state;
}

template <int D, class Real>
Snapshot Simulation<D, Real>::snapshot() {
  Snapshot state = state_now();
  reorder(state, places_);
  bring_into_box(setup_, state);
  return state;
}

template <int D, class Real>
Handover Simulation<D, Real>::hand_over() {
  Snapshot state = snapshot();
  Handover result;
  result.beginning.step = steps_;
  result.beginning.time = state.time;
  result.beginning.image_offset = state.image_offset;
  const std::vector<uint32_t> numbers = inverse(places_);
  result.beginning.pairs = renumbered_pairs(pair_history_.memory_of(pairs_), numbers);
  result.beginning.walls = renumbered_walls(wall_history_.memory_of(walls()), numbers);
  result.beginning.surfaces = renumbered_walls(surface_history_.memory_of(surfaces_.pairs()), numbers);
  result.beginning.wall_places = surfaces_.named_places();
  result.particles = std::move(state);
  return result;
}

template <int D, class Real>
std::vector<WallReport> Simulation<D, Real>::walls_now() {
  if (!surfaces_.empty()) find_forces();
  return surfaces_.reports();
}

template <int D, class Real>
void Simulation<D, Real>::visit_loads_of(const Snapshot &lagging, const LoadVisit<D> &visit) {
  Boundary<D, double> boundary = make_boundary<D, double>(setup_);
  boundary.offset = image_offset();
  if (setup_.scheme.shared_drift == 0) {
    find_pairs();
    ContactState<D> of_pairs = pairs_in<D>(setup_, boundary, lagging, pairs_);
    ContactState<D> of_walls = walls_in<D>(setup_, boundary, lagging, walls());
    add_history(pair_history_, pairs_, of_pairs.list, of_pairs);
    add_history(wall_history_, walls(), of_walls.list, of_walls);
    SurfaceState<D> of_surfaces = surfaces_in<D>(setup_, surfaces_, lagging);
    add_history(surface_history_, surfaces_.pairs(), of_surfaces.list, of_surfaces);
    return visit_loads<D>(setup_, boundary, lagging, of_pairs, of_walls, of_surfaces, visit);
  }
  // Positions are ahead of the step: its contacts are others than those of the forces, and remember nothing.
  room_.forget();
  const auto column = [](const double *first, size_t width) {
    return hg_array{first, static_cast<int64_t>(width * sizeof(double)), HG_REAL64, 0};
  };
  hg_array centers[3];
  for (size_t k = 0; k < D; k++) centers[k] = column(lagging.centers.data() + k, D);
  pairs_ = search_.find(bodies_.count(), centers, nullptr, image_offset());
  std::vector<hg_pair> listed;
  const WallReach<D, double> reach(boundary, contact_range(setup_) + slack_);
  for (size_t i = 0; i < lagging.radii.size(); i++) {
    reach.list(vector_at<Vec<D, double>>(lagging.centers, i), lagging.radii[i], i, listed);
  }
  visit_loads<D>(setup_, boundary, lagging, pairs_in<D>(setup_, boundary, lagging, pairs_),
                 walls_in<D>(setup_, boundary, lagging, {listed.data(), listed.size()}), {}, visit);
}

template <int D, class Real>
Measurement Simulation<D, Real>::measure() {
  const Snapshot state = state_now(), lagging = state_after(0);
  StateMeasure<D> measured(setup_, state);
  PowerMeasure<D> power(setup_, lagging, state);
  visit_loads_of(lagging, [&](const ContactLoad<D> &load) {
    measured.add(load);
    if (counts_work_) power.add(load);
  });
  Measurement result = measured.result();
  result.wall_work = surfaces_.work();
  if (!counts_work_) return result;
  result.work = work_;
  add(result.work, power.power(), lag());
  add(result.work, power.held(), -1);
  return result;
}

template <int D, class Real>
void Simulation<D, Real>::count_work() {
  const Scheme &scheme = setup_.scheme;
  if (scheme.name != velocity_verlet().name) throw Error("work is not counted with the scheme " + scheme.name);
  if (has(setup_.effects, kGrowth)) throw Error("work is not counted with growth: that of growing is not known");
  if (!exchange_.empty()) throw Error("work is not counted with [[inflow]] and [[removal]]: who goes takes some along");
  counts_work_ = true;
  // What springs along the surfaces hold by now is not dissipated yet, and is found when it is.
  if (steps_ == 0) return;
  const Snapshot state = state_after(0);
  PowerMeasure<D> power(setup_, state, state);
  visit_loads_of(state, [&](const ContactLoad<D> &load) { power.add(load); });
  add(work_, power.held(), 1);
}

// What the forces of this step do while velocities advance by `kick`.
template <int D, class Real>
void Simulation<D, Real>::tally(double kick) {
  const Snapshot state = state_now(), lagging = state_after(0);
  PowerMeasure<D> power(setup_, lagging, state);
  visit_loads_of(lagging, [&](const ContactLoad<D> &load) { power.add(load); });
  add(work_, power.power(), kick);
}

template <int D, class Real>
std::vector<ContactLine> Simulation<D, Real>::contacts() {
  state_now();  // the forces of the positions
  const Snapshot state = state_after(0);
  Snapshot shown = state;
  bring_into_box(setup_, shown);
  const std::vector<uint32_t> given = inverse(places_);
  std::vector<ContactLine> lines;
  visit_loads_of(state, [&](const ContactLoad<D> &load) {
    if (!(load.overlap > 0)) return;
    const bool wall = load.b == ContactLoad<D>::kWall, turned = !wall && given[load.a] > given[load.b];
    const size_t first = turned ? load.b : load.a, second = turned ? load.a : load.b;
    ContactLine line;
    line.a = given[first];
    line.b = wall ? -1 : static_cast<int64_t>(given[second]);
    for (size_t k = 0; k < D; k++) {
      const double way = (load.arm_a + load.arm_b) * load.normal[static_cast<Eigen::Index>(k)];
      line.from[k] = shown.centers[first * D + k];
      line.to[k] = line.from[k] + (turned ? -way : way);
    }
    line.overlap = load.overlap;
    line.normal = load.spring + load.dashpot;
    line.tangential = load.tangential.norm();
    lines.push_back(line);
  });
  std::sort(lines.begin(), lines.end(),
            [](const ContactLine &x, const ContactLine &y) { return x.a != y.a ? x.a < y.a : x.b < y.b; });
  return lines;
}

template <int D, class Real>
void Simulation<D, Real>::save(Checkpoint &checkpoint) const {
  dem::save(Fingerprint{D, sizeof(Real), setup_.effects, bodies_.count(), setup_.time_step}, setup_, checkpoint);
  checkpoint.put_value("steps", steps_);
  checkpoint.put_value("forces known", static_cast<uint64_t>(forces_known_));
  checkpoint.put_value("last drift", last_drift_);
  if (!exchange_.empty()) {
    checkpoint.put("places", places_);
    checkpoint.put_value("unsorted", unsorted_);
    exchange_.save(checkpoint);
  }
  if (counts_work_) checkpoint.put_value("work", work_);
  visit_quantities(bodies_, [&](const char *name, size_t count, size_t width, auto numbers_of) {
    std::vector<Real> numbers;
    for (size_t i = 0; i < count; i++) numbers.insert(numbers.end(), numbers_of(i), numbers_of(i) + width);
    checkpoint.put(name, numbers);
  });
  if (has(setup_.effects, kMaterials)) checkpoint.put("materials", bodies_.materials);
  pair_history_.save("pair", pairs_, checkpoint);
  wall_history_.save("wall", walls(), checkpoint);
  if (!surfaces_.empty()) surface_history_.save("surface", surfaces_.pairs(), checkpoint);
  surfaces_.save(checkpoint);
}

template <int D, class Real>
void Simulation<D, Real>::restore(const Checkpoint &checkpoint) {
  const bool exchanges = !exchange_.empty();  // then any number of particles may be there
  const Fingerprint own{D, sizeof(Real), setup_.effects, exchanges ? 0 : bodies_.count(), setup_.time_step};
  const uint64_t there = require_same(own, setup_, checkpoint);
  if (exchanges) {
    exchange_.restore(checkpoint);
    bodies_.resize(there, setup_.effects);
    places_.resize(there);
    checkpoint.get("places", places_);
    unsorted_ = checkpoint.get_value<uint64_t>("unsorted");
  }
  if (has(setup_.effects, kMaterials)) checkpoint.get("materials", bodies_.materials);
  steps_ = checkpoint.get_value<uint64_t>("steps");
  forces_known_ = checkpoint.get_value<uint64_t>("forces known") != 0;
  last_drift_ = checkpoint.get_value<double>("last drift");
  if (counts_work_) work_ = checkpoint.get_value<Work>("work");
  visit_quantities(bodies_, [&](const char *name, size_t count, size_t width, auto numbers_of) {
    std::vector<Real> numbers(width * count);
    checkpoint.get(name, numbers);
    for (size_t i = 0; i < count; i++) std::copy_n(numbers.data() + i * width, width, numbers_of(i));
  });
  pair_history_.restore("pair", checkpoint);
  wall_history_.restore("wall", checkpoint);
  if (!surfaces_.empty()) surface_history_.restore("surface", checkpoint);
  surfaces_.restore(checkpoint);
  radii_new_ = true;
  room_.forget();
}

#define DEM_INSTANTIATE(D, Real)                                         \
  template double Simulation<D, Real>::lag() const;                      \
  template Snapshot Simulation<D, Real>::state_now();                    \
  template Snapshot Simulation<D, Real>::snapshot();                     \
  template Handover Simulation<D, Real>::hand_over();                    \
  template std::vector<WallReport> Simulation<D, Real>::walls_now();     \
  template Measurement Simulation<D, Real>::measure();                   \
  template std::vector<ContactLine> Simulation<D, Real>::contacts();     \
  template void Simulation<D, Real>::count_work();                       \
  template void Simulation<D, Real>::tally(double kick);                 \
  template void Simulation<D, Real>::save(Checkpoint &checkpoint) const; \
  template void Simulation<D, Real>::restore(const Checkpoint &checkpoint);

DEM_INSTANTIATE(2, double)
DEM_INSTANTIATE(3, double)
DEM_INSTANTIATE(2, float)
DEM_INSTANTIATE(3, float)

}  // namespace dem
