// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Files as people have them: the table of docs/guide/command.md, with a file for each of its rows.
#include "tests/particles/page.hpp"
#include "tests/particles/reading.hpp"
#include "tests/support/frame.h"

#include <cstdio>
#include <string>

using test::reads;
using test::refuses;
using test::set_of;
using test::with_box;
using test::with_tilt;

namespace {

struct Case {
  const char *what, *result;
  bool (*holds)();
};

particles::ParticleSet one() { return set_of(3, {1, 2, 3}, {0.5}); }

particles::ParticleSet boxed(const int (&periodic)[3]) { return with_box(one(), {0, 0, 0}, {4, 5, 6}, periodic); }

std::string xyz(const std::string &keys) { return "1\n" + keys + " Properties=pos:R:3:radius:R:1\n1 2 3 0.5\n"; }

std::string dump(const std::string &columns, const std::string &row) {
  return "ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n1\nITEM: BOX BOUNDS ff ff ff\n0 4\n0 5\n0 6\nITEM: ATOMS " +
         columns + "\n" + row + "\n";
}

template <class Set>
bool reads_with(const std::string &text, const particles::ParticleSet &expected, Set set) {
  particles::ReadOptions options;
  set(options);
  return reads(".any", text, expected, options);
}

const Case kCases[] = {
    {"`# x y z r` before rows of numbers (numpy.savetxt)", "names the columns",
     [] { return reads(".any", "# x y z r\n1 2 3 0.5\n", one()); }},
    {"`#format x_y_z_r` (Yade), also with `_attrs`", "names the columns",
     [] {
       return reads(".any", "#format x_y_z_r\n1\t2\t3\t0.5\n", one()) &&
              reads(".any", "#format x_y_z_r_attrs\n1\t2\t3\t0.5\t8\t9\n", one());
     }},
    {"rows of numbers without names", "refused, unless `--header x,y,z,r` names the columns",
     [] {
       return refuses(".csv", "1,2,3,0.5\n",
                      "1: the first line must name the columns (such as x,y,z,radius), but it holds '1,2,3,0.5'") &&
              reads_with("1 2 3 0.5\n", one(), [](auto &options) {
                options.header = {"x", "y", "z", "r"};
              });
     }},
    {"numbers with a D for the exponent (1.0D-3)", "read as with an e",
     [] {
       return reads(".csv", "x,y,z,r\n1D0,2,0.3D1,5d-1\n", one()) &&
              reads(".any", dump("x y z radius", "1D0 2 3 0.5"), boxed({0, 0, 0}));
     }},
    {"names of columns and keys in upper case", "the same; of two that differ in case the exact one counts",
     [] {
       return reads(".csv", "X,Y,Z,RADIUS\n1,2,3,0.5\n", one()) && reads(".csv", "x,y,z,r,R\n1,2,3,0.5,9\n", one()) &&
              reads(".any", dump("X Y Z Radius", "1 2 3 0.5"), boxed({0, 0, 0})) &&
              reads(".any", "1\nPROPERTIES=POS:R:3:Radius:R:1\n1 2 3 0.5\n", one());
     }},
    {"`radii`, `c_radius`, `v_radius`, `f_radius`, `d_radius`", "a radius",
     [] {
       return reads(".csv", "x,y,z,radii\n1,2,3,0.5\n", one()) &&
              reads(".any", dump("x y z c_radius", "1 2 3 0.5"), boxed({0, 0, 0})) &&
              reads(".any", dump("x y z v_radius", "1 2 3 0.5"), boxed({0, 0, 0})) &&
              reads(".any", dump("x y z f_radius", "1 2 3 0.5"), boxed({0, 0, 0})) &&
              reads(".any", dump("x y z d_radius", "1 2 3 0.5"), boxed({0, 0, 0}));
     }},
    {"radius and diameter", "the radius, if the diameter is twice as long within 1 %, else refused",
     [] {
       return reads(".csv", "x,y,z,radius,diameter\n1,2,3,0.5,1\n", one()) &&
              refuses(".csv", "x,y,z,radius,diameter\n1,2,3,0.5,0.5\n",
                      "2: the radius '0.5' is not half of the diameter '0.5': say which column to take (--radius or "
                      "--diameter)");
     }},
    {"a size under another name", "`--radius NAME`, `--diameter NAME`; the same for all: `--radius 0.5`",
     [] {
       return reads_with("x,y,z,c_1\n1,2,3,0.5\n", one(), [](auto &options) { options.radius = "c_1"; }) &&
              reads_with("x,y,z,c_1\n1,2,3,1\n", one(), [](auto &options) { options.diameter = "c_1"; }) &&
              reads_with("x,y,z\n1,2,3\n", one(), [](auto &options) { options.radius = "0.5"; });
     }},
    {"a size by type only", "`--type-radius 1=0.5,2=0.1`; a type without radius is refused",
     [] {
       return reads_with(dump("id type x y z", "1 2 1 2 3"), boxed({0, 0, 0}),
                         [](auto &options) {
                           options.type_radii = {{"2", 0.5}};
                         }) &&
              reads_with("1\nplain XYZ\nFe 1 2 3\n", one(), [](auto &options) {
                options.type_radii = {{"Fe", 0.5}};
              });
     }},
    {"free text among the keys of extended XYZ", "passed over",
     [] {
       return reads(".any", xyz("i =    0, E =   -3.5 it's \"free\" text t=1 T=2 note=\"a \\\" b\" f={1 2}"), one());
     }},
    {"`Lattice = \"...\"`, in quotes of both kinds, braces or brackets", "the box",
     [] {
       return reads(".any", xyz("Lattice = \"4 0 0 0 5 0 0 0 6\""), boxed({1, 1, 1})) &&
              reads(".any", xyz("Lattice='4 0 0 0 5 0 0 0 6'"), boxed({1, 1, 1})) &&
              reads(".any", xyz("Lattice={4 0 0 0 5 0 0 0 6}"), boxed({1, 1, 1})) &&
              reads(".any", xyz("Lattice=[[4, 0, 0], [0, 5, 0], [0, 0, 6]]"), boxed({1, 1, 1}));
     }},
    {"`pbc=T`, `pbc=[T, F, F]`", "one flag for all axes, or one for each",
     [] {
       return reads(".any", xyz("Lattice=\"4 0 0 0 5 0 0 0 6\" pbc=T"), boxed({1, 1, 1})) &&
              reads(".any", xyz("Lattice=\"4 0 0 0 5 0 0 0 6\" pbc=[T, F, F]"), boxed({1, 0, 0}));
     }},
    {"a Lattice with off-diagonals up to 1e-12 of its longest edge", "rectangular: they are rounding",
     [] {
       return reads(".any", xyz("Lattice=\"4 6e-16 0 6e-16 5 0 0 -6e-16 6\""), boxed({1, 1, 1}));
     }},
    {"a cell turned in space", "refused, unless `--box` or `--open` is given",
     [] {
       return refuses(".xyz", xyz("Lattice=\"0 4 0 5 0 0 0 0 6\""),
                      "2: the cell must be lower triangular ('ax 0 0 bx by 0 cx cy cz'), but the Lattice is "
                      "'0 4 0 5 0 0 0 0 6'") &&
              reads_with(xyz("Lattice=\"0 4 0 5 0 0 0 0 6\" pbc=F"), one(),
                         [](auto &options) { options.needs_box = false; });
     }},
    {"a LAMMPS data file", "its box; which axes are periodic it does not tell: `--periodic`",
     [] {
       return reads(".any",
                    "title\n\n1 atoms\n0 4 xlo xhi\n0 5 ylo yhi\n0 6 zlo zhi\n\nAtoms # sphere\n\n1 1 1 2500 1 2 3\n",
                    boxed({0, 0, 0}));
     }},
    {"a UTF-8 mark, line ends CR LF or CR alone", "passed over in every format",
     [] {
       return reads(".any", "\xEF\xBB\xBF# x y z r\r\n1 2 3 0.5\r\n", one()) &&
              reads(".any", "\xEF\xBB\xBF" + xyz(""), one()) && reads(".any", "x,y,z,r\r1,2,3,0.5\r", one()) &&
              reads(".any", "\xEF\xBB\xBF" + dump("x y z radius", "1 2 3 0.5"), boxed({0, 0, 0}));
     }},
    {"text after the last row", "refused; blank lines are passed over",
     [] {
       return reads(".any", xyz("") + "\n \n", one()) && reads(".any", "x,y,z,r\n1,2,3,0.5\n\n", one()) &&
              refuses(".csv", "x,y,z,r\n1,2,3,0.5\nend\n", "3: 1 values in 'end' where there should be 4") &&
              refuses(".xyz", xyz("") + "end\n", "4: the number of particles should stand here, not 'end'");
     }},
};

bool every_case_holds() {
  bool all = true;
  for (const Case &each : kCases) {
    const bool told = test::page_has(HGRID_COMMAND_PAGE, std::string("| ") + each.what + " | " + each.result + " |\n");
    if (told && each.holds()) continue;
    std::fprintf(stderr, "case: %s\n", each.what);
    all = false;
  }
  return all;
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {cmocka_unit_test(passes<every_case_holds>)};
  return cmocka_run_group_tests_name("file_cases", tests, nullptr, nullptr);
}
