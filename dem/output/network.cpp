// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The network of contacts as VTK PolyData.
#include "dem/output/network.hpp"

#include "particles/files/vtk_array.hpp"
#include "particles/files/vtk_head.hpp"

namespace output {
namespace {

template <class Number>
void write_numbers(particles::Output &out, const char *name, const std::vector<dem::ContactLine> &lines,
                   Number dem::ContactLine::*number) {
  std::vector<Number> numbers;
  for (const dem::ContactLine &line : lines) numbers.push_back(line.*number);
  particles::write_vtk_array(out, name, 1, numbers);
}

}  // namespace

void write_network(const std::string &path, double time, const std::vector<dem::ContactLine> &lines) {
  std::vector<double> points;
  std::vector<int64_t> ids, ends;
  for (const dem::ContactLine &line : lines) {
    points.insert(points.end(), line.from, line.from + 3);
    points.insert(points.end(), line.to, line.to + 3);
    for (int k = 0; k < 2; k++) ids.push_back(static_cast<int64_t>(ids.size()));
    ends.push_back(static_cast<int64_t>(ids.size()));
  }
  particles::Output out(path);
  particles::begin_poly_data(out, &time, {2 * lines.size(), 0, lines.size(), 0});
  out << "<CellData Scalars=\"normal force\">";
  write_numbers(out, "normal force", lines, &dem::ContactLine::normal);
  write_numbers(out, "tangential force", lines, &dem::ContactLine::tangential);
  write_numbers(out, "overlap", lines, &dem::ContactLine::overlap);
  write_numbers(out, "a", lines, &dem::ContactLine::a);
  write_numbers(out, "b", lines, &dem::ContactLine::b);
  out << "</CellData><Points>";
  particles::write_vtk_array(out, "ends", 3, points);
  out << "</Points><Lines>";
  particles::write_vtk_array(out, "connectivity", 1, ids);
  particles::write_vtk_array(out, "offsets", 1, ends);
  out << "</Lines></Piece></PolyData></VTKFile>";
  out.close();
}

}  // namespace output
