// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// All contacts of a state with their forces: what is measured of contacts is read off one after the other.
//
// Looking is rare, so one function serves all effects and picks each law as it goes; and a list of all that is known of
// each contact would be larger than the state.
#pragma once

#include "dem/effects/contact_force.hpp"
#include "dem/engine/engine.hpp"
#include "dem/state/boundary.hpp"
#include "dem/state/surface.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

namespace dem {

// Contacts of one kind and what they remember, by history_of(effect) and contact; empty without the effect.
template <int D>
struct ContactState {
  std::vector<hg_pair> list;
  std::array<std::vector<Vec<D, double>>, kHistoryCount> history;
};

// Of particles with surfaces of walls beside the box's, and where they touch what.
template <int D>
struct SurfaceState : ContactState<D> {
  std::vector<SurfaceTouch<D>> touches;
  std::vector<int32_t> walls;              // that the surfaces are of
  std::vector<uint8_t> materials;          // of the surfaces
  std::vector<Vec<D, double>> velocities;  // of their points
  std::vector<Spin<D, double>> spins;
};

// A contact of particles a and b, or of particle a with a wall, and what acts on a.
template <int D>
struct ContactLoad {
  static constexpr size_t kWall = static_cast<size_t>(-1);

  size_t a, b;
  Vec<D, double> normal;  // from a to b
  double overlap;         // below 0 within the range of adhesion
  double arm_a, arm_b;    // from the centres to where the forces act; 0 of a wall
  double reduced_radius;  // of a alone at a wall
  double smaller_radius;
  double image_speed;  // along x, that b has besides its own with the image that a meets
  int32_t wall = -1;   // of a wall beside the box's, which
  Vec<D, double> wall_velocity = Vec<D, double>::Zero();  // of a wall's surface there
  Spin<D, double> wall_spin = Spin<D, double>::Zero();    // and of the wall

  double spring, dashpot;                  // forces along the normal that push apart; adhesion is of the spring
  double stiffness, damping;               // of the spring and of the dashpot beside it
  double tangential_ratio, rolling_ratio;  // of springs along the surfaces
  Vec<D, double> tangential;               // force
  Vec<D, double> resistance;               // against rolling, a force at the reduced radius

  double elastic;            // energies
  double friction, rolling;  // of the springs along the surfaces

  Vec<D, double> force() const { return tangential - (spring + dashpot) * normal; }
};

template <int D>
using LoadVisit = std::function<void(const ContactLoad<D> &)>;

// `state` has the velocities that the forces of the engine saw; with them they are its forces of that moment. Pairs
// come first, then walls, each in the order of its list. Neighbours that are both fixed are no contacts.
template <int D>
void visit_loads(const Setup &setup, const Boundary<D, double> &boundary, const Snapshot &state,
                 const ContactState<D> &pairs, const ContactState<D> &walls, const SurfaceState<D> &surfaces,
                 const LoadVisit<D> &visit);

// The motion of the surfaces of a contact against each other.
template <int D>
struct SurfaceMotion {
  Vec<D, double> velocity;  // of a relative to b's image
  Vec<D, double> slip;      // of the surfaces
  Vec<D, double> roll;      // reduced radius x relative spin x normal
};
template <int D>
SurfaceMotion<D> surface_motion(const Snapshot &state, const ContactLoad<D> &load);

}  // namespace dem
