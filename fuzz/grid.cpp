// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Fuzzes the C interface: a definition, then any sequence of calls, checked against a plain list in exact arithmetic.
#include "fuzz/bytes.hpp"
#include "fuzz/expect.hpp"
#include "fuzz/grid_model.hpp"

#include <hgrid/hgrid.h>

#include <algorithm>
#include <memory>

namespace {

using fuzz::Bytes;
using fuzz::expect;
using fuzz::GridModel;
using oracle::Pairs;
using Particles = particles::ParticleSet;

constexpr size_t kMostParticles = 16;  // more only cost time: every pair is decided in rational numbers
constexpr int kMostCalls = 24;

struct DestroyGrid {
  void operator()(hg_grid *grid) const { hg_destroy(grid); }
};
using Grid = std::unique_ptr<hg_grid, DestroyGrid>;

// A refusal must be one of those the header names, and say why.
void expect_refusal(hg_status status) {
  expect(status == HG_ERR_ARGUMENT || status == HG_ERR_LIMIT, "a refusal with an unexpected status");
  expect(hg_last_error()[0] != '\0', "a refusal without a text");
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
  for (int k = 0; k < 3; k++) {
    def.periodic[k] = axes < 8 ? axes >> k & 1 : 0;
    if (def.periodic[k] == 0) continue;
    def.box_min[k] = bytes.number();
    def.box_max[k] = def.box_min[k] + 8 * bytes.length();
  }
  if (def.level_rule == HG_LEVELS_USER) {
    for (int h = 0; h < def.level_count; h++) cells[h] = (h > 0 ? cells[h - 1] : 0) + bytes.length();
    def.cell_sizes = cells;
  }
  return def;
}

class Session {
 public:
  Session(Bytes &bytes, const hg_grid_def &def, Grid grid)
      : bytes_(bytes), def_(def), model_(def), grid_(std::move(grid)) {}

  void run() {
    for (int call = 0; call < kMostCalls && !bytes_.empty(); call++) {
      switch (bytes_.below(12)) {
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
          ask_sphere();
          break;
        case 9:
          look_inside();
          break;
        case 10:
          if (bytes_.below(4) == 0) clear();
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
    const hg_status status = hg_insert(grid_.get(), batch.count(), batch.centers.data(), batch.radii.data());
    if (status != HG_OK) {
      expect(!model_.must_take(batch), "good particles are refused");
      expect_refusal(status);
      return;
    }
    expect(model_.may_take(batch), "bad particles are taken");
    model_.insert(batch);
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
    const hg_status status =
        hg_move(grid_.get(), moved.count(), moved.centers.data(), radii ? moved.radii.data() : nullptr);
    if (status != HG_OK) {
      expect(!model_.must_take(moved), "a good move is refused");
      expect_refusal(status);
      return;
    }
    expect(model_.may_take(moved), "a bad move is taken");
    model_.move(moved.centers, radii ? &moved.radii : nullptr);
  }

  void remove() {
    std::vector<int32_t> ids;
    const int count = bytes_.below(6);
    for (int i = 0; i < count; i++) {
      const bool known = bytes_.below(8) != 0 && model_.size() > 0;
      ids.push_back(known ? model_.ids()[bytes_.byte() % model_.size()] : static_cast<int8_t>(bytes_.byte()));
    }
    const hg_status status = hg_remove(grid_.get(), ids.size(), ids.data());
    expect(status == HG_OK || status == HG_ERR_NOT_FOUND, "hg_remove gives an unexpected status");
    expect(model_.remove(ids) == (status == HG_OK), "hg_remove takes wrong ids, or refuses right ones");
  }

  void clear() {
    expect(hg_clear(grid_.get()) == HG_OK, "hg_clear fails");
    model_.clear();
  }

  void ask_pairs() {
    const hg_pair *pairs = nullptr;
    size_t count = 0;
    expect(hg_query_pairs(grid_.get(), &pairs, &count) == HG_OK, "hg_query_pairs fails");
    const Pairs found(pairs, pairs + count);
    expect(def_.pair_order != HG_ORDER_ID || std::is_sorted(found.begin(), found.end(), oracle::pair_less),
           "pairs do not ascend");
    model_.check_pairs(found);
  }

  static int32_t collect(void *context, const hg_pair *pairs, size_t count) {
    Pairs &all = *static_cast<Pairs *>(context);
    all.insert(all.end(), pairs, pairs + count);
    return 0;
  }

  void visit() {
    Pairs found;
    expect(hg_visit_pairs(grid_.get(), collect, &found) == HG_OK, "hg_visit_pairs fails");
    model_.check_pairs(found);
  }

  void ask_neighbors() {
    const int32_t list = bytes_.below(2);
    const int64_t *offsets = nullptr;
    const int32_t *neighbors = nullptr;
    expect(hg_query_neighbors(grid_.get(), list, &offsets, &neighbors) == HG_OK, "hg_query_neighbors fails");
    Pairs half;
    size_t back = 0;
    for (size_t row = 0; row < model_.size(); row++) {
      for (int64_t k = offsets[row]; k < offsets[row + 1]; k++) {
        expect(k == offsets[row] || neighbors[k - 1] < neighbors[k], "a row of neighbours does not ascend");
        const int32_t id = model_.ids()[row];
        if (neighbors[k] > id) half.push_back({id, neighbors[k]});
        back += neighbors[k] < id ? 1 : 0;
      }
    }
    expect(back == (list == HG_FULL ? half.size() : 0), "the two directions of neighbours do not fit");
    model_.check_pairs(half);
  }

  void ask_sphere() {
    double center[3];
    for (int k = 0; k < def_.dimension; k++) center[k] = bytes_.number();
    const double radius = bytes_.length();
    const int32_t *ids = nullptr;
    size_t count = 0;
    const hg_status status = hg_query_sphere(grid_.get(), center, radius, &ids, &count);
    if (status != HG_OK) {
      expect_refusal(status);
      return;
    }
    model_.check_sphere({center, radius}, ids, count);
  }

  void look_inside() {
    expect(hg_build(grid_.get()) == HG_OK, "hg_build fails");
    const hg_level *levels = nullptr;
    const hg_level_cost *costs = nullptr;
    size_t count = 0, cost_count = 0;
    expect(hg_query_levels(grid_.get(), &levels, &count) == HG_OK, "hg_query_levels fails");
    expect(hg_query_level_costs(grid_.get(), &costs, &cost_count) == HG_OK, "hg_query_level_costs fails");
    int64_t particles = 0;
    for (size_t h = 0; h < count; h++) particles += levels[h].particle_count;
    expect(particles == static_cast<int64_t>(model_.size()), "the levels do not hold all particles");
    hg_grid_stats stats;
    expect(hg_get_stats(grid_.get(), &stats, sizeof stats) == HG_OK, "hg_get_stats fails");
    expect(stats.particle_count == particles, "the number of particles is wrong");
  }

  Bytes &bytes_;
  hg_grid_def def_;
  GridModel model_;
  Grid grid_;
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
  Bytes bytes(data, size);
  double cells[HG_MAX_LEVELS] = {};
  const hg_grid_def def = draw_definition(bytes, cells);
  hg_grid *grid = nullptr;
  const hg_status status = hg_create(&def, &grid);
  if (status != HG_OK) {
    expect(grid == nullptr, "a grid in spite of a refusal");
    expect_refusal(status);
    return 0;
  }
  Session(bytes, def, Grid(grid)).run();
  return 0;
}
