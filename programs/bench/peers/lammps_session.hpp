// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// A LAMMPS that holds granular spheres, through its library.
#pragma once

#include "programs/bench/cell_array.hpp"

#include <cstdio>

namespace bench {

class LammpsSession {
 public:
  // A box of fixed faces around all particles, with as much room outside as the largest radius and a hundredth of the
  // box; the particles as atoms of style sphere, tag = index + 1. `screen` is the file that LAMMPS tells what it does,
  // and the error that it ends the process with; "none": nowhere.
  LammpsSession(const Particles &particles, const char *screen);
  ~LammpsSession();
  LammpsSession(const LammpsSession &) = delete;
  LammpsSession &operator=(const LammpsSession &) = delete;

  template <class... Values>
  void command(const char *format, Values... values) {
    char text[512];
    std::snprintf(text, sizeof text, format, values...);
    send(text);
  }

  // Atoms are brought into an order in space at the start of a run, and when lists are made after so many steps.
  void sort_atoms_every(int steps);

  // Half lists of pairs up to `skin` apart. collections: 0 for the style `bin`, else their number for `multi`; then
  // sizes must differ.
  void choose_neighbor_list(double skin, int collections);

  // Properties of the atoms, in the order of LAMMPS, which changes.
  const int *tags() const { return static_cast<const int *>(property("id")); }
  double **vectors(const char *name) const { return static_cast<double **>(property(name)); }
  double *scalars(const char *name) const { return static_cast<double *>(property(name)); }

  void *handle() const { return handle_; }

 private:
  void send(const char *text);
  void *property(const char *name) const;
  void create_box(const Particles &particles);
  void create_atoms(const Particles &particles);

  void *handle_ = nullptr;
  double smallest_, largest_;  // radius
  double sort_bin_ = 0;
};

}  // namespace bench
