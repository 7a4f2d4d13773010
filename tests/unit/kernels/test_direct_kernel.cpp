// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The kernels that test stored candidates on doubles, of every instruction set that has them, against the verdict of
// src/exact: any number of candidates, nearly or just touching or far apart, outputs that stop, columns that are full.
#include "src/exact/overlap.hpp"
#include "tests/support/rng.hpp"
#include "tests/unit/kernels/kernel_sets.hpp"
#include "tests/unit/same_pairs.hpp"

#include <cmath>
#include <limits>
#include <vector>

namespace {

using namespace hgtest;

constexpr int32_t kRefused = -1;  // what the kernels write beyond the room that they are given, and nothing else may be

// A contact with what the kernels tell of it.
struct Contact {
  hg_pair ids;
  double vector[3], reach;
  bool operator==(const Contact &other) const {
    return pair_equal(ids, other.ids) && std::equal(vector, vector + 3, other.vector) && reach == other.reach;
  }
};

class Scene {
 public:
  Scene(uint64_t seed, size_t count)
      : rng_(seed),
        dimension_(static_cast<size_t>(rng_.integer(2, 3))),
        domain_(domain_of(static_cast<int>(dimension_))),
        interaction_{rng_.chance(0.5) ? HG_CONTACT : HG_MAX_RANGE, rng_.chance(0.5) ? 0 : rng_.uniform(),
                     rng_.chance(0.5)},
        overlap_(interaction_, HG_EXACT, domain_),
        id_offset_(rng_.integer(0, 1)) {
    make_particles();
    const auto particles = static_cast<uint64_t>(radii_.size());
    for (size_t k = 0; k < count; k++) {
      const auto a = static_cast<int32_t>(rng_.below(particles));
      const int32_t b =
          rng_.chance(0.7) ? partner_[static_cast<size_t>(a)] : static_cast<int32_t>(rng_.below(particles));
      pairs_.push_back({std::min(a, b), std::max(a, b)});
    }
  }

  // Pairs, and how the output stops: what came before stays, in whole pieces.
  void check_pairs() {
    for (const hg::KernelSet *set : sets()) {
      for (const size_t rooms : {SIZE_MAX, static_cast<size_t>(rng_.below(3))}) {
        Room room(rooms, id_offset_);
        const bool done = set->direct[dimension_ - 2][interaction_.kind].pairs(input(), &room.stream);
        const Pairs found = room.taken();
        const auto looked_at = static_cast<size_t>(room.stream.candidate_total);
        require(done ? looked_at == pairs_.size() : looked_at == rooms * hg::kMaxPiece, "%s: %zu of %zu candidates",
                set->name, looked_at, pairs_.size());
        require(rooms == SIZE_MAX || done || rooms * hg::kMaxPiece < pairs_.size(), "%s: stopped too early", set->name);
        Pairs expected;
        for (const Contact &contact : contacts(looked_at)) expected.push_back(contact.ids);
        require_pairs(set->name, found, expected);
      }
    }
  }

  // Contacts into columns of any length, several times over.
  void check_contacts() {
    const std::vector<Contact> expected = contacts(pairs_.size());
    for (const hg::KernelSet *set : sets()) {
      const size_t room = 8 + rng_.below(100);
      std::vector<Contact> found;
      for (size_t first = 0; first < pairs_.size();) first += fill(*set, first, room, found);
      require(found == expected, "%s: %zu contacts instead of %zu, or others", set->name, found.size(),
              expected.size());
    }
  }

 private:
  // Room for one piece of pairs, made a number of times.
  struct Room {
    Room(size_t times, int32_t id_offset)
        : left(times),
          room(hg::kMaxPiece + hg::kPadding),
          stream(judge(id_offset), {room.data(), room.data(), this, make_room}) {}
    static hg::PairJudge judge(int32_t id_offset) {
      hg::PairJudge judge{};
      judge.decide = [](hg::PairStream *) {};
      judge.id_offset = id_offset;
      return judge;
    }
    static bool make_room(hg::PairOutput *output, size_t count) {
      auto &self = *static_cast<Room *>(output->owner);
      self.take();
      output->limit = self.room.data() + self.room.size();
      return count <= self.room.size() && self.left-- > 0;
    }
    void take() {
      all.insert(all.end(), room.data(), stream.output.next);
      stream.output.next = room.data();
    }
    Pairs taken() {
      take();
      return all;
    }
    size_t left;
    Pairs room, all;
    hg::PairStream stream;
  };

  static std::vector<const hg::KernelSet *> sets() {
    std::vector<const hg::KernelSet *> some;
    for (const hg::KernelSet *set : kernel_sets()) {
      if (set->direct[0][0].pairs != nullptr) some.push_back(set);
    }
    return some;
  }

  static hg::Domain domain_of(int dimension) {
    hg::Domain domain;
    domain.dimension = dimension;
    return domain;
  }

  // Most have a partner at the distance where they touch, or that but for roundings.
  void make_particles() {
    const double size = std::pow(2, rng_.uniform(-600, 400)), spread = size * rng_.uniform(1, 20);
    const double far = rng_.chance(0.5) ? 0 : 1e6 * size;
    interaction_margin(size);
    for (size_t i = 0; i < 2 + rng_.below(200); i++) {
      radii_.push_back(rng_.chance(0.1) ? 0 : size * rng_.uniform(0.1, 1));
      partner_.push_back(static_cast<int32_t>(rng_.below(i + 1)));
      const auto near = static_cast<size_t>(partner_[i]);
      double at[3];
      for (double &x : at) x = far + spread * rng_.uniform(-1, 1);
      if (near < i) {
        const double reach = interaction_.reach(radii_[i], radii_[near]);
        const auto axis = static_cast<size_t>(rng_.below(dimension_));
        for (size_t k = 0; k < dimension_; k++) at[k] = centers_[near * dimension_ + k];
        at[axis] += reach * (1 + rng_.integer(-2, 2) * 0x1p-50);
      }
      centers_.insert(centers_.end(), at, at + dimension_);
    }
  }

  void interaction_margin(double size) {
    interaction_.margin *= size;
    overlap_ = hg::Overlap(interaction_, HG_EXACT, domain_);
  }

  hg::DirectInput input(size_t first = 0) const {
    const auto interact = [](const void *judge, const hg_pair &pair, int64_t *exact) {
      const auto &self = *static_cast<const Scene *>(judge);
      require(self.is_near(pair), "asked about a pair that is not near to touching");
      return self.interact(pair, *exact);
    };
    return {centers_.data(), radii_.data(), pairs_.data() + first, pairs_.size() - first, interaction_.margin,
            interact,        this};
  }

  hg::Ball ball(int32_t slot) const {
    const auto i = static_cast<size_t>(slot);
    return {centers_.data() + i * dimension_, radii_[i]};
  }
  bool interact(const hg_pair &pair, int64_t &exact) const {
    return overlap_.is_pair(ball(pair.a), ball(pair.b), hg::Shift{}, exact);
  }
  bool is_near(const hg_pair &pair) const {
    const Contact contact = contact_of(pair);
    const double *d = contact.vector;
    const double distance = std::hypot(d[0], d[1], d[2]);
    if (distance < 1e-139 && contact.reach < 1e-139) return true;  // their squares may have lost bits
    return std::fabs(distance / contact.reach - 1) < 1e-12;
  }

  Contact contact_of(const hg_pair &pair) const {
    const hg::Ball a = ball(pair.a), b = ball(pair.b);
    Contact contact{{pair.a + id_offset_, pair.b + id_offset_}, {0, 0, 0}, interaction_.reach(a.radius, b.radius)};
    for (size_t k = 0; k < dimension_; k++) contact.vector[k] = b.center[k] - a.center[k];
    return contact;
  }

  // Of the first candidates.
  std::vector<Contact> contacts(size_t count) const {
    std::vector<Contact> all;
    int64_t exact = 0;
    for (size_t k = 0; k < count; k++) {
      if (interact(pairs_[k], exact)) all.push_back(contact_of(pairs_[k]));
    }
    return all;
  }

  size_t fill(const hg::KernelSet &set, size_t first, size_t room, std::vector<Contact> &found) {
    const size_t all = room + hg::kPadding;
    std::vector<int32_t> a(all + 1, kRefused), b(all + 1, kRefused);
    std::vector<double> numbers(4 * all);
    double *n = numbers.data();
    hg::ContactColumns columns{room, id_offset_, a.data(), b.data(), {n, n + all, n + 2 * all}, n + 3 * all, 0, 0, 0};
    const size_t looked_at = set.direct[dimension_ - 2][interaction_.kind].contacts(input(first), &columns);
    require(columns.count <= room && a[all] == kRefused && b[all] == kRefused, "%s: written beyond the room", set.name);
    require(looked_at > 0, "%s: nothing was looked at", set.name);
    for (size_t k = 0; k < columns.count; k++) {
      found.push_back({{a[k], b[k]}, {n[k], n[all + k], n[2 * all + k]}, n[3 * all + k]});
    }
    return looked_at;
  }

  Rng rng_;
  size_t dimension_;
  hg::Domain domain_;
  hg::Interaction interaction_;
  hg::Overlap overlap_;
  int32_t id_offset_;
  std::vector<double> centers_, radii_;
  std::vector<int32_t> partner_;
  Pairs pairs_;
};

// All numbers of candidates around one vector, and any up to a few pieces.
void pairs(void **) {
  assert_true(sweep(100, [](uint64_t seed) { Scene(seed, seed).check_pairs(); }));
  assert_true(sweep(100, [](uint64_t seed) { Scene(seed, Rng(seed).below(size_t{4} * hg::kMaxPiece)).check_pairs(); }));
}
void contacts(void **) {
  assert_true(sweep(100, [](uint64_t seed) { Scene(seed, seed).check_contacts(); }));
  assert_true(sweep(100, [](uint64_t seed) { Scene(seed, Rng(seed).below(3000)).check_contacts(); }));
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {cmocka_unit_test(pairs), cmocka_unit_test(contacts)};
  return cmocka_run_group_tests_name("direct_kernel", tests, nullptr, nullptr);
}
