// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The boundary between C callers and the C++ core: no exception leaves, every failure has a status and a text.
#pragma once

#include "src/base/error.hpp"
#include "src/grid.hpp"

#include <hgrid/grid.h>

#include <initializer_list>
#include <new>

struct hg_grid {
  hg::Grid grid;
};

namespace hg {

// Stores the text that hg_last_error returns on this thread.
void remember_error(const char *text) noexcept;

// Where objects that are created now take their memory from.
hg_allocator current_allocator();

// Runs `body`; turns what it throws into a status.
template <class Body>
hg_status guarded(Body &&body) noexcept {
  try {
    body();
    return HG_OK;
  } catch (const Error &error) {
    remember_error(error.what());
    return error.status();
  } catch (const std::bad_alloc &) {
    remember_error("no memory");
    return HG_ERR_MEMORY;
  } catch (const std::exception &error) {
    remember_error(error.what());
    return HG_ERR_INTERNAL;
  } catch (...) {
    remember_error("an exception of unknown type");
    return HG_ERR_INTERNAL;
  }
}

// An object that callers hold by pointer, in memory of its own allocator. `construct` puts it into the memory given.
template <class Object, class Construct>
Object *make_object(Construct &&construct) {
  const hg_allocator allocator = current_allocator();
  void *memory = allocator.allocate(allocator.context, sizeof(Object));
  if (memory == nullptr) fail(HG_ERR_MEMORY, "no memory for %zu bytes", sizeof(Object));
  try {
    return construct(memory, allocator);
  } catch (...) {
    allocator.release(allocator.context, memory, sizeof(Object));
    throw;
  }
}

template <class Object>
void free_object(Object *object, const hg_allocator allocator) {
  object->~Object();
  allocator.release(allocator.context, object, sizeof(Object));
}

inline void check_pointer(const void *pointer, const char *name) {
  if (pointer == nullptr) fail(HG_ERR_NULL, "%s is NULL", name);
}

// An argument that must not be NULL: data or a function.
struct Needed {
  template <class T>
  Needed(T *pointer, const char *argument) : missing(pointer == nullptr), name(argument) {}
  bool missing;
  const char *name;
};

inline void check_pointers(std::initializer_list<Needed> arguments) {
  for (const Needed &argument : arguments) {
    if (argument.missing) fail(HG_ERR_NULL, "%s is NULL", argument.name);
  }
}

// Runs `body` on a grid that may be used now, with these arguments.
template <class Body>
hg_status on_grid(hg_grid *grid, std::initializer_list<Needed> arguments, Body &&body) noexcept {
  return guarded([&] {
    check_pointer(grid, "grid");
    if (grid->grid.is_visited()) fail(HG_ERR_STATE, "the grid is being visited: no call on it from its visitor");
    check_pointers(arguments);
    body(grid->grid);
  });
}

}  // namespace hg
