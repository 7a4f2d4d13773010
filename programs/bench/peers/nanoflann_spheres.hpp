// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// nanoflann: the points around others, from one k-d tree.
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

namespace bench {

// Builds the tree. The call asks for the points nearer than `reach` to each of the queries, makes rows of what it finds
// and returns their length; points and queries are [count][3] and must outlive it.
std::function<size_t()> nanoflann_spheres(const std::vector<double> &points, double reach,
                                          const std::vector<double> &queries);

}  // namespace bench
