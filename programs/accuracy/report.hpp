// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Tables of measured trades, as text and as Markdown.
#pragma once

#include "programs/accuracy/trade.hpp"

#include <string>
#include <vector>

namespace accuracy {

enum class Style { kText, kMarkdown };

// Rows of cells, the first the heads of the columns.
std::string table_of(const std::vector<std::vector<std::string>> &rows, Style style);
std::string heading(const std::string &title, Style style);

// A table for each knob, and the one of what ten times more accuracy costs.
std::string report(const std::vector<Knob> &knobs, const std::vector<TradePoint> &points, Style style);

}  // namespace accuracy
