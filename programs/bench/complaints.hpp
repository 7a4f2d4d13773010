// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// What a process says on standard error, kept so that its end can be explained.
#pragma once

#include <cstdio>
#include <string>

namespace bench {

class Complaints {
 public:
  Complaints();
  ~Complaints();
  Complaints(const Complaints &) = delete;
  Complaints &operator=(const Complaints &) = delete;

  // From now on, standard error of this process goes here.
  void take();

  // ": " and the last line that tells of an error, or else the last line; "" if nothing was said. Without commas, for
  // the columns of a CSV.
  std::string reason() const;

 private:
  std::FILE *file_;
};

}  // namespace bench
