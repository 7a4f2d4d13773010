// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Reading extended XYZ: what is accepted, and the message for each thing that is not.
#include "tests/particles/reading.hpp"
#include "tests/support/frame.h"

using test::of_frame;
using test::reads;
using test::refuses;
using test::refuses_each;
using test::set_of;
using test::with_box;
using test::with_tilt;

namespace {

const std::string kProperties = "Properties=species:S:1:pos:R:3:radius:R:1";
const std::string kRows = "A 1 2 3 0.5\nB 0 1 2 0.25\n";

particles::ParticleSet two() { return set_of(3, {1, 2, 3, 0, 1, 2}, {0.5, 0.25}); }

bool reads_properties() {
  return reads(".xyz", "2\n" + kProperties + "\n" + kRows, two()) &&
         reads(".xyz",
               " 2 \r\nTime=1.5 properties=diameter:R:1:velo:R:3:pos:R:3 note=\"a b = c\" done\r\n"
               "1 9 9 9 1 2 3\r\n.5 9 9 9 0 1 2\r\n",
               two()) &&
         reads(".xyz", "1\nProperties=pos:R:2:radius:R:1\n1 2 0.5\n", set_of(2, {1, 2}, {0.5}));
}

bool reads_the_box() {
  const std::string lattice = "Lattice=\"4 0 0 0 5 0 0 0 6\" ";
  return reads(".xyz", "2\n" + lattice + kProperties + "\n" + kRows,
               with_box(two(), {0, 0, 0}, {4, 5, 6}, {1, 1, 1})) &&
         reads(".xyz", "2\n" + lattice + "Origin=\"-1 0 2\" pbc=\"T F 1\" " + kProperties + "\n" + kRows,
               with_box(two(), {-1, 0, 2}, {3, 5, 8}, {1, 0, 1})) &&
         reads(".xyz", "2\nLattice=\"4 0 0 -0.5 5 0 1 2 6\" Origin=\"-1 0 2\" " + kProperties + "\n" + kRows,
               with_tilt(with_box(two(), {-1, 0, 2}, {3, 5, 8}, {1, 1, 1}), {-0.5, 1, 2})) &&
         reads(".xyz", "2\npbc=\"F F F\" " + kProperties + "\n" + kRows, two());
}

bool reads_the_frame_asked_for() {
  const std::string text = "1\n" + kProperties + "\nA 0 0 0 1\n1\n" + kProperties + "\nA 0 0 0 2\n\n";
  return reads(".xyz", text, set_of(3, {0, 0, 0}, {2})) &&
         reads(".xyz", text, set_of(3, {0, 0, 0}, {1}), of_frame(1)) &&
         refuses(".xyz", text, "7: frame 3 of a file with 2", of_frame(3));
}

// One particle, described by these keys and the properties.
std::string one_with(const std::string &keys) { return "1\n" + keys + " " + kProperties + "\nA 0 0 0 1\n"; }

bool passes_over_free_text() {
  for (const char *text : {"i =        0, time =       0.000, E =       -35.25", "made by hand, don't trust it",
                           "= = ==", "Energy=1 energy=2 ENERGY=3", "t=1 t=2", R"(note="a \"quoted\" word" path='C:\\')",
                           "'two words'=3", "f={1 {2} 3} g=[[1, 2], [3]] h=[]", "\"free\" 'text'"}) {
    if (!reads(".xyz", one_with(text), set_of(3, {0, 0, 0}, {1}))) {
      std::fprintf(stderr, "with the text %s\n", text);
      return false;
    }
  }
  return true;
}

bool reads_every_writing_of_the_box() {
  const particles::ParticleSet upright = with_box(set_of(3, {0, 0, 0}, {1}), {0, 0, 0}, {4, 5, 6}, {1, 0, 0});
  for (const char *keys :
       {R"(Lattice = "4 0 0 0 5 0 0 0 6" pbc = "T F F")", "Lattice='4 0 0 0 5 0 0 0 6' pbc='T F F'",
        "Lattice={4 0 0 0 5 0 0 0 6} pbc={T F F}", "lattice=[4, 0, 0, 0, 5, 0, 0, 0, 6] PBC=[T, F, F]",
        "Lattice=[[4, 0, 0], [0, 5, 0], [0, 0, 6]] pbc=[true,false,false]",
        "Lattice=\"4D0,0,0,0,5,0,0,0,6\" pbc=\"1 0 0\"", "Lattice=\"4 6e-16 0 -6e-16 5 0 3e-16 3e-16 6\" pbc=\"T F F\"",
        "Lattice=\"4 0 0 0 5 0 0 0 6\" LATTICE=none pbc=\"T F F\" Pbc=3"}) {
    if (!reads(".xyz", one_with(keys), upright)) {
      std::fprintf(stderr, "with the keys %s\n", keys);
      return false;
    }
  }
  return reads(".xyz", one_with("Lattice=\"4 0 0 0 5 0 0 0 6\" pbc=T"),
               with_box(set_of(3, {0, 0, 0}, {1}), {0, 0, 0}, {4, 5, 6}, {1, 1, 1})) &&
         reads(".xyz", one_with("Lattice=\"4 0 0 1e-9 5 0 0 0 6\" pbc=[F]"),
               with_tilt(with_box(set_of(3, {0, 0, 0}, {1}), {0, 0, 0}, {4, 5, 6}, {0, 0, 0}), {1e-9, 0, 0}));
}

bool passes_over_a_turned_box() {
  particles::ReadOptions options;
  options.needs_box = false;
  particles::ParticleSet one = set_of(3, {0, 0, 0}, {1});
  one.periodic[0] = 1;
  return reads(".xyz", one_with("Lattice=\"0 4 0 4 0 0 0 0 6\" pbc=\"T F F\""), one, options) &&
         reads(".xyz", one_with("pbc=\"T F F\""), one, options);
}

bool reads_the_size_asked_for() {
  particles::ReadOptions types, names, number;
  types.type_radii = {{"A", 0.5}, {"B", 0.25}};
  names.header = {"id", "x", "y", "z", "r"};
  number.radius = "2";
  return reads(".xyz", "2\na comment\nA 1 2 3\nB 0 1 2\n", two(), types) &&
         reads(".xyz", "2\n\nA 1 2 3\nB 0 1 2\n", set_of(3, {1, 2, 3, 0, 1, 2}, {2, 2}), number) &&
         reads(".xyz", "2\na comment\n" + kRows, two(), names) &&
         reads(".xyz", "2\nProperties=mass:R:5\n1 1 2 3 0.5\n1 0 1 2 .25\n", two(), names) &&
         reads(".xyz", "2\nProperties=species:S:1:POS:R:3:Radii:R:1\n" + kRows, two());
}

bool refuses_bad_boxes() {
  return refuses_each(
      ".xyz", {{one_with("Lattice=\"4 1 0 0 5 0 0 0 6\""),
                "2: the cell must be lower triangular ('ax 0 0 bx by 0 cx cy cz'), but the Lattice is "
                "'4 1 0 0 5 0 0 0 6'"},
               {one_with("Lattice=\"4 0 0 0 5 1e-9 0 0 6\""),
                "2: the cell must be lower triangular ('ax 0 0 bx by 0 cx cy cz'), but the Lattice is "
                "'4 0 0 0 5 1e-9 0 0 6'"},
               {one_with("Lattice=\"4 0 0\""), "2: Lattice must hold 9 numbers, but it is '4 0 0'"},
               {one_with("Lattice=\"4 0 0 0 5 0 0 0 inf\""), "2: Lattice: 'inf' is not finite"},
               {one_with("Lattice=\"4 0 0 0 5 0 0 0 -6\""), "2: the Lattice '4 0 0 0 5 0 0 0 -6' has a negative edge"},
               {one_with("pbc=\"T F F\""), "2: pbc has a periodic axis, but there is no Lattice"},
               {one_with("Lattice=[4, 0, 0"), "2: the bracket after 'Lattice' does not end"},
               {one_with("pbc=\"T F\""), "2: pbc must hold three flags, or one for all axes, but it is 'T F'"},
               {one_with("pbc=\"F F maybe\""), "2: pbc: the flag 'maybe' is neither T nor F"}});
}

bool refuses_bad_keys() {
  return refuses_each(
      ".xyz",
      {{"1\nplain\nA 0 0 0 1\n", "2: no Properties=... that names pos and radius"},
       {"1\nProperties=species:S:1:pos:R:3\nA 0 0 0\n",
        "2: no column radius, r, diameter or d among 'species, x, y, z'"},
       {"1\nProperties=species:S:1:radius:R:1\nA 1\n", "2: Properties 'species:S:1:radius:R:1' does not name pos"},
       {"1\nProperties=pos:R:three\nA 1\n", "2: Properties must be name:type:columns:..., but it is 'pos:R:three'"},
       {"1\nProperties=pos:R:4:radius:R:1\nA 1\n", "2: pos must have 2 or 3 columns, not '4'"},
       {one_with("note=\"open"), "2: the quote after 'note' does not end"},
       {one_with("Pbc=T PBC=F"), "2: the key 'pbc' is given twice"}});
}

const std::string kHead = "2\n" + kProperties + "\nA 1 2 3 0.5\n";

bool refuses_a_frame_that_is_cut() {
  const std::string message = "3: the file ends here with 1 of 2 particles";
  return refuses(".xyz", kHead, message) && refuses(".xyz", kHead, message, of_frame(1));
}

bool refuses_bad_rows() {
  return refuses_each(
      ".xyz", {{kHead + "A 1 2 x3 0.5\n", "4: 'x3' in column 'z' is not a number"},
               {kHead + "A 1 2 3 -.5\n", "4: '-.5' in column 'radius' is negative"},
               {kHead + "A 1 2 3\n", "4: 4 values in 'A 1 2 3' where there should be 5"},
               {kHead + "A 1 2 3 1\nA 1 2 3 1\n", "5: the number of particles should stand here, not 'A 1 2 3 1'"},
               {"99999999999999999999\n" + kProperties + "\n",
                "1: the number of particles should stand here, not '99999999999999999999'"},
               {"2\n", "1: the file ends here, the line of keys is missing"}});
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(passes<reads_properties>),          cmocka_unit_test(passes<reads_the_box>),
      cmocka_unit_test(passes<reads_the_frame_asked_for>), cmocka_unit_test(passes<refuses_bad_boxes>),
      cmocka_unit_test(passes<passes_over_free_text>),     cmocka_unit_test(passes<reads_every_writing_of_the_box>),
      cmocka_unit_test(passes<passes_over_a_turned_box>),  cmocka_unit_test(passes<reads_the_size_asked_for>),
      cmocka_unit_test(passes<refuses_bad_keys>),          cmocka_unit_test(passes<refuses_a_frame_that_is_cut>),
      cmocka_unit_test(passes<refuses_bad_rows>),
  };
  return cmocka_run_group_tests_name("xyz_reader", tests, nullptr, nullptr);
}
