// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// How VTK's files in XML begin. They end with "</VTKFile>".
#pragma once

#include "particles/text/output.hpp"

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>

namespace particles {

// For a file of this type, such as "PolyData", whose numbers stand as this machine holds them.
inline std::string vtk_head(const std::string &type) {
  const uint16_t probe = 1;
  unsigned char first = 0;
  std::memcpy(&first, &probe, 1);
  const std::string byte_order = first == 1 ? "LittleEndian" : "BigEndian";
  return "<?xml version=\"1.0\"?><VTKFile type=\"" + type + "\" version=\"1.0\" byte_order=\"" + byte_order +
         "\" header_type=\"UInt64\">";
}

// Up to the arrays of its one piece; it ends with "</Piece></PolyData></VTKFile>". `time` may be NULL.
struct PolyDataCounts {
  size_t points, vertices, lines, polygons;
};
inline void begin_poly_data(Output &out, const double *time, const PolyDataCounts &counts) {
  out << vtk_head("PolyData") << "<PolyData>";
  if (time != nullptr) {
    out << "<FieldData><DataArray type=\"Float64\" Name=\"TimeValue\" NumberOfTuples=\"1\" format=\"ascii\">" << *time
        << "</DataArray></FieldData>";
  }
  out << "<Piece NumberOfPoints=\"" << counts.points << "\" NumberOfVerts=\"" << counts.vertices
      << "\" NumberOfLines=\"" << counts.lines << "\" NumberOfStrips=\"0\" NumberOfPolys=\"" << counts.polygons
      << "\">";
}

}  // namespace particles
