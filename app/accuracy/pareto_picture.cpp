// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause

// Layout and style of the picture of trades. Lengths without a unit named are pixels.
#include "accuracy/pareto_picture.hpp"

#include "accuracy/ten_times.hpp"
#include "draw/svg.hpp"

namespace accuracy {

std::string pareto_picture(const std::vector<Knob> &, const std::vector<TradePoint> &) {
  const draw::Svg svg(100, 100);
  return svg.document();
}

}  // namespace accuracy
