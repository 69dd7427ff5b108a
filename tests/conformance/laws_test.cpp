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

TEST_CASE("rolling_resistance takes a length or a share of the radius, and resists pivoting with 2/5 of it") {
  const auto rolling = [](const std::map<std::string, Given>& given) {
    const auto law = make<RollingLaw>(session(), PluginKind::rolling, "rolling_resistance", given);
    ContactState contact;
    contact.radius = 0.3;
    return law.model->rolling(law.values, contact);
  };
  CHECK(rolling({{"mu_r", 0.05}}).mu_r == 0.05);
  CHECK(rolling({{"mu_r", 0.05}}).mu_spin == Approx(0.02).epsilon(1e-15));
  CHECK(rolling({{"mu_r", 0.05}, {"mu_spin", 0.0}}).mu_spin == 0);
  CHECK(rolling({{"share", 0.1}}).mu_r == Approx(0.03).epsilon(1e-15));
  CHECK(rolling({{"share", 0.1}}).mu_spin == Approx(0.012).epsilon(1e-15));
  CHECK(rolling({{"share", 0.1}, {"mu_spin", 0.5}}).mu_spin == 0.5);
  const char* const both_or_none = "plugin rolling_resistance: expected either `mu_r` or `share`";
  CHECK_THROWS_WITH(rolling({}), both_or_none);
  CHECK_THROWS_WITH(rolling({{"mu_spin", 0.1}}), both_or_none);
  CHECK_THROWS_WITH(rolling({{"mu_r", 0.05}, {"share", 0.1}}), both_or_none);
}

TEST_CASE("Signorini's condition") {
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
