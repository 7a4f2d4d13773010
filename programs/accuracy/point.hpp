// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// What is measured of one setting of a parameter: how wrong it is and what it costs.
#pragma once

#include <string>

namespace accuracy {

// A setting with two kinds of error gives two points.
struct Point {
  std::string parameter;  // that is varied: the name of its study
  std::string system;     // on which it was measured
  std::string setting;
  std::string error_of;  // what `error` is the error of
  double error = 0;      // relative, >= 0; 0: none at all
  double cost = 0;       // ns per particle, and per step where there are steps
  bool is_default = false;
  std::string note;   // counts behind the error, for tables
  double number = 0;  // the setting as a number, where a law in it is expected
};

}  // namespace accuracy
