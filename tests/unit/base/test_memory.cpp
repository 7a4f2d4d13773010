// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Memory and Buffer: every byte is counted and returned, a refused request changes nothing.
#include "src/base/memory.hpp"
#include "tests/unit/checks.hpp"

#include <cstdlib>
#include <limits>

namespace {

using namespace hgtest;
using hg::Buffer;
using hg::Memory;

// Counts what it gives and takes, and refuses on demand.
struct Books {
  long long bytes = 0;
  long long requests = 0;
  bool refuse = false;
  bool wrong_size = false;
};

// Each block carries its size in front, so that a wrong size at its return is seen.
constexpr size_t kHead = 16;

void *give(void *context, size_t size) {
  Books &books = *static_cast<Books *>(context);
  books.requests++;
  if (books.refuse) return nullptr;
  auto *block = static_cast<char *>(std::malloc(size + kHead));
  std::memcpy(block, &size, sizeof size);
  books.bytes += static_cast<long long>(size);
  return block + kHead;
}

void take(void *context, void *memory, size_t size) {
  Books &books = *static_cast<Books *>(context);
  size_t given = 0;
  std::memcpy(&given, static_cast<char *>(memory) - kHead, sizeof given);
  books.wrong_size = books.wrong_size || given != size;
  books.bytes -= static_cast<long long>(given);
  std::free(static_cast<char *>(memory) - kHead);
}

void *regive(void *context, void *memory, size_t old_size, size_t size) {
  void *moved = give(context, size);
  if (moved == nullptr) return nullptr;
  std::memcpy(moved, memory, old_size < size ? old_size : size);
  take(context, memory, old_size);
  return moved;
}

hg_allocator allocator_of(Books &books) { return {&books, give, regive, take}; }

void check_growth(uint64_t seed) {
  Rng rng(seed);
  Books books;
  Memory memory(allocator_of(books));
  {
    Buffer<uint32_t> buffer(memory);
    size_t held = 0;
    for (int step = 0; step < 200; step++) {
      const size_t count = held + rng.below(50);
      buffer.grow(count);
      require(buffer.capacity() >= count, "grow(%zu) has room for %zu", count, buffer.capacity());
      for (; held < count; held++) buffer[held] = static_cast<uint32_t>(held * 7);
      for (size_t i = 0; i < held; i++) require(buffer[i] == i * 7, "entry %zu was lost", i);
      require(memory.bytes() == books.bytes, "%lld bytes counted, %lld given", static_cast<long long>(memory.bytes()),
              books.bytes);
      require(memory.bytes() == static_cast<int64_t>(buffer.capacity() * sizeof(uint32_t)), "bytes held");
    }
  }
  require(memory.bytes() == 0 && books.bytes == 0, "%lld bytes are left", books.bytes);
  require(!books.wrong_size, "a block came back with another size");
}

void growth_keeps_entries(void **) { assert_true(sweep(20, check_growth)); }

// One element at a time must cost a number of requests that grows as the logarithm.
void appending_is_cheap(void **) {
  assert_true(holds(0, [](uint64_t) {
    Books books;
    Memory memory(allocator_of(books));
    Buffer<char> buffer(memory);
    for (size_t count = 1; count <= 100000; count++) buffer.grow(count);
    require(books.requests < 50, "%lld requests", books.requests);
  }));
}

void require_never_shrinks(void **) {
  assert_true(holds(0, [](uint64_t) {
    Books books;
    Memory memory(allocator_of(books));
    Buffer<double> buffer(memory);
    buffer.require(100);
    const double *data = buffer.data();
    buffer.require(10);
    buffer.grow(50);
    buffer.require(0);
    require(buffer.capacity() == 100 && buffer.data() == data, "capacity %zu", buffer.capacity());
    buffer.require(101);
    require(buffer.capacity() == 101 && memory.bytes() == 808, "%lld bytes", static_cast<long long>(memory.bytes()));
  }));
}

void refusal_in_grow(void **) {
  assert_true(holds(0, [](uint64_t) {
    Books books;
    Memory memory(allocator_of(books));
    Buffer<int> buffer(memory);
    buffer.grow(2);
    buffer[0] = 11;
    buffer[1] = 22;
    books.refuse = true;
    require_refused("grow", HG_ERR_MEMORY, "4000 bytes", [&] { buffer.grow(1000); });
    require(buffer.capacity() == 2 && buffer[0] == 11 && buffer[1] == 22, "the entries were lost");
    require(memory.bytes() == 8, "%lld bytes", static_cast<long long>(memory.bytes()));
  }));
}

void refusal_in_require(void **) {
  assert_true(holds(0, [](uint64_t) {
    Books books;
    Memory memory(allocator_of(books));
    {
      Buffer<int> buffer(memory);
      buffer.require(2);
      books.refuse = true;
      require_refused("require", HG_ERR_MEMORY, "4000 bytes", [&] { buffer.require(1000); });
      require(buffer.capacity() == 0 && memory.bytes() == 0, "capacity %zu", buffer.capacity());
      books.refuse = false;
      buffer.require(3);
      require(buffer.capacity() == 3, "capacity %zu", buffer.capacity());
    }
    require(memory.bytes() == 0 && books.bytes == 0 && !books.wrong_size, "%lld bytes are left", books.bytes);
  }));
}

// Sizes beyond what an address can count are refused before any request is made.
void sizes_that_overflow(void **) {
  assert_true(holds(0, [](uint64_t) {
    const size_t most = std::numeric_limits<size_t>::max();
    require(hg::array_bytes(most / 8, 8) == most / 8 * 8, "the largest size that fits");
    require_refused("array_bytes", HG_ERR_MEMORY, "elements", [&] { hg::array_bytes(most / 8 + 1, 8); });
    Books books;
    Memory memory(allocator_of(books));
    Buffer<double> buffer(memory);
    require_refused("grow", HG_ERR_MEMORY, "elements", [&] { buffer.grow(most / 4); });
    require_refused("require", HG_ERR_MEMORY, "elements", [&] { buffer.require(most / 4); });
    require(books.requests == 0, "%lld requests", books.requests);
  }));
}

void nothing_from_nothing(void **) {
  assert_true(holds(0, [](uint64_t) {
    Books books;
    Memory memory(allocator_of(books));
    require(memory.allocate(0) == nullptr, "zero bytes need no memory");
    memory.release(nullptr, 0);
    Buffer<int> buffer(memory);
    buffer.grow(0);
    buffer.require(0);
    require(books.requests == 0, "%lld requests", books.requests);
  }));
}

void system_allocator_works(void **) {
  assert_true(holds(0, [](uint64_t) {
    Memory memory(hg::system_allocator());
    auto *block = static_cast<char *>(memory.allocate(10));
    std::memset(block, 7, 10);
    block = static_cast<char *>(memory.reallocate(block, 10, 1000));
    require(block[0] == 7 && block[9] == 7, "realloc lost the contents");
    require(memory.bytes() == 1000, "%lld bytes", static_cast<long long>(memory.bytes()));
    memory.release(block, 1000);
    require(memory.bytes() == 0, "%lld bytes are left", static_cast<long long>(memory.bytes()));
  }));
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(growth_keeps_entries),  cmocka_unit_test(appending_is_cheap),
      cmocka_unit_test(require_never_shrinks), cmocka_unit_test(refusal_in_grow),
      cmocka_unit_test(refusal_in_require),    cmocka_unit_test(sizes_that_overflow),
      cmocka_unit_test(nothing_from_nothing),  cmocka_unit_test(system_allocator_works),
  };
  return cmocka_run_group_tests_name("memory", tests, nullptr, nullptr);
}
