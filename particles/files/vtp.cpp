// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// VTK PolyData in XML, for ParaView: one vertex per particle with its radius and further columns. Numbers are stored as
// the machine holds them, in base64.
#include "particles/files/format.hpp"
#include "particles/files/vtk_array.hpp"
#include "particles/files/vtk_head.hpp"
#include "particles/text/output.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace particles {
namespace {

// Numbers come before vectors.
void write_columns(Output &out, const ParticleSet &particles) {
  out << "<PointData Scalars=\"radius\">";
  write_vtk_array(out, "radius", 1, particles.radii);
  for (const size_t width : {size_t{1}, size_t{3}}) {
    for (const Column &column : particles.columns)
      if (column.width == width) write_vtk_array(out, column.name, width, column.values);
  }
  out << "</PointData>";
}

void write_vertices(Output &out, size_t count) {
  std::vector<int64_t> ids(count), ends(count);
  for (size_t i = 0; i < count; i++) {
    ids[i] = static_cast<int64_t>(i);
    ends[i] = static_cast<int64_t>(i + 1);
  }
  out << "<Verts>";
  write_vtk_array(out, "connectivity", 1, ids);
  write_vtk_array(out, "offsets", 1, ends);
  out << "</Verts>";
}

}  // namespace

void write_vtp(Output &out, const ParticleSet &particles) {
  const size_t count = particles.count();
  begin_poly_data(out, particles.moment ? &particles.moment->time : nullptr, {count, count, 0, 0});
  write_columns(out, particles);
  out << "<Points>";
  write_vtk_array(out, "centers", 3, in_three_dimensions(particles.centers, particles.dimension));
  out << "</Points>";
  write_vertices(out, count);
  out << "</Piece></PolyData></VTKFile>";
}

}  // namespace particles
