// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Reading files of VTK in text: what is accepted, and the message for each thing that is not. vtk_files.py has the
// binary ones.
#include "tests/particles/reading.hpp"
#include "tests/support/frame.h"

using test::of_dimension;
using test::of_frame;
using test::reads;
using test::refuses;
using test::refuses_each;
using test::set_of;

namespace {

particles::ParticleSet two() { return set_of(3, {1, 2, 3, 0, 1, 2}, {0.5, 0.25}); }

const std::string kHead = "# vtk DataFile Version 3.0\nspheres\nASCII\nDATASET POLYDATA\n";
const std::string kPoints = "POINTS 2 float\n1 2 3 0\n1 2\n";

bool reads_legacy_files() {
  return reads(".vtk", kHead + kPoints + "POINT_DATA 2\nSCALARS radius double 1\nLOOKUP_TABLE default\n0.5\n0.25\n",
               two()) &&
         reads(".any",
               "# vtk DataFile Version 2.0\r\nspheres\r\nASCII\r\nDATASET UNSTRUCTURED_GRID\r\nPOINTS 2 double\r\n1 2 "
               "3\r\n0 1 2\r\n"
               "CELLS 2 4\r\n1 0\r\n1 1\r\nCELL_TYPES 2\r\n1\r\n1\r\nCELL_DATA 2\r\nSCALARS radius float\r\n8 9\r\n"
               "POINT_DATA 2\r\nVECTORS velocity float\r\n7 7 7 7 7 7\r\nSCALARS Diameter float\r\n1\r\n0.5\r\n",
               two()) &&
         reads(
             ".any",
             "# vtk DataFile Version 5.1\nspheres\nASCII\nDATASET POLYDATA\nPOINTS 2 float\n1 2 3 0 1 2\n"
             "METADATA\nINFORMATION 0\n\nVERTICES 3 2\nOFFSETS vtktypeint64\n0 1 2\nCONNECTIVITY vtktypeint64\n0 1\n"
             "POINT_DATA 2\nFIELD FieldData 2\nradii 1 2 float\n0.5 0.25\nMETADATA\nINFORMATION 0\n\nid 1 2 int\n4 5\n",
             two()) &&
         reads(".any",
               kHead + "FIELD FieldData 1\nTIME 1 1 double\n3\n" + kPoints +
                   "POINT_DATA 2\nCOLOR_SCALARS c 2\n1 0 0 1\n"
                   "SCALARS r float\nLOOKUP_TABLE mine\n.5 .25\nLOOKUP_TABLE mine 1\n0 0 0 1\n",
               two());
}

std::string xml(const std::string &data, const std::string &points = "1 2 3\n0 1 2") {
  return "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" byte_order=\"LittleEndian\">\n<PolyData>\n"
         "<Piece NumberOfPoints=\"2\">\n<Points><DataArray type=\"Float32\" NumberOfComponents=\"3\" "
         "format=\"ascii\">" +
         points + "</DataArray></Points>\n<PointData>" + data + "</PointData></Piece></PolyData></VTKFile>\n";
}

std::string array(const std::string &name, const std::string &values, const std::string &format = "ascii") {
  return "<DataArray type=\"Float64\" Name=\"" + name + "\" format=\"" + format + "\">" + values + "</DataArray>\n";
}

bool reads_xml() {
  particles::ReadOptions size;
  size.radius = "size";
  return reads(".vtp", xml(array("radius", "0.5 0.25")), two()) &&
         reads(".any", xml(array("Diameter", "\n1\n0.5\n")), two()) &&
         reads(".any", xml(array("id", "3 4") + array("size", ".5 .25")), two(), size) &&
         reads(".any", xml(array("radius", "0.5 0.25"), "1 2 7 0 1 7"), set_of(2, {1, 2, 0, 1}, {0.5, 0.25}),
               of_dimension(2));
}

bool refuses_bad_legacy_files() {
  return refuses_each(".vtk",
                      {{"# vtk DataFile Version 3.0\nt\nASCII\nDATASET STRUCTURED_POINTS\n",
                        "4: DATASET POLYDATA or UNSTRUCTURED_GRID should stand here, not 'dataset structured_points'"},
                       {"# vtk DataFile Version 3.0\nt\nTEXT\n", "4: ASCII or BINARY should stand above, not 'text'"},
                       {kHead + "POINTS two float\n", "5: 'two' is not the number of what follows"},
                       {kHead + "POINTS 99999 float\n1 2 3\n", "5: '99999' is not the number of what follows"},
                       {kHead + "POINTS 2 float\n1 2 3 4 5 six\n", "6: 'six' is not a number"},
                       {kHead + "POINTS 2 quad\n1 2 3 4 5 6\n", "5: the type 'quad' is unknown"},
                       {kHead + kPoints + "SPHERES 2\n", "8: the section 'spheres' is unknown"},
                       {kHead, "5: the file holds no POINTS"},
                       {kHead + kPoints + "POINT_DATA 2\nSCALARS id int\n4 5\n",
                        " no column radius, r, diameter or d among 'x, y, z, id'"},
                       {kHead + kPoints + "POINT_DATA 2\nSCALARS radius float\n1 -2\n",
                        "point:2: '-2' in column 'radius' is negative"}}) &&
         refuses(".vtk", kHead + kPoints, " frame 2 of a VTK file, which has only one", of_frame(2));
}

bool refuses_bad_xml() {
  return refuses_each(".vtp",
                      {{xml(array("radius", "0.5 big")), " 'big' in the array 'radius' is not a number"},
                       {xml(array("radius", "0.5")), " no column radius, r, diameter or d among 'x, y, z'"},
                       {xml(array("radius", "AAAA", "binary")), " the array 'radius' ends before 4 bytes"},
                       {xml(array("radius", "", "appended")), " the array 'radius' ends before 4 bytes"},
                       {xml(array("radius", "", "zipped")), " the array 'radius' has the unknown format 'zipped'"},
                       {"<VTKFile type=\"ImageData\"/>",
                        " the file holds neither PolyData nor UnstructuredGrid but 'ImageData'"},
                       {"<VTKFile compressor=\"vtkLZ4DataCompressor\"><PolyData/></VTKFile>",
                        " data packed by 'vtkLZ4DataCompressor' are not read; write them with zlib or as they are"}}) &&
         refuses(".vtp", xml(""), " frame 2 of a VTK file, which has only one", of_frame(2));
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(passes<reads_legacy_files>),
      cmocka_unit_test(passes<reads_xml>),
      cmocka_unit_test(passes<refuses_bad_legacy_files>),
      cmocka_unit_test(passes<refuses_bad_xml>),
  };
  return cmocka_run_group_tests_name("vtk_reader", tests, nullptr, nullptr);
}
