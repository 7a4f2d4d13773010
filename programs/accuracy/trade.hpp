// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// What is measured of a setting that trades accuracy for time: how wrong it is and what it costs.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace accuracy {

// One setting of one knob on one system. A setting with two kinds of error gives two points.
struct TradePoint {
  std::string knob;
  std::string system;
  std::string setting;
  std::string error_of;  // what `error` is the error of
  double error = 0;      // relative, >= 0; 0: none at all
  double cost = 0;       // ns per particle, and per step where there are steps
  bool is_default = false;
  std::string note;   // counts behind the error, for tables
  double number = 0;  // the setting as a number, where a law in it is expected
};

// How much to measure.
struct Budget {
  size_t timed_count = 50000;  // particles of a system that is timed
  size_t truth_count = 10000;  // particles of a system that is compared with the truth pair by pair
  int repeats = 15;            // runs of each setting, in turns; the median counts
  bool quick = false;          // few systems and settings: to try it out
};

// Told what is about to be measured.
using Progress = std::function<void(const std::string &what)>;

struct Knob {
  const char *name;   // for --knob: one word
  const char *title;  // for tables and pictures
  const char *about;  // what is varied, what the error and the cost are: full sentences
  std::vector<TradePoint> (*measure)(const Budget &budget, const Progress &progress);
};

}  // namespace accuracy
