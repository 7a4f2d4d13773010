// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
#include "bindings/f77/calls.hpp"

#include "bindings/f77/grids.hpp"
#include "bindings/f77/texts.hpp"

#include <algorithm>
#include <new>
#include <string>
#include <type_traits>

namespace hgrid::f77 {
namespace {

// What this layer refuses by itself; the rest is said by Error of the library.
struct Refusal {
  hg_status status;
  std::string text;
};

std::string &last_text() {
  thread_local std::string text;
  return text;
}

Grids &grids() {
  static Grids all;
  return all;
}

// Runs a call; no exception leaves, and what it throws is told by the error and HGFMSG.
template <class Body>
void run(const char *name, int32_t *error, Body &&body) noexcept {
  try {
    try {
      body();
      *error = HG_OK;
    } catch (const Refusal &refusal) {
      *error = refusal.status;
      last_text() = std::string(name) + ": " + refusal.text;
    } catch (const Error &failure) {
      *error = failure.status();
      last_text() = std::string(name) + ": " + translated(failure.what());
    }
  } catch (const std::bad_alloc &) {
    *error = HG_ERR_MEMORY;
    last_text().clear();
  } catch (const std::exception &) {
    *error = HG_ERR_INTERNAL;
    last_text().clear();
  }
}

std::shared_ptr<Numbered> living(int32_t number) {
  std::shared_ptr<Numbered> grid = grids().find(number);
  if (grid == nullptr) {
    throw Refusal{HG_ERR_NULL, "IH = " + std::to_string(number) + " is no grid: HGFNEW made none or HGFEND ended it"};
  }
  return grid;
}

size_t checked_size(const char *name, int32_t size) {
  if (size < 0) throw Refusal{HG_ERR_ARGUMENT, std::string(name) + " = " + std::to_string(size) + " is negative"};
  return static_cast<size_t>(size);
}

template <class Real>
hg_array column(const Real *numbers) {
  return {numbers, sizeof(Real), std::is_same_v<Real, float> ? HG_REAL32 : HG_REAL64, 0};
}

// Gives the particles to their grid and runs `query` on it.
template <class Real, class Query>
void on_particles(const Particles<Real> &given, Query &&query) {
  const std::shared_ptr<Numbered> numbered = living(*given.handle);
  const std::lock_guard lock(numbered->turn);
  const size_t count = checked_size("N", *given.count);
  const hg_array centers[3] = {column(given.x), column(given.y), column(given.z)}, radius = column(given.r);
  numbered->grid.set_arrays(count, centers, &radius);
  query(numbered->grid, count);
}

}  // namespace

void create(int32_t *handle, int32_t dimension, int32_t mode, double margin, const int32_t *periodic,
            const double *box_min, const double *box_max, int32_t *error) noexcept {
  *handle = 0;
  run("HGFNEW", error, [&] {
    hg_grid_def def = hg_default_grid_def();
    def.dimension = dimension;
    def.interaction = mode;
    def.margin = margin;
    def.index_base = 1;
    def.pair_order = HG_ORDER_ID;
    // In 2D the third entries need not be there, and boxes need hold nothing on open axes.
    for (int32_t axis = 0; axis < std::min(dimension, 3); axis++) {
      def.periodic[axis] = periodic[axis];
      if (periodic[axis] == 0) continue;
      def.box_min[axis] = box_min[axis];
      def.box_max[axis] = box_max[axis];
    }
    *handle = grids().add(std::make_shared<Numbered>(def));
    if (*handle == 0) throw Refusal{HG_ERR_LIMIT, "no numbers for grids are left"};
  });
}

template <class Real>
void pairs(const char *name, const Particles<Real> &particles, int32_t capacity, int32_t *count, int32_t *first,
           int32_t *second, int32_t *error) noexcept {
  *count = 0;
  run(name, error, [&] {
    on_particles(particles, [&](Grid &grid, size_t) {
      const size_t room = checked_size("MAXPR", capacity);
      const size_t found = grid.query_pairs().size();
      if (found > INT32_MAX) throw Refusal{HG_ERR_LIMIT, "more pairs than NPR can count"};
      *count = static_cast<int32_t>(found);
      grid.copy_pairs(room, first, second);
    });
  });
}

template <class Real>
void lists(const char *name, const Particles<Real> &particles, int32_t capacity, int32_t *point, int32_t *list,
           int32_t *error) noexcept {
  run(name, error, [&] {
    on_particles(particles, [&](Grid &grid, size_t count) {
      const size_t room = checked_size("MAXNB", capacity);
      const auto count_from_one = [&] { std::for_each(point, point + count + 1, [](int32_t &start) { start++; }); };
      try {
        grid.copy_neighbors(HG_HALF, room, point, list);
      } catch (const Error &failure) {
        if (failure.status() == HG_ERR_CAPACITY) count_from_one();
        throw;
      }
      count_from_one();
    });
  });
}

template void pairs(const char *, const Particles<double> &, int32_t, int32_t *, int32_t *, int32_t *,
                    int32_t *) noexcept;
template void pairs(const char *, const Particles<float> &, int32_t, int32_t *, int32_t *, int32_t *,
                    int32_t *) noexcept;
template void lists(const char *, const Particles<double> &, int32_t, int32_t *, int32_t *, int32_t *) noexcept;
template void lists(const char *, const Particles<float> &, int32_t, int32_t *, int32_t *, int32_t *) noexcept;

// The program's number becomes 0; a number that is refused may be a constant, and is not written to.
void end(int32_t *handle, int32_t *error) noexcept {
  run("HGFEND", error, [&] {
    living(*handle);
    grids().end(*handle);
    *handle = 0;
  });
}

void message(char *text, int32_t length) noexcept {
  if (length <= 0) return;
  const std::string &last = last_text();
  const size_t room = static_cast<size_t>(length), used = std::min(room, last.size());
  std::copy_n(last.data(), used, text);
  std::fill_n(text + used, room - used, ' ');
}

}  // namespace hgrid::f77
