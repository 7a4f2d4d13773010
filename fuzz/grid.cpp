// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Fuzzes the C interface: a definition, then any sequence of calls, checked against a plain list in exact arithmetic.
#include "fuzz/bytes.hpp"
#include "fuzz/expect.hpp"
#include "fuzz/grid_model.hpp"
#include "tests/support/compare.hpp"

#include <hgrid/hgrid.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <vector>

namespace {

using fuzz::Bytes;
using fuzz::expect;
using fuzz::GridModel;
using oracle::Pairs;
using Particles = particles::ParticleSet;

constexpr size_t kMostParticles = 16;  // more only cost time: every pair is decided in rational numbers
constexpr int kMostCalls = 24;

// Whether the library takes the call. A refusal must be one of those the header names, and say why.
template <class Call>
bool takes(Call call) {
  try {
    call();
    return true;
  } catch (const hgrid::Error &error) {
    expect(error.status() == HG_ERR_ARGUMENT || error.status() == HG_ERR_LIMIT, "a refusal with an unexpected status");
    expect(error.what()[0] != '\0', "a refusal without a text");
    return false;
  }
}

void draw_box(Bytes &bytes, hg_grid_def &def) {
  for (int k = 0; k < 3; k++) {
    if (def.periodic[k] == 0) continue;
    def.box_min[k] = bytes.number();
    def.box_max[k] = def.box_min[k] + 8 * bytes.length();
  }
}

// Mostly where there are two periodic axes: parts of a length, many lengths, anything.
void draw_tilt(Bytes &bytes, hg_grid_def &def) {
  constexpr int kAxes[3][2] = {{0, 1}, {0, 2}, {1, 2}};
  for (int k = 0; k < 3; k++) {
    const int along = kAxes[k][0], other = kAxes[k][1];
    const int kind = bytes.below(8);
    if (kind == 0) {
      def.tilt[k] = bytes.number();
    } else if (kind < 6 && other < def.dimension && def.periodic[along] + def.periodic[other] == 2) {
      const double parts = kind < 5 ? 0.0625 : 1;
      def.tilt[k] = parts * static_cast<int8_t>(bytes.byte()) * (def.box_max[along] - def.box_min[along]);
    } else {
      def.tilt[k] = 0;
    }
  }
}

// What any box must have that the library takes.
bool is_box(const hg_grid_def &def) {
  constexpr int kAxes[3][2] = {{0, 1}, {0, 2}, {1, 2}};
  for (int k = 0; k < def.dimension; k++) {
    if (def.periodic[k] == 0) continue;
    if (!std::isfinite(def.box_min[k]) || !std::isfinite(def.box_max[k]) || def.box_min[k] >= def.box_max[k])
      return false;
  }
  for (int k = 0; k < 3; k++) {
    const int along = kAxes[k][0], other = kAxes[k][1];
    if (def.tilt[k] == 0) continue;
    if (other >= def.dimension || def.periodic[along] + def.periodic[other] != 2) return false;
    if (!(std::fabs(def.tilt[k]) <= 0x1p20 * (def.box_max[along] - def.box_min[along]))) return false;
  }
  return true;
}

hg_grid_def draw_definition(Bytes &bytes, double (&cells)[HG_MAX_LEVELS]) {
  hg_grid_def def = hg_default_grid_def();
  def.dimension = 2 + bytes.below(2);
  def.thread_count = 1;
  def.index_base = bytes.below(2);
  def.interaction = bytes.below(2);
  def.accuracy = bytes.below(4) % 3;
  def.pair_order = bytes.below(2);
  def.level_rule = bytes.below(3);
  def.level_count = bytes.below(8);
  if (bytes.below(3) == 0) def.margin = bytes.length();
  if (bytes.below(3) == 0) def.skin = bytes.length();
  if (bytes.below(8) == 0) def.cell_overhead = bytes.number();
  const int axes = bytes.below(16);
  for (int k = 0; k < 3; k++) def.periodic[k] = axes >> k & 1;
  draw_box(bytes, def);
  if (axes >= 8) {
    draw_tilt(bytes, def);
    def.touching = bytes.below(2);
    def.images = bytes.below(2);
  }
  if (def.level_rule == HG_LEVELS_USER) {
    for (int h = 0; h < def.level_count; h++) cells[h] = (h > 0 ? cells[h - 1] : 0) + bytes.length();
    def.cell_sizes = cells;
  }
  return def;
}

class Session {
 public:
  Session(Bytes &bytes, const hg_grid_def &def) : bytes_(bytes), def_(def), model_(def), grid_(def) {}

  void run() {
    for (int call = 0; call < kMostCalls && !bytes_.empty(); call++) {
      switch (bytes_.below(14)) {
        case 0:
        case 1:
        case 2:
          insert();
          break;
        case 3:
        case 4:
          move();
          break;
        case 5:
          remove();
          break;
        case 6:
          visit();
          break;
        case 7:
          ask_neighbors();
          break;
        case 8:
          ask_spheres();
          break;
        case 9:
          look_inside();
          break;
        case 10:
          if (bytes_.below(4) == 0) {
            clear();
          } else {
            set_box();
          }
          break;
        case 11:
          ask_shapes();
          break;
        case 12:
          change_company();
          break;
        default:
          ask_pairs();
      }
    }
    ask_pairs();
  }

 private:
  void insert() {
    Particles batch;
    batch.dimension = def_.dimension;
    const int count = bytes_.below(8);
    for (int i = 0; i < count && model_.size() + batch.count() < kMostParticles; i++) {
      double center[3];
      for (int k = 0; k < def_.dimension; k++) center[k] = bytes_.number();
      batch.add(center, bytes_.length());
    }
    const Particles all = model_.particles_and(batch);
    if (takes([&] { grid_.insert(batch.count(), batch.centers.data(), batch.radii.data()); })) {
      expect(GridModel::may_hold(def_, all), "bad particles are taken");
      model_.insert(batch);
    } else {
      expect(!GridModel::must_hold(def_, all), "good particles are refused");
    }
  }

  void move() {
    Particles moved = model_.particles();
    const bool radii = bytes_.below(3) == 0;
    const int changes = bytes_.below(16);
    for (int i = 0; i < changes && !moved.centers.empty(); i++) {
      double &x = moved.centers[bytes_.byte() % moved.centers.size()];
      x = bytes_.below(2) == 0 ? bytes_.number() : x + bytes_.number();
      if (radii) moved.radii[bytes_.byte() % moved.radii.size()] = bytes_.length();
    }
    if (radii && changes % 2 == 1) {
      set(moved);
    } else if (takes([&] { grid_.move(moved.count(), moved.centers.data(), radii ? moved.radii.data() : nullptr); })) {
      expect(GridModel::may_hold(def_, moved), "a bad move is taken");
      model_.move(moved.centers, radii ? &moved.radii : nullptr);
    } else {
      expect(!GridModel::must_hold(def_, moved), "a good move is refused");
    }
  }

  // Particles with ids that start anew, from columns.
  void set(const Particles &particles) {
    hg_array centers[3];
    for (int k = 0; k < def_.dimension; k++) {
      const double *first = particles.count() > 0 ? particles.centers.data() + k : nullptr;
      centers[k] = {first, static_cast<int64_t>(sizeof(double)) * def_.dimension, HG_REAL64, 0};
    }
    const hg_array radius = {particles.radii.data(), sizeof(double), HG_REAL64, 0};
    if (takes([&] { grid_.set_arrays(particles.count(), centers, &radius); })) {
      expect(GridModel::may_hold(def_, particles), "a bad set is taken");
      model_.set(particles);
    } else {
      expect(!GridModel::must_hold(def_, particles), "a good set is refused");
    }
  }

  void remove() {
    std::vector<int32_t> ids;
    const int count = bytes_.below(6);
    for (int i = 0; i < count; i++) {
      const bool known = bytes_.below(8) != 0 && model_.size() > 0;
      ids.push_back(known ? model_.ids()[bytes_.byte() % model_.size()] : static_cast<int8_t>(bytes_.byte()));
    }
    const hg_status status = hgtest::status_of([&] { grid_.remove(ids.size(), ids.data()); });
    expect(status == HG_OK || status == HG_ERR_NOT_FOUND, "hg_remove gives an unexpected status");
    expect(model_.remove(ids) == (status == HG_OK), "hg_remove takes wrong ids, or refuses right ones");
  }

  void clear() {
    grid_.clear();
    model_.clear();
  }

  // Other groups or bodies for some, or another entry in the table of groups.
  void change_company() {
    hgtest::Company &company = model_.company();
    const auto group = [&] { return bytes_.below(8) == 0 ? bytes_.byte() % HG_MAX_GROUPS : bytes_.below(3); };
    const int what = bytes_.below(3);
    if (what == 0) {
      const int a = group(), b = group();
      company.set_pair(grid_, a, b, bytes_.below(2) == 1);
      return;
    }
    for (int n = bytes_.below(8); n > 0 && model_.size() > 0; n--) {
      hgtest::Member &member = company.members[bytes_.byte() % model_.size()];
      if (what == 1) member.group = group() - (bytes_.below(4) == 0 ? 1 : 0);
      if (what == 2) member.body = bytes_.below(4) - 1;
    }
    what == 1 ? company.tell_groups(grid_) : company.tell_bodies(grid_);
  }

  // Another box, or one little different.
  void set_box() {
    hg_grid_def def = def_;
    const auto give = [&] { hgrid::check(hg_set_box(grid_.get(), def.box_min, def.box_max, def.tilt)); };
    if (def.periodic[0] + def.periodic[1] + (def.dimension == 3 ? def.periodic[2] : 0) == 0) {
      expect(hgtest::status_of(give) == HG_OK, "a grid of open axes looks at a box");
      return;
    }
    if (bytes_.below(3) == 0) {
      draw_box(bytes_, def);
      draw_tilt(bytes_, def);
    } else {
      const int k = bytes_.below(3);
      (bytes_.below(2) == 0 ? def.tilt : def.box_max)[k] += std::ldexp(bytes_.number(), -bytes_.below(16));
    }
    if (takes(give)) {
      expect(is_box(def) && GridModel::may_hold(def, model_.particles()), "a bad box is taken");
      def_ = def;
      model_.set_definition(def);
    } else {
      expect(!is_box(def) || !GridModel::must_hold(def, model_.particles()), "a good box is refused");
    }
  }

  void ask_pairs() {
    if (!model_.can_check(model_.particles())) return;
    const Pairs found = hgtest::pairs_of(grid_);
    expect(def_.pair_order != HG_ORDER_ID || std::is_sorted(found.begin(), found.end(), oracle::pair_less),
           "pairs do not ascend");
    model_.check_pairs(found);
    check_vectors(found);
  }

  void visit() {
    if (!model_.can_check(model_.particles())) return;
    Pairs found;
    grid_.visit_pairs([&](hgrid::View<hg_pair> batch) { found.insert(found.end(), batch.begin(), batch.end()); });
    model_.check_pairs(found);
  }

  // No two of the same pair have the same shift, and contacts bring the vectors of the list in its order.
  void check_vectors(const Pairs &pairs) {
    const auto dimension = static_cast<size_t>(def_.dimension);
    const auto [vectors, shifts] = grid_.query_pair_vectors();
    std::set<std::vector<int32_t>> met;
    for (size_t p = 0; p < pairs.size(); p++) {
      std::vector<int32_t> image = {pairs[p].a, pairs[p].b};
      image.insert(image.end(), shifts.data() + p * dimension, shifts.data() + (p + 1) * dimension);
      expect(met.insert(image).second, "a pair has the same shift twice");
    }
    size_t visited = 0;
    const hgrid::View<double> expected = vectors;
    grid_.visit_contacts([&](const hg_contact_batch &batch) {
      const double *components[3] = {batch.dx, batch.dy, batch.dz};
      for (size_t k = 0; k < batch.count; k++, visited++) {
        expect(visited < pairs.size(), "contacts are more than pairs");
        expect(oracle::pair_equal({batch.a[k], batch.b[k]}, pairs[visited]), "contacts have another order");
        for (size_t axis = 0; axis < dimension; axis++) {
          expect(components[axis][k] == expected[visited * dimension + axis], "a contact has another vector");
        }
      }
    });
    expect(visited == pairs.size(), "contacts are fewer than pairs");
  }

  // Rows ascend; with HG_ALL_IMAGES an id may stand there several times, that of the row as well.
  void ask_neighbors() {
    if (!model_.can_check(model_.particles())) return;
    const int32_t list = bytes_.below(2);
    const hgrid::Rows rows = grid_.query_neighbors(list);
    expect(rows.size() == model_.size(), "the number of rows is wrong");
    std::vector<int32_t> starts(rows.offsets.size()), copied(rows.ids.size());
    grid_.copy_neighbors(list, copied.size(), starts.data(), copied.data());
    expect(std::equal(starts.begin(), starts.end(), rows.offsets.begin(), rows.offsets.end()) &&
               std::equal(copied.begin(), copied.end(), rows.ids.begin(), rows.ids.end()),
           "copied rows differ from those lent");
    Pairs half;
    size_t back = 0;
    for (size_t row = 0; row < rows.size(); row++) {
      const hgrid::View<int32_t> ids = rows[row];
      expect(std::is_sorted(ids.begin(), ids.end()), "a row of neighbours does not ascend");
      const int32_t own = model_.ids()[row];
      size_t own_images = 0;
      for (const int32_t id : ids) {
        if (id > own) half.push_back({own, id});
        back += id < own ? 1 : 0;
        own_images += id == own ? 1 : 0;
      }
      expect(list == HG_HALF || own_images % 2 == 0, "an image of a particle with itself has no opposite");
      half.insert(half.end(), list == HG_FULL ? own_images / 2 : own_images, {own, own});
      if (list == HG_FULL) back += own_images / 2;
    }
    expect(back == (list == HG_FULL ? half.size() : 0), "the two directions of neighbours do not fit");
    model_.check_pairs(half);
  }

  // Several at once that are taken, too, stand in rows that one of them alone gives.
  void ask_spheres() {
    particles::ParticleSet spheres;
    spheres.dimension = def_.dimension;
    for (int n = 1 + bytes_.below(3); n > 0; n--) {
      double center[3];
      for (int k = 0; k < def_.dimension; k++) center[k] = bytes_.number();
      spheres.add(center, bytes_.length());
      ask_sphere(spheres.center(spheres.count() - 1), spheres.radii.back());
    }
    takes([&] {
      const hgrid::Rows rows = grid_.query_spheres(spheres.count(), spheres.centers.data(), spheres.radii.data());
      for (size_t row = 0; row < rows.size(); row++) {
        const hgrid::View<int32_t> ids = grid_.query_sphere(spheres.center(row), spheres.radii[row]);
        expect(std::equal(ids.begin(), ids.end(), rows[row].begin(), rows[row].end()), "spheres at once differ");
      }
    });
  }

  // Boxes of any numbers, and triangles of others: what is taken is checked as far as the model can.
  void ask_shapes() {
    if (def_.tilt[0] != 0 || def_.tilt[1] != 0 || def_.tilt[2] != 0) return;
    double low[3], high[3], corners[9];
    for (int k = 0; k < 3; k++) {
      low[k] = bytes_.number();
      high[k] = bytes_.below(4) == 0 ? low[k] : bytes_.number();
    }
    for (double &x : corners) x = bytes_.number();
    takes([&] { model_.check_box(low, high, hgtest::list_of(grid_.query_boxes(1, low, high)[0])); });
    if (def_.dimension == 3)
      takes([&] { model_.check_triangle(corners, hgtest::list_of(grid_.query_triangles(1, corners)[0])); });
  }

  void ask_sphere(const double *center, double radius) {
    takes([&] {
      const hgrid::View<int32_t> ids = grid_.query_sphere(center, radius);
      model_.check_sphere({center, radius}, ids.data(), ids.size());
      if (def_.accuracy == HG_DOUBLE) return;  // its squares may overflow, and infinite ones touch
      for (size_t row = 0; row < model_.size(); row++) {
        const Particles &particles = model_.particles();
        if (model_.company().is_absent(row)) continue;
        const bool found = std::binary_search(ids.begin(), ids.end(), model_.ids()[row]);
        expect(grid_.overlap(center, radius, particles.center(row), particles.radii[row]) == found,
               "hg_overlap and hg_query_sphere do not agree");
      }
    });
  }

  void look_inside() {
    grid_.build();
    int64_t particles = 0;
    for (const hg_level &level : grid_.query_levels()) particles += level.particle_count;
    expect(particles == static_cast<int64_t>(model_.company().present()), "the levels do not hold all particles");
    grid_.query_level_costs();
    const hgrid::View<int32_t> order = grid_.query_order();
    expect(std::is_permutation(order.begin(), order.end(), model_.ids().begin(), model_.ids().end()),
           "the order along space has other ids");
    expect(grid_.get_stats().particle_count == static_cast<int64_t>(model_.size()), "the number of particles is wrong");
  }

  Bytes &bytes_;
  hg_grid_def def_;
  GridModel model_;
  hgrid::Grid grid_;
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
  Bytes bytes(data, size);
  double cells[HG_MAX_LEVELS] = {};
  const hg_grid_def def = draw_definition(bytes, cells);
  std::optional<Session> session;
  if (!takes([&] { session.emplace(bytes, def); })) return 0;
  expect(is_box(def), "a bad box is taken");
  session->run();
  return 0;
}
