// The native contact laws: what they answer, and what they refuse.

#include <catch2/catch.hpp>

#include "conformance/plugin_use.h"
#include "plugin/sampled_states.h"

using namespace flyrock;

namespace {

const LuaSession& session() {
  static const LuaSession one(FLYROCK_SHARE_DIR);
  return one;
}

}  // namespace

TEST_CASE("newton answers its coefficients") {
  const auto law =
      make<RestitutionLaw>(session(), PluginKind::restitution, "newton", {{"en", 0.6}, {"et", -0.1}});
  CHECK(law.model->constant());
  const Restitution answer = law.model->impact(law.values, {});
  CHECK(answer.e_n == 0.6);
  CHECK(answer.e_t == -0.1);
}

TEST_CASE("coulomb takes the coefficient or the angle") {
  const auto friction = [](const std::map<std::string, Given>& given) {
    const auto law = make<FrictionLaw>(session(), PluginKind::friction, "coulomb", given);
    return law.model->friction(law.values, {});
  };
  CHECK(friction({{"mu", 0.5}}).mu_s == 0.5);
  CHECK(friction({{"mu", 0.5}}).mu_d == 0.5);
  CHECK(friction({{"angle", pi / 4}}).mu_s == Approx(1).epsilon(1e-14));
  CHECK_THROWS_WITH(friction({}), "plugin coulomb: expected either `mu` or `angle`");
  CHECK_THROWS_WITH(friction({{"mu", 0.5}, {"angle", 0.5}}),
                    "plugin coulomb: expected either `mu` or `angle`");
}

TEST_CASE("rolling resistance and Signorini's condition") {
  const auto rolling =
      make<RollingLaw>(session(), PluginKind::rolling, "rolling_resistance", {{"mu_r", 0.05}});
  CHECK(rolling.model->rolling(rolling.values, {}).mu_r == 0.05);
  const auto unilateral = make<UnilateralLaw>(session(), PluginKind::unilateral, "signorini", {});
  CHECK(unilateral.model->condition(unilateral.values, {}).condition == NormalCondition::signorini);
}

TEST_CASE("independent asks for its number of rocks and leaves the rest to the group") {
  const auto population =
      make<Population>(session(), PluginKind::population, "independent", {{"per_trial", 3.0}});
  RandomStream rng(1, "rocks", {});
  const auto rocks = population.model->rocks(population.values, sampled_terrain(2), {}, rng);
  REQUIRE(rocks.size() == 3);
  CHECK(rocks[0].shape.contactors.empty());
  CHECK_FALSE(rocks[0].position);
  CHECK_FALSE(rocks[0].orientation);
}
