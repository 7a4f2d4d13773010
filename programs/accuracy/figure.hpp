// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// What the picture of a group of studies shows: a line for each knob, over axes that all share.
#pragma once

#include "programs/accuracy/point.hpp"

#include <string>
#include <vector>

namespace accuracy {

struct Knob {
  const char *question;             // what one decides with it
  std::vector<std::string> answer;  // what its error is and on which system: short lines
  bool (*holds)(const Point &point);
  std::string (*label)(const Point &point);
  double times = 1;  // its cost in the unit of the picture
};

struct Figure {
  const char *title;  // the question that it answers
  const char *cost;   // unit of the vertical axis
  std::vector<Knob> knobs;
};

inline std::string setting_of(const Point &point) { return point.setting; }
inline std::string system_of(const Point &point) { return point.system; }

}  // namespace accuracy
