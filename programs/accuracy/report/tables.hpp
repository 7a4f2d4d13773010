// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Tables of measured points, as text and as Markdown.
#pragma once

#include "programs/accuracy/study.hpp"

#include <string>
#include <vector>

namespace accuracy {

enum class Style { kText, kMarkdown };

// Rows of cells, the first the heads of the columns.
std::string table_of(const std::vector<std::vector<std::string>> &rows, Style style);
std::string heading(const std::string &title, Style style);

// The points of a study: a row for each setting of each system.
std::string study_table(const Study &study, const std::vector<Point> &points, Style style);

// What ten times more accuracy costs, from setting to setting.
std::string digit_cost_table(const std::vector<Point> &points, Style style);

}  // namespace accuracy
