// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// All contacts of a state with their forces.
#include "dem/engine/contact_loads.hpp"

#include "dem/effects/choice.hpp"

#include <algorithm>
#include <cmath>

namespace dem {
namespace {

template <int D>
using Vector = Vec<D, double>;

// The effects that a normal force has.
constexpr EffectSet kNormalEffects = kContactEffects & ~effects_with_history();

struct Spring {
  NormalForce<double> force;
  double energy;
};

template <EffectSet E>
Spring spring_of(const ContactLaw<double> &law, const NormalContact<double> &contact) {
  const NormalForce<double> force = normal_force<E>(law, contact);
  return {force, elastic_energy<E>(law, contact, force)};
}

size_t material_of(const Snapshot &state, size_t i) { return state.material_ids.empty() ? 0 : state.material_ids[i]; }

template <int D>
Spin<D, double> spin_of(const Snapshot &state, size_t i) {
  if (state.spins.empty()) return Spin<D, double>::Zero();
  return vector_at<Spin<D, double>>(state.spins, i);
}

// The law's forces on the contact that the load describes so far.
template <int D>
class Forces {
 public:
  explicit Forces(const Setup &setup)
      : effects_(setup.effects),
        spring_(
            choose<kNormalEffects, double>(setup.effects, [](auto set) { return &spring_of<decltype(set)::value>; })) {}

  void set(const ContactLaw<double> &law, const NormalContact<double> &contact, const Snapshot &state,
           const ContactState<D> &contacts, size_t p, ContactLoad<D> &load) const {
    const Spring spring = spring_(law, contact);  // of surfaces at rest
    const SurfaceMotion<D> motion = surface_motion(state, load);
    const NormalForce<double> &force = spring.force;
    load.spring = force.value;
    load.dashpot = has(effects_, kDissipation) ? force.damping * motion.velocity.dot(load.normal) : 0;
    load.stiffness = force.stiffness;
    load.damping = force.damping;
    load.tangential_ratio = law.tangential_ratio;
    load.rolling_ratio = law.rolling_ratio;
    load.elastic = spring.energy;
    load.tangential = load.resistance = Vector<D>::Zero();
    load.friction = load.rolling = 0;
    if (has(effects_, kFriction)) {
      load.tangential = along(contacts, kFriction, p, load, motion.slip, law.tangential_ratio, force,
                              law.friction * force.spring, load.friction);
    }
    if (has(effects_, kRolling)) {
      load.resistance = along(contacts, kRolling, p, load, motion.roll, law.rolling_ratio, force,
                              law.rolling * force.spring, load.rolling);
    }
  }

 private:
  // The force of a spring along the surfaces that is stretched as the contact remembers, and its energy.
  static Vector<D> along(const ContactState<D> &contacts, Effect effect, size_t p, const ContactLoad<D> &load,
                         const Vector<D> &velocity, double ratio, const NormalForce<double> &normal, double limit,
                         double &energy) {
    const auto &stretches = contacts.history[history_of(effect)];
    Vector<D> stretch = Vector<D>::Zero();
    if (!stretches.empty()) stretch = stretches[p];
    energy = 0.5 * ratio * normal.stiffness * stretch.squaredNorm();
    const Vector<D> tangent = velocity - load.normal * load.normal.dot(velocity);
    Vector<D> force;
    slider_force<D>(Slider<double>{ratio * normal.stiffness, ratio * normal.damping, limit}, load.normal.data(),
                    tangent.data(), 0.0, stretch.data(), force.data());
    return force;
  }

  EffectSet effects_;
  Spring (*spring_)(const ContactLaw<double> &, const NormalContact<double> &);
};

template <int D>
void visit_pairs(const Setup &setup, const Boundary<D, double> &boundary, const Snapshot &state,
                 const ContactState<D> &contacts, const LoadVisit<D> &visit) {
  const LawTable<double> laws(setup, Partner::kParticle);
  const Forces<D> forces(setup);
  const auto nearest = choose<kImageEffects, double>(
      setup.effects, [](auto set) { return &Boundary<D, double>::template nearest<decltype(set)::value>; });
  for (size_t p = 0; p < contacts.list.size(); p++) {
    const auto a = static_cast<size_t>(contacts.list[p].a), b = static_cast<size_t>(contacts.list[p].b);
    // Neighbours in a wall of fixed particles may overlap as they like: nothing comes of it.
    if (!std::isfinite(state.masses[a]) && !std::isfinite(state.masses[b])) continue;
    ContactLoad<D> load;
    Vector<D> separation = vector_at<Vector<D>>(state.centers, b) - vector_at<Vector<D>>(state.centers, a);
    load.a = a;
    load.b = b;
    load.image_speed = (boundary.*nearest)(separation);
    const double radius = state.radii[a], other = state.radii[b];
    load.overlap = radius + other - normalize<D>(separation, load.normal);
    load.arm_a = radius - load.overlap / 2;
    load.arm_b = other - load.overlap / 2;
    load.smaller_radius = std::min(radius, other);
    const ContactLaw<double> &law = laws.at(material_of(state, a), material_of(state, b));
    const NormalContact<double> contact{load.overlap, 0, 1 / state.masses[a] + 1 / state.masses[b],
                                        1 / radius + 1 / other, law.share[0] / radius + law.share[1] / other};
    load.reduced_radius = 1 / contact.inverse_radius;
    forces.set(law, contact, state, contacts, p, load);
    visit(load);
  }
}

template <int D>
void visit_walls(const Setup &setup, const Boundary<D, double> &boundary, const Snapshot &state,
                 const ContactState<D> &contacts, const LoadVisit<D> &visit) {
  const LawTable<double> laws(setup, Partner::kWall);
  const Forces<D> forces(setup);
  for (size_t p = 0; p < contacts.list.size(); p++) {
    const auto i = static_cast<size_t>(contacts.list[p].a);
    const int32_t wall = contacts.list[p].b;
    const double radius = state.radii[i];
    ContactLoad<D> load;
    load.a = i;
    load.b = ContactLoad<D>::kWall;
    load.normal = (is_upper(wall) ? 1.0 : -1.0) * Vector<D>::Unit(axis_of(wall));
    load.overlap = wall_overlap(boundary, state.centers[i * D + static_cast<size_t>(axis_of(wall))], radius, wall);
    load.arm_a = radius - load.overlap;
    load.arm_b = load.image_speed = 0;
    load.reduced_radius = load.smaller_radius = radius;
    const NormalContact<double> contact{load.overlap, 0, 1 / state.masses[i], 1 / radius, 1 / radius};
    forces.set(laws.at(material_of(state, i), boundary.materials[wall]), contact, state, contacts, p, load);
    visit(load);
  }
}

template <int D>
void visit_surfaces(const Setup &setup, const Snapshot &state, const SurfaceState<D> &contacts,
                    const LoadVisit<D> &visit) {
  const LawTable<double> laws(setup, Partner::kWall);
  const Forces<D> forces(setup);
  for (size_t p = 0; p < contacts.list.size(); p++) {
    const auto i = static_cast<size_t>(contacts.list[p].a);
    const NearestPoint<D> &nearest = contacts.touches[p].nearest;
    const double radius = state.radii[i];
    ContactLoad<D> load;
    load.a = i;
    load.b = ContactLoad<D>::kWall;
    load.normal = nearest.normal;
    load.overlap = radius - nearest.distance;
    load.arm_a = nearest.distance;
    load.arm_b = load.image_speed = 0;
    load.reduced_radius = load.smaller_radius = radius;
    load.wall = contacts.walls[p];
    load.wall_velocity = contacts.velocities[p];
    load.wall_spin = contacts.spins[p];
    const NormalContact<double> contact{load.overlap, 0, 1 / state.masses[i], 1 / radius, 1 / radius};
    forces.set(laws.at(material_of(state, i), contacts.materials[p]), contact, state, contacts, p, load);
    visit(load);
  }
}

}  // namespace

template <int D>
SurfaceMotion<D> surface_motion(const Snapshot &state, const ContactLoad<D> &load) {
  SurfaceMotion<D> motion;
  const bool wall = load.b == ContactLoad<D>::kWall;
  const Spin<D, double> spin = spin_of<D>(state, load.a);
  const Spin<D, double> other = wall ? load.wall_spin : spin_of<D>(state, load.b);
  motion.velocity = vector_at<Vector<D>>(state.velocities, load.a);
  motion.velocity -= wall ? load.wall_velocity : Vector<D>(vector_at<Vector<D>>(state.velocities, load.b));
  motion.velocity[0] -= load.image_speed;
  const Spin<D, double> turning = load.arm_a * spin + load.arm_b * other, difference = spin - other;
  motion.slip = motion.velocity + turn<D, double>(turning, load.normal);
  motion.roll = load.reduced_radius * turn<D, double>(difference, load.normal);
  return motion;
}

template <int D>
void visit_loads(const Setup &setup, const Boundary<D, double> &boundary, const Snapshot &state,
                 const ContactState<D> &pairs, const ContactState<D> &walls, const SurfaceState<D> &surfaces,
                 const LoadVisit<D> &visit) {
  visit_pairs(setup, boundary, state, pairs, visit);
  visit_walls(setup, boundary, state, walls, visit);
  if (!surfaces.list.empty()) visit_surfaces(setup, state, surfaces, visit);
}

#define DEM_INSTANTIATE(D)                                                                                         \
  template SurfaceMotion<D> surface_motion(const Snapshot &, const ContactLoad<D> &);                              \
  template void visit_loads(const Setup &, const Boundary<D, double> &, const Snapshot &, const ContactState<D> &, \
                            const ContactState<D> &, const SurfaceState<D> &, const LoadVisit<D> &);

DEM_INSTANTIATE(2)
DEM_INSTANTIATE(3)

}  // namespace dem
