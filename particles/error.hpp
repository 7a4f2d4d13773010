// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The one exception of all that stands on the library: a text ready to be shown after the name of a program.
#pragma once

#include <hgrid/hgrid.hpp>

#include <cstddef>
#include <stdexcept>
#include <string>

namespace particles {

class Error : public std::runtime_error {
 public:
  explicit Error(const std::string &message) : std::runtime_error(message) {}

  // A fault in a file; line 0 means the file as a whole.
  Error(const std::string &file, size_t line, const std::string &message)
      : std::runtime_error(file + ":" + (line > 0 ? std::to_string(line) + ":" : "") + " " + message) {}
};

// What an exception says to the user: a failure of the library also tells its status.
inline std::string message_of(const std::exception &error) {
  const auto *failure = dynamic_cast<const hgrid::Error *>(&error);
  return (failure != nullptr ? hg_status_string(failure->status()) + std::string(": ") : "") + error.what();
}

}  // namespace particles
