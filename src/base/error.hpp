// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The one exception type of the core: a status and a text that names the offending index and value.
#pragma once

#include <hgrid/base.h>

#include <cstdarg>
#include <cstdio>
#include <exception>

namespace hg {

class Error : public std::exception {
 public:
  Error(hg_status status, const char *format, va_list arguments) noexcept : status_(status) {
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
  Error error(status, format, arguments);
  va_end(arguments);
  throw Error(error);
}

}  // namespace hg
