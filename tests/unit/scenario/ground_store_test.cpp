// The store of grounds: what is made once, and what it lets go.

#include "scenario/ground_store.h"

#include <atomic>
#include <catch2/catch.hpp>
#include <thread>
#include <vector>

using namespace flyrock;

namespace {

GroundStore::Made made_of(int number, std::size_t bytes, bool draws = false) {
  return {std::make_shared<const int>(number), bytes, draws};
}

int number_of(const std::shared_ptr<const void>& one) { return *static_cast<const int*>(one.get()); }

}  // namespace

TEST_CASE("a ground is made once, also if several threads ask at the same time") {
  GroundStore store;
  std::atomic<int> made = 0;
  std::vector<std::jthread> threads;
  for (int i = 0; i < 8; ++i)
    threads.emplace_back([&] {
      for (const char* key : {"a", "b"})
        store.get(key, [&] {
          ++made;
          return made_of(1, 10);
        });
    });
  threads.clear();
  CHECK(made == 2);
}

TEST_CASE("a ground that draws is made anew for each who asks") {
  GroundStore store;
  int made = 0;
  for (int i = 0; i < 3; ++i)
    CHECK(number_of(store.get("a", [&] { return made_of(++made, 10, true); })) == i + 1);
}

TEST_CASE("the store lets the least recently used ground go, who holds one keeps it") {
  GroundStore store(2, 100);
  int made = 0;
  const auto get = [&](const char* key, std::size_t bytes) {
    return store.get(key, [&] { return made_of(++made, bytes); });
  };
  const auto first = get("a", 10);
  get("b", 10);
  get("a", 10);
  get("c", 10);  // b goes
  CHECK(made == 3);
  get("a", 10);
  CHECK(made == 3);
  get("b", 10);  // c goes
  CHECK(made == 4);
  get("large", 200);  // alone beyond the limit: kept, all others go
  get("large", 200);
  CHECK(made == 5);
  CHECK(number_of(first) == 1);
  CHECK(number_of(get("a", 10)) == 6);
}

TEST_CASE("a ground that cannot be made is tried again") {
  GroundStore store;
  CHECK_THROWS(store.get("a", []() -> GroundStore::Made { throw std::runtime_error("no"); }));
  CHECK(number_of(store.get("a", [] { return made_of(7, 1); })) == 7);
}

TEST_CASE("a shape that was left is taken once, under its key") {
  GroundStore store;
  CHECK(!store.take("a"));
  store.leave("a", std::make_shared<int>(3));
  CHECK(!store.take("b"));
  CHECK(*std::static_pointer_cast<int>(store.take("a")) == 3);
  CHECK(!store.take("a"));
}
