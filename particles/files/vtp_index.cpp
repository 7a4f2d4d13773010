// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The index of VTK PolyData in several files, in XML. Arrays stand in the order of vtp.cpp.
#include "particles/files/vtp_index.hpp"

#include "particles/files/vtk_head.hpp"
#include "particles/text/output.hpp"

namespace particles {
namespace {

void write_array(Output &out, const std::string &name, size_t width) {
  out << "<PDataArray type=\"Float64\" Name=\"" << name << "\" NumberOfComponents=\"" << width << "\"/>";
}

}  // namespace

void write_vtp_index(const std::string &path, const ParticleSet &part, const std::vector<std::string> &pieces) {
  Output out(path);
  out << vtk_head("PPolyData") << "<PPolyData GhostLevel=\"0\"><PPointData Scalars=\"radius\">";
  write_array(out, "radius", 1);
  for (const size_t width : {size_t{1}, size_t{3}}) {
    for (const Column &column : part.columns)
      if (column.width == width) write_array(out, column.name, width);
  }
  out << "</PPointData><PPoints>";
  write_array(out, "centers", 3);
  out << "</PPoints>";
  for (const std::string &piece : pieces) out << "<Piece Source=\"" << piece << "\"/>";
  out << "</PPolyData></VTKFile>";
  out.close();
}

}  // namespace particles
