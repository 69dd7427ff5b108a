// The skill of a model for a held group, on samples with skill and without.

#include "results/compare/skill.h"

#include <catch2/catch.hpp>
#include <cmath>

#include "random/stream.h"

using namespace flyrock;

namespace skill_test {

std::vector<Vec2> normal(std::size_t count, double mean, const char* stream, std::uint64_t repeat) {
  DrawKey key;
  key.trial = repeat;
  RandomStream rng(5, stream, key);
  std::vector<Vec2> values;
  for (std::size_t i = 0; i < count; ++i) values.emplace_back(40 + 10 * (mean + rng.normal()), 0);
  return values;
}

/// Of `repeats` groups that go two deviations farther than the others, how many have skill. The model knows
/// it, or gives this group what the others have.
int with_skill(bool model_knows, double shift, int repeats) {
  int count = 0;
  for (int repeat = 0; repeat < repeats; ++repeat) {
    const auto r = static_cast<std::uint64_t>(repeat);
    const Skill skill =
        skill_of(normal(20, shift, "held", r), normal(400, model_knows ? shift : 0, "model", r),
                 normal(30, 0, "others", r), false, r);
    count += skill.has_skill();
  }
  return count;
}

}  // namespace skill_test

using namespace skill_test;

TEST_CASE("made-up skill and no skill are told apart in 90 % of the groups") {
  CHECK(with_skill(true, 2, 20) >= 18);
  CHECK(with_skill(false, 2, 20) <= 2);  // the model says what the others say
  CHECK(with_skill(true, 0, 20) <= 2);   // the group goes as far as the others
}

TEST_CASE("made-up skill and no skill are told apart in 90 % of 200 groups", "[slow]") {
  CHECK(with_skill(true, 2, 200) >= 180);
  CHECK(with_skill(false, 2, 200) <= 20);
  CHECK(with_skill(true, 0, 200) <= 20);
}

TEST_CASE("the difference of a skill is that of two energy distances, by hand") {
  // X = {0, 2}, Y = {1}, O = {4, 6}: E|X - Y| = 1, E|X - O| = 4, E|Y - Y'| = 0, E|O - O'| = 2 over different
  // rows.
  const Skill skill = skill_of({{0, 0}, {2, 0}}, {{1, 0}}, {{4, 0}, {6, 0}}, false, 1);
  CHECK(skill.difference == Approx(2 * (1 - 4) + 2));
  // The same in a plane, along y.
  const Skill plane = skill_of({{0, 0}, {0, 2}}, {{0, 1}}, {{0, 4}, {0, 6}}, true, 1);
  CHECK(plane.difference == Approx(skill.difference));
}

TEST_CASE("a group that is predicted worse says so, and too few rows have no skill") {
  const Skill worse =
      skill_of(normal(20, 0, "held", 1), normal(400, 3, "model", 1), normal(30, 0, "others", 1), false, 1);
  CHECK(worse.is_worse());
  CHECK(std::string(worse.verdict()) == "no skill");
  CHECK(skill_text(worse, "late").starts_with("No skill: the model predicts late worse than"));
  const Skill few = skill_of({{1, 0}}, {{1, 0}}, {{1, 0}, {2, 0}}, false, 1);
  CHECK_FALSE(few.is_known());
  CHECK(skill_text(few, "late").find("not known") != std::string::npos);
}
