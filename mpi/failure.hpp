// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The one exception type of this layer: a status and a text. It stands on the public interface of the core alone.
#pragma once

#include <hgrid/base.h>

#include <mpi.h>

#include <cstdarg>
#include <cstdio>
#include <exception>

namespace hgrid::mpi {

class Failure : public std::exception {
 public:
  Failure(hg_status status, const char *format, va_list arguments) noexcept : status_(status) {
    std::vsnprintf(text_, sizeof text_, format, arguments);
  }
  hg_status status() const noexcept { return status_; }
  const char *what() const noexcept override { return text_; }

 private:
  hg_status status_;
  char text_[256];  // no allocation: the cause may be that there is no memory
};

[[noreturn, gnu::format(printf, 2, 3)]] inline void fail(hg_status status, const char *format, ...) {
  va_list arguments;
  va_start(arguments, format);
  Failure failure(status, format, arguments);
  va_end(arguments);
  throw Failure(failure);
}

// What a call of the core returned.
inline void check(hg_status status) {
  if (status != HG_OK) fail(status, "%s", hg_last_error());
}

// What a call of MPI returned.
inline void check_mpi(int code, const char *call) {
  if (code == MPI_SUCCESS) return;
  char text[MPI_MAX_ERROR_STRING + 1] = "";
  int length = 0;
  MPI_Error_string(code, text, &length);
  fail(HG_ERR_MPI, "%s: %.200s", call, text);
}

inline void check_pointer(const void *pointer, const char *name) {
  if (pointer == nullptr) fail(HG_ERR_NULL, "%s is NULL", name);
}

}  // namespace hgrid::mpi
