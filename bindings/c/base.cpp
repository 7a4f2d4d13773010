// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The functions of include/hgrid/base.h: texts, version, allocator.
#include "bindings/c/guard.hpp"

#include <hgrid/base.h>

#include <cstdio>
#include <mutex>

namespace hg {
namespace {

thread_local char last_error[256] = "";

std::mutex allocator_mutex;
hg_allocator allocator_of_new_grids = system_allocator();

}  // namespace

void remember_error(const char *text) noexcept { std::snprintf(last_error, sizeof last_error, "%s", text); }

hg_allocator current_allocator() {
  const std::lock_guard lock(allocator_mutex);
  return allocator_of_new_grids;
}

}  // namespace hg

const char *hg_status_string(hg_status status) {
  switch (status) {
    case HG_OK:
      return "HG_OK";
    case HG_ERR_NULL:
      return "HG_ERR_NULL";
    case HG_ERR_ARGUMENT:
      return "HG_ERR_ARGUMENT";
    case HG_ERR_MEMORY:
      return "HG_ERR_MEMORY";
    case HG_ERR_CAPACITY:
      return "HG_ERR_CAPACITY";
    case HG_ERR_STATE:
      return "HG_ERR_STATE";
    case HG_ERR_NOT_FOUND:
      return "HG_ERR_NOT_FOUND";
    case HG_ERR_LIMIT:
      return "HG_ERR_LIMIT";
    case HG_ERR_INTERNAL:
      return "HG_ERR_INTERNAL";
    case HG_ERR_MPI:
      return "HG_ERR_MPI";
    case HG_ERR_REMOTE:
      return "HG_ERR_REMOTE";
    default:
      return "unknown status";
  }
}

const char *hg_last_error(void) { return hg::last_error; }

void hg_set_last_error(const char *text) { hg::remember_error(text != nullptr ? text : ""); }

void hg_version(int *major, int *minor, int *patch) {
  if (major != nullptr) *major = HG_VERSION_MAJOR;
  if (minor != nullptr) *minor = HG_VERSION_MINOR;
  if (patch != nullptr) *patch = HG_VERSION_PATCH;
}

hg_status hg_set_allocator(const hg_allocator *allocator) {
  return hg::guarded([&] {
    if (allocator != nullptr) {
      hg::check_pointers({{allocator->allocate, "allocator->allocate"},
                          {allocator->reallocate, "allocator->reallocate"},
                          {allocator->release, "allocator->release"}});
    }
    const std::lock_guard lock(hg::allocator_mutex);
    hg::allocator_of_new_grids = allocator != nullptr ? *allocator : hg::system_allocator();
  });
}
