// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Elastic gases over many steps: hgrid_long_run [STEPS], a million if not given.
//
// What velocity Verlet does to the energy of a gas is a random walk. Along the line of centres v^2 + w^2 x^2 (1 - (w
// h)^2 / 4) is kept as long as the spring acts (overlap x, step h, w = pi / t_c). A contact that begins at the share f
// of a step enters with 1 - (w h)^2 f (1 - f) of its v^2, and leaves likewise by the share f' of the step in which it
// ends. So a collision changes the energy w of its approach by (pi / n)^2 (f' (1 - f') - f (1 - f)) w in n = t_c / h
// steps: zero on average, rms pi^2 / sqrt(90) n^-2 if f and f' have nothing to do with each other, and less, of order
// n^-3, only where all contacts last the same whole number of steps. Radii, and so masses and durations, differ here.
// With w of exponential distribution and mean kT, N_coll collisions change E = 3/2 N kT by the share sqrt(2 N_coll
// <n^-4>) pi^2 / sqrt(90) / (3/2 N).
//
// The table shows the rms of several gases beside this law, and the change of momentum. Half of the way a checkpoint is
// written; what goes on from it must end with the same bits.
//
// Exit code 1 if energy or momentum stray further than chance explains, or a bit differs.
#include "dem/base/error.hpp"
#include "tests/dem/gas.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <filesystem>
#include <string>

namespace {

constexpr std::array<uint64_t, 4> kSeeds = {1, 2, 3, 4};
constexpr double kSpacing = 3.2, kStiffness = 4000;
constexpr int kEdge = 4;

dem::Setup make_setup(uint64_t seed, double steps_per_contact) {
  bodies::Gas gas;
  gas.edge = kEdge;
  gas.spacing = kSpacing;
  dem::Setup setup = bodies::make_gas(gas, seed);
  bodies::make_periodic(setup);
  setup.contact.stiffness = kStiffness;
  setup.skin = 0.3;
  bodies::set_steps_per_contact(setup, steps_per_contact);
  return setup;
}

// The rms error of the energy of a collision, over that of the approach and n^-2: theory, and single collisions in one
// dimension that begin anywhere in a step and last n to n + 1 steps, integrated here.
const double kTheory = bodies::kPi * bodies::kPi / std::sqrt(90);

double error_of_a_collision(double steps) {
  constexpr int kPhases = 200;
  double squares = 0;
  for (int k = 0; k < kPhases * kPhases; k++) {
    const double n = steps + (static_cast<double>(k / kPhases) + 0.5) / kPhases,
                 h = bodies::kPi / n;                             // mass and stiffness 1
    double x = h * (k % kPhases + 0.5) / kPhases, v = -1, a = 0;  // on the way to the spring, which acts at x < 0
    do {
      v += h / 2 * a;
      x += h * v;
      a = std::max(-x, 0.0);
      v += h / 2 * a;
    } while (x < 0 || v < 0);
    squares += std::pow((v * v - 1) * n * n, 2);
  }
  return std::sqrt(squares / (kPhases * kPhases));
}

// Contacts in equilibrium are spread over the pairs as the squares of their reaches: means over them.
struct Contacts {
  double collisions_per_time = 0;  // 1 / t_c: of one contact that is there all the time
  double squares_per_time = 0;     // n^-4 / t_c
};

Contacts contacts_of(const dem::Setup &setup) {
  Contacts mean;
  double weights = 0;
  for (size_t i = 0; i < setup.count(); i++) {
    for (size_t j = 0; j < i; j++) {
      const double mass = 1 / (1 / setup.masses[i] + 1 / setup.masses[j]);
      const double duration = bodies::kPi * std::sqrt(mass / setup.contact.stiffness);
      const double weight = std::pow(setup.radii[i] + setup.radii[j], 2);
      weights += weight;
      mean.collisions_per_time += weight / duration;
      mean.squares_per_time += weight / duration * std::pow(setup.time_step / duration, 4);
    }
  }
  mean.collisions_per_time /= weights;
  mean.squares_per_time /= weights;
  return mean;
}

// Between contacts only: within one the energy differs from that before by a part of order n^-2, which comes back.
dem::Measurement measure_between_contacts(dem::Engine &engine) {
  dem::Measurement m = engine.measure();
  while (m.contacts > 0) {
    engine.run(1);
    m = engine.measure();
  }
  return m;
}

// One gas, looked at now and then.
class Course {
 public:
  Course(uint64_t seed, double steps_per_contact)
      : setup_(make_setup(seed, steps_per_contact)),
        contacts_(contacts_of(setup_)),
        engine_(dem::make_engine(setup_)),
        start_(measure_between_contacts(*engine_)) {}

  // To a step or a little beyond.
  void run_to(uint64_t step) {
    constexpr uint64_t kLook = 100;
    while (engine_->steps_done() < step) {
      const uint64_t steps = std::min(kLook, step - engine_->steps_done());
      engine_->run(steps);
      contact_time_ += static_cast<double>(engine_->measure().contacts * steps) * setup_.time_step;
    }
    const dem::Measurement now = measure_between_contacts(*engine_);
    energy_change_ = now.energy() / start_.energy() - 1;
    momentum_change_ = 0;
    for (int k = 0; k < 3; k++) {
      const double change = std::fabs(now.momentum[k] - start_.momentum[k]) / static_cast<double>(setup_.count());
      momentum_change_ = std::max(momentum_change_, change);
    }
  }

  const dem::Setup &setup() const { return setup_; }
  dem::Engine &engine() { return *engine_; }
  uint64_t steps_done() const { return engine_->steps_done(); }
  double collisions() const { return contact_time_ * contacts_.collisions_per_time; }
  double squares() const { return contact_time_ * contacts_.squares_per_time; }  // sum of n^-4 of all collisions
  double energy_change() const { return energy_change_; }
  double momentum_change() const { return momentum_change_; }  // per particle; thermal speeds are 1

 private:
  dem::Setup setup_;
  Contacts contacts_;
  std::unique_ptr<dem::Engine> engine_;
  dem::Measurement start_;
  double contact_time_ = 0, energy_change_ = 0, momentum_change_ = 0;
};

struct Row {
  double collisions = 0, squares = 0, energy = 0, momentum = 0;
};

Row mean_of(const std::vector<Course> &courses) {
  Row row;
  for (const Course &course : courses) {
    row.collisions += course.collisions() / static_cast<double>(courses.size());
    row.squares += course.squares() / static_cast<double>(courses.size());
    row.energy += std::pow(course.energy_change(), 2) / static_cast<double>(courses.size());
    row.momentum = std::max(row.momentum, course.momentum_change());
  }
  row.energy = std::sqrt(row.energy);
  return row;
}

bool print_row(const std::vector<Course> &courses, double steps_per_contact) {
  constexpr double kCount = kEdge * kEdge * kEdge;
  const Row row = mean_of(courses);
  const double law = kTheory * std::sqrt(2 * row.squares) / (1.5 * kCount);
  // A collision rounds a velocity in each of its steps.
  const double rounding = 0x1p-53 * std::sqrt(2 * row.collisions * steps_per_contact) / kCount;
  std::printf("%8g %12llu %10.0f %12.3g %10.3g %12.2g %10.2g\n", steps_per_contact,
              static_cast<unsigned long long>(courses.front().steps_done()), row.collisions, row.energy, law,
              row.momentum, rounding);
  std::fflush(stdout);
  // By chi-square for four gases one run in 10^5 is beyond 2.6 times the law.
  return row.energy <= 2.6 * law && row.momentum <= 10 * rounding;
}

bool same_bits(const std::vector<double> &a, const std::vector<double> &b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(double)) == 0;
}

// Goes on from the file to where the engine is.
bool ends_the_same(const dem::Setup &setup, const std::string &path, dem::Engine &undisturbed) {
  const auto restarted = dem::make_engine(setup);
  restarted->restore(dem::Checkpoint::read(path));
  const uint64_t from = restarted->steps_done();
  restarted->run(undisturbed.steps_done() - from);
  const dem::Snapshot one = undisturbed.snapshot(), other = restarted->snapshot();
  const bool same = same_bits(one.centers, other.centers) && same_bits(one.velocities, other.velocities);
  std::printf("restarted at step %llu: at step %llu %s\n", static_cast<unsigned long long>(from),
              static_cast<unsigned long long>(undisturbed.steps_done()), same ? "the same bits" : "OTHER BITS");
  return same;
}

bool follow(uint64_t steps, double steps_per_contact, bool restarts) {
  const std::string path =
      (std::filesystem::temp_directory_path() / ("hgrid-long-run-" + std::to_string(steps))).string();
  std::vector<Course> courses;
  courses.reserve(kSeeds.size());
  for (const uint64_t seed : kSeeds) courses.emplace_back(seed, steps_per_contact);
  bool good = true;
  for (const uint64_t share : {100u, 10u, 2u, 1u}) {
    for (Course &course : courses) course.run_to(steps / share);
    good = print_row(courses, steps_per_contact) && good;
    if (!restarts || share != 2) continue;
    dem::Checkpoint checkpoint;
    courses.front().engine().save(checkpoint);
    checkpoint.write(path);
  }
  if (restarts) {
    good = ends_the_same(courses.front().setup(), path, courses.front().engine()) && good;
    std::filesystem::remove(path);
  }
  return good;
}

}  // namespace

int main(int argc, char **argv) {
  const uint64_t steps = argc > 1 ? std::strtoull(argv[1], nullptr, 10) : 1000000;
  if (argc > 2 || steps < 1000) {
    std::fputs("usage: hgrid_long_run [STEPS], at least 1000\n", stderr);
    return 2;
  }
  try {
    std::printf("%d elastic spheres of radius 0.7 to 1, periodic, %zu seeds from %llu\n", kEdge * kEdge * kEdge,
                kSeeds.size(), static_cast<unsigned long long>(kSeeds.front()));
    std::printf("a single collision: rms error of its energy %.4f n^-2 (%.4f)\n", error_of_a_collision(50), kTheory);
    std::puts("steps per              collisions       energy        law     momentum   rounding");
    std::puts("shortest contact steps       each     rms change");
    bool good = true;
    for (const double steps_per_contact : {20.0, 50.0}) {
      good = follow(steps, steps_per_contact, steps_per_contact == 50) && good;
    }
    return good ? 0 : 1;
  } catch (const std::exception &error) {
    std::fprintf(stderr, "hgrid_long_run: %s\n", error.what());
    return 1;
  }
}
