// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause

// Tables of measured trades: as text, as Markdown and as CSV.
#ifndef APP_ACCURACY_REPORT_HPP
#define APP_ACCURACY_REPORT_HPP

#include "accuracy/trade.hpp"

#include <string>
#include <vector>

namespace accuracy {

enum class Style { kText, kMarkdown };

// A table for each knob, and the one of what ten times more accuracy costs.
std::string report(const std::vector<Knob> &knobs, const std::vector<TradePoint> &points, Style style);

// One line per point: knob,system,setting,error_of,error,ns,is_default,note.
void write_csv(const std::string &path, const std::vector<TradePoint> &points);

}  // namespace accuracy

#endif
