#!/bin/bash
# SPDX-FileCopyrightText: The libhgrid developers
# SPDX-License-Identifier: BSD-3-Clause
# The built command from end to end: command.sh HGRID VERSION. Counts come from closed forms of lattices and from a
# search of all pairs in awk, on coordinates that are multiples of 1/64, where doubles are exact.
hgrid=$(realpath "$1")
version=$2
scenes=$(realpath "$(dirname "${BASH_SOURCE[0]}")/../../scenes")
# shellcheck source=tests/support/checks.sh
. "$(dirname "${BASH_SOURCE[0]}")/../support/checks.sh"

# lattice M PARITY RADIUS: the points of an M x M x M block, all of them or those with an even sum of coordinates (fcc).
lattice() {
  awk -v m="$1" -v even="$2" -v r="$3" 'BEGIN {
    print "x,y,z,radius"
    for (i = 0; i < m; ++i) for (j = 0; j < m; ++j) for (k = 0; k < m; ++k)
      if (!even || (i + j + k) % 2 == 0) print i "," j "," k "," r
  }'
}

# scatter DIMENSION COUNT SEED: places and radii of very different sizes, multiples of 1/64.
scatter() {
  awk -v d="$1" -v n="$2" -v s="$3" -v CONVFMT=%.17g '
    function draw(limit) { s = (s * 16807) % 2147483647; return s % limit }
    BEGIN {
      print d == 3 ? "x,y,z,radius" : "x,y,radius"
      for (k = 0; k < n; ++k) {
        line = draw(640) / 64 "," draw(640) / 64
        if (d == 3) line = line "," draw(640) / 64
        print line "," (draw(20) == 0 ? draw(120) + 40 : draw(20) + 1) / 64
      }
    }'
}

# all_pairs FILE PERIODIC_LENGTH MARGIN: every pair of a file of scatter, sorted; length 0 means open.
all_pairs() {
  awk -F, -v box="$2" -v margin="$3" '
    NR == 1 { d = NF - 1; next }
    { for (c = 1; c <= d; ++c) x[NR - 2, c] = $c; r[NR - 2] = $NF; n = NR - 1 }
    END {
      for (a = 0; a < n; ++a) for (b = a + 1; b < n; ++b) {
        square = 0
        for (c = 1; c <= d; ++c) {
          e = x[a, c] - x[b, c]; if (e < 0) e = -e
          if (box > 0 && box - e < e) e = box - e
          square += e * e
        }
        reach = r[a] + r[b] + margin
        if (square < reach * reach) print a "," b
      }
    }' "$1" | sort
}

# image_pairs FILE XY XZ YZ: a line for each image in reach, sorted, in the periodic cell of edge 10 with this
# tilt; of a particle with itself one of each two opposite images.
image_pairs() {
  awk -F, -v xy="$2" -v xz="$3" -v yz="$4" '
    NR == 1 { d = NF - 1; next }
    { n = NR - 1; for (c = 1; c <= d; ++c) x[n - 1, c] = $c; r[n - 1] = $NF }
    END {
      far = d == 3 ? 2 : 0
      for (a = 0; a < n; ++a) for (b = a; b < n; ++b) for (k = -far; k <= far; ++k) {
        dz = d == 3 ? x[b, 3] - x[a, 3] + 10 * k : 0
        for (j = -2; j <= 2; ++j) {
          dy = x[b, 2] - x[a, 2] + 10 * j + yz * k
          for (i = -2; i <= 2; ++i) {
            if (a == b && !(k > 0 || k == 0 && (j > 0 || j == 0 && i > 0))) continue
            dx = x[b, 1] - x[a, 1] + 10 * i + xy * j + xz * k
            if (dx * dx + dy * dy + dz * dz < (r[a] + r[b]) ^ 2) print a "," b
          }
        }
      }
    }' "$1" | sort
}

test_lattices() {
  local m
  for m in 4 8; do
    lattice $m 1 0.71875 >fcc.csv
    lattice $m 0 0.5 >cubic.csv
    equal "open fcc $m" "$(contacts fcc.csv)" $((3 * m * (m - 1) * (m - 1)))
    equal "periodic fcc $m" "$(contacts fcc.csv --box 0,0,0,$m,$m,$m --periodic xyz)" $((6 * m * m * m / 2))
    equal "touching cubic $m" "$(contacts cubic.csv)" 0
    equal "touching cubic $m counted" "$(contacts cubic.csv --touching)" $((3 * m * m * (m - 1)))
    equal "cubic $m with margin" "$(contacts cubic.csv --margin 0.25)" $((3 * m * m * (m - 1)))
    equal "cubic $m, one axis periodic" "$(contacts cubic.csv --margin 0.25 --box 0,0,0,$m,$m,$m --periodic y)" \
      $((2 * m * m * (m - 1) + m * m * m))
  done
  lattice 4 0 1.25 >cubic.csv
  equal "maximal range" "$(contacts cubic.csv --max-range)" $((3 * 4 * 4 * 3))
  equal "particles counted" "$("$hgrid" pairs fcc.csv --count | awk '$1 == "particles" { print $2 }')" 256
  equal "contacts per particle" "$("$hgrid" pairs fcc.csv --count --box 0,0,0,8,8,8 --periodic xyz |
    awk '$1 == "contacts" && $2 == "per" { print $4 }')" 12
}

test_scattered() {
  local dimension seed=4711 options
  for dimension in 2 3; do
    scatter $dimension 400 $seed >set.csv
    all_pairs set.csv 0 0 >expected.txt
    [ "$(wc -l <expected.txt)" -gt 100 ] || fault "the set of seed $seed has too few contacts to tell anything"
    for options in "" "--threads 1" "--levels paper" "--level-count 1" "--accuracy double" "--cell-sizes 0.5,6"; do
      # shellcheck disable=SC2086
      "$hgrid" pairs set.csv $options | tail -n +2 | sort >found.txt
      cmp -s found.txt expected.txt || fault "${dimension}D, seed $seed, '$options': other pairs"
    done
    all_pairs set.csv 0 0.125 >expected.txt
    "$hgrid" pairs set.csv --margin 0.125 | tail -n +2 | sort >found.txt
    cmp -s found.txt expected.txt || fault "${dimension}D, seed $seed, with margin: other pairs"
  done
  all_pairs set.csv 10 0 >expected.txt
  { echo "# box: 0 0 0 10 10 10 periodic 1 1 1" && cat set.csv; } >boxed.csv
  "$hgrid" pairs boxed.csv | tail -n +2 | sort >found.txt
  cmp -s found.txt expected.txt || fault "periodic, seed $seed: other pairs"
  all_pairs set.csv 0 0 >expected.txt
  "$hgrid" pairs boxed.csv --open --output found.csv || fault "pairs --output"
  tail -n +2 found.csv | sort | cmp -s - expected.txt || fault "--open, seed $seed: other pairs"
}

# same_pairs WHAT EXPECTED ARGUMENTS...: hgrid pairs finds the lines of a file.
same_pairs() {
  local what=$1 expected=$2
  shift 2
  "$hgrid" pairs "$@" | tail -n +2 | sort | cmp -s - "$expected" || fault "$what, seed 815: other pairs"
}

test_tilted() {
  local tilted
  scatter 3 200 815 >set.csv
  image_pairs set.csv 2.5 -3.75 1.25 >all.txt
  image_pairs set.csv 0 0 0 | sort -u >upright.txt
  # Boxes are long enough for two particles to meet once, so these are their nearest images.
  sort -u all.txt >nearest.txt
  cmp -s nearest.txt upright.txt && fault "the set of seed 815 has the same pairs in both cells"
  { echo "# box: 0 0 0 10 10 10 periodic 1 1 1 tilt 2.5 -3.75 1.25" && cat set.csv; } >tilted.csv
  {
    printf '200\nLattice="10 0 0 2.5 10 0 -3.75 1.25 10" Properties=pos:R:3:radius:R:1\n'
    tail -n +2 set.csv | tr , ' '
  } >tilted.xyz
  {
    printf 'ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n200\nITEM: BOX BOUNDS xy xz yz pp pp pp\n'
    printf -- '-3.75 12.5 2.5\n0 11.25 -3.75\n0 10 1.25\nITEM: ATOMS x y z radius\n'
    tail -n +2 set.csv | tr , ' '
  } >tilted.dump
  for tilted in tilted.csv tilted.xyz tilted.dump "set.csv --box 0,0,0,10,10,10 --periodic xyz --tilt 2.5,-3.75,1.25"; do
    # shellcheck disable=SC2086
    same_pairs "$tilted" nearest.txt $tilted
  done
  same_pairs "all images" all.txt tilted.dump --images all
  same_pairs "without tilt" upright.txt tilted.csv --tilt 0,0,0
  all_pairs set.csv 0 0 >open.txt
  same_pairs "tilted, open" open.txt tilted.xyz --open
  "$hgrid" levels tilted.csv | grep -q "tilt 2.5 -3.75 1.25" || fault "levels does not tell the tilt"
  fails 1 "tilted.csv: the periodic box is tilted" slice tilted.csv --output slice.svg
  fails 1 "tilted.csv: HG_ERR_ARGUMENT: def.tilt[0] = 2.5" pairs tilted.csv --periodic yz
  # A cell that no grid takes, read for its particles only.
  sed 's/10 0 0 2.5 10/0 10 0 10 0/' tilted.xyz >turned.xyz
  same_pairs "turned, open" open.txt turned.xyz --open
  same_pairs "turned, another box" upright.txt turned.xyz --box 0,0,0,10,10,10
  sed 's/"10 0 0 2.5 10 0 -3.75 1.25 10"/"10 0 0 6e-16 10 0 -6e-16 6e-16 10"/' tilted.xyz >rounded.xyz
  same_pairs "rounded" upright.txt rounded.xyz
  "$hgrid" pairs rounded.xyz --periodic y >/dev/null || fault "rounded, with open axes"
  sed 's/ Properties/ pbc=F Properties/' tilted.xyz >closed.xyz
  same_pairs "tilted, made open" open.txt closed.xyz
  same_pairs "tilted, made periodic" nearest.txt closed.xyz --periodic xyz

  scatter 2 200 815 >plane.csv
  image_pairs plane.csv -4 0 0 | sort -u >nearest.txt
  same_pairs "a plane" nearest.txt plane.csv --box 0,0,10,10 --periodic xy --tilt -4
}

# The nearest neighbours of the simple cubic lattice, from one particle: 3 for each at the edge, 6 at the diagonal.
test_all_images() {
  printf 'x,y,z,r\n0,0,0,0.5\n' >one.csv
  equal "touching images" "$("$hgrid" pairs one.csv --box 0,0,0,1,1,1 --periodic xyz --images all --touching)" \
    "$(printf 'a,b\n0,0\n0,0\n0,0')"
  equal "images that just touch" "$("$hgrid" pairs one.csv --box 0,0,0,1,1,1 --periodic xyz --images all)" "a,b"
  equal "images at the diagonals" \
    "$("$hgrid" pairs one.csv --box 0,0,0,1,1,1 --periodic xyz --images all --margin 0.5 --count |
      awk '$1 == "contacts" { print $2 == "per" ? $4 : $2 }' | tr '\n' ' ')" "9 18 "
}

test_output() {
  printf 'x,y,z,r\n0,0,0,1\n1,0,0,1\n5,0,0,1\n1,1,0,1\n' >four.csv
  equal "ids from 0" "$("$hgrid" pairs four.csv --order id)" "$(printf 'a,b\n0,1\n0,3\n1,3')"
  equal "ids from 1" "$("$hgrid" pairs four.csv --order id --base 1)" "$(printf 'a,b\n1,2\n1,4\n2,4')"
  equal "standard input" "$("$hgrid" pairs - --order id <four.csv)" "$(printf 'a,b\n0,1\n0,3\n1,3')"
  equal "no particles" "$(printf 'x,y,z,r\n' | "$hgrid" pairs -)" "a,b"
  printf '3\nProperties=pos:R:3:radius:R:1\n0 0 0 1\n1 0 0 1\n5 0 0 1\n' >three.xyz
  equal "xyz" "$("$hgrid" pairs three.xyz)" "$(printf 'a,b\n0,1')"
  printf 'ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n2\nITEM: BOX BOUNDS pp pp pp\n0 8\n0 8\n0 8\n' >two.dump
  printf 'ITEM: ATOMS id xs ys zs diameter\n1 0.0625 0 0 2\n2 0.9375 0 0 2\n' >>two.dump
  equal "dump across the box" "$("$hgrid" pairs two.dump)" "$(printf 'a,b\n0,1')"
  equal "dump, open" "$("$hgrid" pairs two.dump --open)" "a,b"
}

# Columns that do not tell by their names, through the options for them.
test_columns() {
  local expected
  printf 'x,y,z,r\n0,0,0,1\n1.5,0,0,1\n5,0,0,3\n' >plain.csv
  expected=$("$hgrid" pairs plain.csv --order id)
  equal "three particles" "$expected" "$(printf 'a,b\n0,1\n1,2')"
  printf '0 0 0 1\n1.5 0 0 1\n5 0 0 3\n' >bare.txt
  printf 'A,B,C,size,kind\n0,0,0,1,1\n1.5,0,0,1,1\n5,0,0,3,two\n' >other.csv
  equal "--header" "$("$hgrid" pairs bare.txt --order id --header x,y,z,r)" "$expected"
  equal "--header, standard input" "$("$hgrid" pairs - --order id --header x,y,z,r <bare.txt)" "$expected"
  equal "--header instead" "$("$hgrid" pairs other.csv --order id --header 'x, y, z, r, type')" "$expected"
  equal "--radius" "$("$hgrid" pairs plain.csv --order id --radius R)" "$expected"
  equal "--diameter" "$("$hgrid" pairs plain.csv --order id --diameter r)" "$(printf 'a,b')"
  equal "--radius for all" "$("$hgrid" pairs plain.csv --order id --radius 2)" "$(printf 'a,b\n0,1\n1,2')"
  equal "--type-radius" \
    "$("$hgrid" pairs other.csv --order id --header x,y,z,size,type --type-radius 1=1,two=3)" "$expected"
  fails 1 "other.csv:4: no radius was given for the type 'two' but for '1'" \
    pairs other.csv --header x,y,z,size,type --type-radius 1=1
  fails 1 "plain.csv:1: no column 'size' among 'x, y, z, r'" pairs plain.csv --radius size
  fails 2 "--type-radius: 'one' is not a number" pairs plain.csv --type-radius 1=one
  fails 2 "--type-radius: '-1' is negative" pairs plain.csv --type-radius 1=-1
  fails 2 "--type-radius: '5' is not TYPE=RADIUS" pairs plain.csv --type-radius 5
  fails 2 "--type-radius: two radii for the type '1'" pairs plain.csv --type-radius 1=1,1=2
  fails 2 "excludes" pairs plain.csv --type-radius 1=1 --radius r
  fails 1 "<stdin>:1: neither the content nor the name tells what kind of file this is" pairs - <bare.txt
}

# nearest FILE XY XZ YZ: the pairs of nearest images with distance, overlap and shift, by a look at all images around,
# in the periodic cell of edge 10 with this tilt.
nearest() {
  awk -F, -v CONVFMT=%.17g -v xy="$2" -v xz="$3" -v yz="$4" '
    NR == 1 { next }
    { n = NR - 1; for (c = 1; c <= 3; ++c) x[n - 1, c] = $c; r[n - 1] = $NF }
    END {
      for (a = 0; a < n; ++a) for (b = a + 1; b < n; ++b) {
        least = 1e9
        for (i = -2; i <= 2; ++i) for (j = -1; j <= 1; ++j) for (k = -1; k <= 1; ++k) {
          dx = x[b, 1] - x[a, 1] + 10 * i + xy * j + xz * k
          dy = x[b, 2] - x[a, 2] + 10 * j + yz * k
          dz = x[b, 3] - x[a, 3] + 10 * k
          square = dx * dx + dy * dy + dz * dz
          if (square < least) { least = square; shift = i "," j "," k }
        }
        if (least < (r[a] + r[b]) ^ 2) print a "," b "," sqrt(least) "," r[a] + r[b] - sqrt(least) "," shift
      }
    }' "$1"
}

test_pair_columns() {
  printf 'x,y,z,r,ID,Species\n0,0,0,1,70,A\n1.5,0,0,1,8,"B"\n5,0,0,3,900,A\n' >named.csv
  equal "ids" "$("$hgrid" pairs named.csv --order id --columns id)" "$(printf 'id_a,id_b\n70,8\n8,900')"
  equal "types and places" "$("$hgrid" pairs named.csv --order id --base 1 --columns type,place)" \
    "$(printf 'type_a,type_b,a,b\nA,B,1,2\nB,A,2,3')"
  equal "distances" "$("$hgrid" pairs named.csv --order id --columns distance,overlap)" \
    "$(printf 'distance,overlap\n1.5,0.5\n3.5,0.5')"
  printf 'x,y,r\n0.5,5,1\n9.5,5,1\n' >plane.csv
  equal "a plane" "$("$hgrid" pairs plane.csv --box 0,0,10,10 --periodic x --columns place,distance,shift)" \
    "$(printf 'a,b,distance,shift_x,shift_y\n0,1,1,-1,0')"
  scatter 3 300 4711 >set.csv
  local tilt
  for tilt in 0,0,0 2.5,-3.75,1.25; do
    # shellcheck disable=SC2046
    nearest set.csv $(tr , ' ' <<<"$tilt") >expected.txt
    "$hgrid" pairs set.csv --order id --box 0,0,0,10,10,10 --periodic xyz --tilt $tilt \
      --columns place,distance,overlap,shift | tail -n +2 >found.txt
    [ "$(grep -vc ',0,0,0$' expected.txt)" -gt 20 ] || fault "too few contacts across the box"
    paste -d, expected.txt found.txt | awk -F, '
      function far(u, v) { return (u - v) ^ 2 > 1e-24 }
      $1 != $8 || $2 != $9 || far($3, $10) || far($4, $11) { print "line " NR; exit 1 }
      $5 != $12 || $6 != $13 || $7 != $14 { print "line " NR; exit 1 }
    ' || fault "tilt $tilt: other distances or shifts"
  done
  fails 1 "four.csv:1: no column 'id' among 'x, y, z, r'" pairs four.csv --columns id
  fails 1 "four.csv:1: no column type, species or element among 'x, y, z, r'" pairs four.csv --columns type
  fails 2 "--columns" pairs four.csv --columns weight
  # Each image of a particle alone, by opposite shifts once: those along the axes, and along the diagonals of a face.
  printf 'x,y,r\n0.25,0.5,0.75\n' >lone.csv
  equal "images of one" "$("$hgrid" pairs lone.csv --box 0,0,1,1 --periodic xy --images all --order id \
    --columns place,distance,shift | sed 's/1.41421356237309[0-9]*/root/')" \
    "$(printf 'a,b,distance,shift_x,shift_y\n0,0,root,-1,1\n0,0,1,0,1\n0,0,1,1,0\n0,0,root,1,1')"
}

# Files that do not tell everything: a note, unless the command line tells it.
test_notes() {
  {
    printf 'a title\n\n2 atoms\n1 atom types\n0 10 xlo xhi\n0 10 ylo yhi\n0 10 zlo zhi\n\nAtoms # sphere\n\n'
    printf '1 1 2 2500 0.5 5 5\n2 1 2 2500 9.5 5 5\n'
  } >two.data
  equal "open data file" "$("$hgrid" pairs two.data 2>note.txt)" "a,b"
  equal "its note" "$(cat note.txt)" \
    "hgrid: two.data: note: a LAMMPS data file does not tell which axes are periodic; all are taken as open"
  equal "periodic data file" "$("$hgrid" pairs two.data --periodic x 2>note.txt)" "$(printf 'a,b\n0,1')"
  equal "no note" "$(cat note.txt)" ""
  printf 'id,x,y,z,r,vx,vy,vz\n1,0,0,0,1,1,0,0\n2,5,0,0,1,0,0,0\n' >moving.csv
  printf '[[particles]]\nfile = "moving.csv"\n[contact]\nstiffness = 1e4\n[time]\nsteps = 1\n' >moving.toml
  "$hgrid" run moving.toml --quiet >/dev/null 2>note.txt || fault "run with velocities of a file: $(cat note.txt)"
  equal "what a run does not use" "$(cat note.txt)" \
    "hgrid: moving.toml: note: of its particle files these columns are not used: id"
  fails 2 "VTK legacy file is only read, never written" pack --count 10 --output pack.vtk
}

test_levels() {
  scatter 3 2000 99 >set.csv
  "$hgrid" levels set.csv >levels.txt || fault "levels"
  grep -q "2000 in 3 dimensions" levels.txt || fault "levels: the number of particles is missing"
  equal "levels: chosen" "$(grep -c 'chosen' levels.txt)" 1
  "$hgrid" levels set.csv --csv >levels.csv || fault "levels --csv"
  equal "levels: particles on all levels" "$(awk -F, 'NR > 1 { n += $4 } END { print n }' levels.csv)" 2000
  equal "levels: cells ascend and hold their particles" "$(awk -F, '
    NR > 1 { if ($2 <= last || 2 * $3 > $2 || $1 != NR - 1) print "line " NR; last = $2 }' levels.csv)" ""
  equal "levels: as many as the cost chosen" \
    "$("$hgrid" levels set.csv --csv --costs | awk -F, '$5 == 1 { print $1 }')" "$(($(wc -l <levels.csv) - 1))"
  equal "levels: the user's" "$("$hgrid" levels set.csv --cell-sizes 1,8 --csv | cut -d, -f2 | tr '\n' ' ')" \
    "cell_size 1 8 "
  equal "levels: one" "$("$hgrid" levels set.csv --levels paper --level-count 1 --csv | wc -l)" 2
}

test_failures() {
  fails 2 "COMMAND --help"
  fails 2 "'nosuch' is no command" nosuch
  fails 2 "FILE" pairs
  fails 2 "--margin: '-1' is negative" pairs four.csv --margin -1
  fails 2 "--margin: 'nan' is not finite" pairs four.csv --margin nan
  fails 2 "--frame: '0' is not a whole number" pairs four.csv --frame 0
  fails 2 "--accuracy" pairs four.csv --accuracy roughly
  fails 2 "--levels" pairs four.csv --levels auto --cell-sizes 4
  fails 2 "--box: 'one' is not a number" pairs four.csv --box 0,0,0,1,1,one
  fails 2 "--box: needs 6 numbers" pairs four.csv --box 0,0,1,1
  fails 2 "--periodic: the file holds no box" pairs four.csv --periodic x
  fails 2 "'w' is no axis" pairs four.csv --box 0,0,0,9,9,9 --periodic w
  fails 2 "--tilt: the file holds no box" pairs four.csv --tilt 1,0,0
  fails 2 "--tilt: needs 3 numbers" pairs four.csv --box 0,0,0,9,9,9 --tilt 1
  fails 2 "--images" pairs four.csv --images some
  printf '1\nLattice="4 1 0 0 4 0 0 0 4" Properties=pos:R:3:radius:R:1\n0 0 0 1\n' >turned.xyz
  fails 1 "hgrid: turned.xyz:2: the cell must be lower triangular" pairs turned.xyz
  fails 2 "--count" pairs four.csv --count --output x.csv
  fails 1 "missing.csv: cannot open" pairs missing.csv
  printf 'x,y,z,r\n0,0,0,1\n0,oops,0,1\n' >bad.csv
  fails 1 "hgrid: bad.csv:3: 'oops' in column 'y' is not a number" pairs bad.csv
  fails 1 "hgrid: bad.csv:3: 'oops' in column 'y' is not a number" levels bad.csv
  fails 1 "four.csv: HG_ERR_ARGUMENT" pairs four.csv --cell-sizes 0.5
  # The library refuses before or in the midst of the work: its status and text, and where it was.
  HGRID_ISA=none fails 1 "hgrid: four.csv: HG_ERR_ARGUMENT: HGRID_ISA = none:" pairs four.csv
  HGRID_ISA=none fails 1 "hgrid: HG_ERR_ARGUMENT: HGRID_ISA = none:" pack --count 10 --output pack.csv
  HGRID_ISA=none fails 1 "pack: HG_ERR_ARGUMENT: HGRID_ISA = none:" run "$scenes/gas.toml"
  fails 1 "no/such/folder.csv: cannot write" pairs four.csv --output no/such/folder.csv
  [ -e bad.out ] && fault "bad.out exists before its test"
  fails 1 "bad.csv:3:" pairs bad.csv --output bad.out
  [ -e bad.out ] && fault "an output was made for an input that was refused"
  return 0
}

test_broken_output() {
  local arguments code
  [ -e /dev/full ] || return 0
  for arguments in "pairs four.csv" "pairs four.csv --count" "levels four.csv" "levels four.csv --csv" "--help" "--version"; do
    # shellcheck disable=SC2086
    "$hgrid" $arguments >/dev/full 2>err.txt
    equal "exit code of '$arguments' on a full disk" $? 1
    grep -q "<stdout>: cannot write: No space left" err.txt || fault "'$arguments' on a full disk: $(cat err.txt)"
  done
  "$hgrid" pairs four.csv >&- 2>err.txt
  code=$?
  equal "exit code with a closed output" $code 1
  fails 1 "/dev/full: cannot write: No space left" pairs four.csv --output /dev/full
  # So many contacts that writing fails amid the search, inside a call of the library.
  lattice 8 0 0.5 >cubic.csv
  fails 1 "/dev/full: cannot write: No space left" pairs cubic.csv --margin 20 --output /dev/full
}

test_help() {
  local command
  equal "version" "$("$hgrid" --version | head -1)" "hgrid $version"
  "$hgrid" --version | grep -qxE 'threads: (yes|no)' || fault "--version does not tell threads"
  "$hgrid" --version | grep -qE '^instruction sets: scalar' || fault "--version does not tell instruction sets"
  for command in "" pairs levels pack bench slice; do
    # shellcheck disable=SC2086
    "$hgrid" $command --help >help.txt 2>err.txt || fault "$command --help fails"
    grep -q "Examples:" help.txt || fault "$command --help shows no example"
    [ -s err.txt ] && fault "$command --help writes on standard error"
  done
}

test_lattices
test_scattered
test_tilted
test_all_images
test_output
test_columns
test_pair_columns
test_notes
test_levels
test_failures
test_broken_output
test_help
finish "all checks passed"
