#include "load/hard_contacts.h"

#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "world/corners.h"

namespace flyrock {

namespace {

/// The greatest W_nn of one body [1/kg]; 0 for a body that contacts do not move.
double greatest_w(const Body<2>& body) {
  if (!body.moves()) return 0;
  double lever = 0;
  for (const Contactor2& contactor : body.contactors) {
    const std::size_t n = contactor.points.size();
    for (std::size_t i = 0; i < n; ++i) {
      if (contactor.normals.empty()) lever = std::max(lever, contactor.points[i].norm());
      for (std::size_t end = 0; end < 2 && !contactor.normals.empty(); ++end)
        lever = std::max(lever, std::abs(cross(contactor.points[(i + end) % n], contactor.normals[i])));
    }
  }
  return 1 / body.mass + lever * lever / body.inertia;
}

/// The greatest (p x n) I^-1 (p x n) over all normals n: a point that is grown by a radius is touched from
/// all sides.
double greatest_turned(const Vec3& point, const Body<3>& body) {
  Eigen::Matrix3d crossed;  // crossed n = p x n
  crossed << 0, -point.z(), point.y(), point.z(), 0, -point.x(), -point.y(), point.x(), 0;
  const Eigen::Matrix3d form = crossed.transpose() * body.inertia.cwiseInverse().asDiagonal() * crossed;
  return Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(form, Eigen::EigenvaluesOnly).eigenvalues()[2];
}

double greatest_w(const Body<3>& body) {
  if (!body.moves()) return 0;
  double turned = 0;
  const auto add = [&](const Vec3& arm) {
    turned = std::max(turned, arm.dot(arm.cwiseQuotient(body.inertia)));
  };
  for (const Contactor3& contactor : body.contactors) {
    if (contactor.faces.empty())
      for (const Vec3& point : contactor.points) turned = std::max(turned, greatest_turned(point, body));
    constexpr int places = 8;  // of a rim
    for (const Contactor3::Circle& circle : contactor.circles)
      for (int i = 0; i < places; ++i) {
        const Vec3 across = circle.axis.unitOrthogonal();
        const double angle = 2 * pi * i / places;
        const Vec3 out = std::cos(angle) * across + std::sin(angle) * circle.axis.cross(across);
        turned = std::max(turned, greatest_turned(circle.centre + circle.radius * out, body));
      }
    for (const Contactor3::Face& face : contactor.faces)
      for (int i = 0; i < face.count; ++i)
        add(contactor.points[contactor.vertex(face, i)].cross(face.normal));
  }
  return 1 / body.mass + turned;
}

/// The stiffness of a material that is a linear spring [N/m]; 0 if it is none. The run itself warns of
/// others.
double stiffness_of(int material, const DrawKey& key, const Scenario& scenario, const Instances& instances) {
  const UnilateralLaw* law = instances.materials[material].unilateral.get();
  if (!law || !law->constant()) return 0;  // a law that is not constant is checked during the run
  const Unilateral answer =
      law->condition(values_of(*scenario.materials[material].unilateral, scenario, key), {});
  const bool linear = answer.condition == NormalCondition::penalty && answer.spring.exponent == 1;
  return linear ? answer.spring.stiffness : 0;
}

/// The form of the restitution law of a material: that of its manifest, or of a native law, which may choose,
/// that of an answer. Nothing without a law, and for one that fails: the run says so.
std::optional<RestitutionForm> form_of(int material, const DrawKey& key, const Scenario& scenario,
                                       const Instances& instances) {
  const RestitutionLaw* law = instances.materials[material].restitution.get();
  if (!law) return std::nullopt;
  const PluginUse& use = *scenario.materials[material].restitution;
  if (use.plugin->spec.native.empty()) return restitution_form(use.plugin->spec.form);
  try {
    std::vector<double> history(use.plugin->spec.history.size(), 0.0);
    ContactState state;
    state.history = history;
    return law->impact(values_of(use, scenario, key), state).form;
  } catch (const TrialError&) {
    return std::nullopt;
  }
}

}  // namespace

template <int D>
std::vector<SpringSwing> spring_swings(const Scenario& scenario, const Instances& instances,
                                       const World<D>& world, const WorldLaws& laws) {
  std::vector<SpringSwing> swings;
  if (!scenario.solver.time_step) return swings;  // chosen steps are short enough
  const double time_step = *scenario.solver.time_step;
  const auto consider = [&](int material, int owner, double w, const std::string& bodies) {
    if (material < 0 || w == 0) return;
    const double stiffness = stiffness_of(material, laws.key_of(owner), scenario, instances);
    if (stiffness == 0) return;
    const SpringSwing swing{material, time_step * std::sqrt(stiffness * w), stiffness, bodies};
    const auto known = std::find_if(swings.begin(), swings.end(),
                                    [&](const SpringSwing& s) { return s.material == material; });
    if (known == swings.end())
      swings.push_back(swing);
    else if (known->angle < swing.angle)
      *known = swing;
  };
  const bool has_spring = std::any_of(instances.materials.begin(), instances.materials.end(),
                                      [](const MaterialLaws& bound) { return bound.unilateral != nullptr; });
  const int bodies = has_spring ? static_cast<int>(world.bodies.size()) : 0;
  std::vector<double> w;
  for (int i = 0; i < bodies; ++i) w.push_back(greatest_w(world.bodies[i]));
  for (int i = 0; i < bodies; ++i) {
    const std::string name = "`" + world.bodies[i].group + "`";
    for (int part = 0; part < static_cast<int>(parts_of(world.terrain()).size()); ++part)
      consider(laws.material_with_terrain(world, i, part), i, w[i], name);
    for (int j = i + 1; j < bodies && world.settings().body_contacts; ++j)
      if (w[i] + w[j] > 0)
        consider(laws.material_between(i, j), i, w[i] + w[j], name + " and `" + world.bodies[j].group + "`");
  }
  return swings;
}

template <int D>
std::vector<CornerUnderLaw> corners_under_laws(const Scenario& scenario, const Instances& instances,
                                               const World<D>& world, const WorldLaws& laws) {
  std::vector<CornerUnderLaw> found;
  const int bodies = static_cast<int>(world.bodies.size());
  const auto gives_velocity = [&](int material, int owner) {
    return material >= 0 &&
           form_of(material, laws.key_of(owner), scenario, instances) == RestitutionForm::velocity;
  };
  const auto is_cornered = [&](int i) { return world.bodies[i].moves() && has_corners(world.bodies[i]); };
  for (int i = 0; i < bodies; ++i) {
    for (int part = 0; is_cornered(i) && part < static_cast<int>(parts_of(world.terrain()).size()); ++part)
      if (const int material = laws.material_with_terrain(world, i, part); gives_velocity(material, i))
        found.push_back({material, i});
    for (int j = i + 1; j < bodies && world.settings().body_contacts; ++j) {
      if (!is_cornered(i) && !is_cornered(j)) continue;
      if (const int material = laws.material_between(i, j); gives_velocity(material, i))
        found.push_back({material, is_cornered(i) ? i : j});
    }
  }
  return found;
}

template <int D>
MassRatio mass_ratio(const World<D>& world) {
  if (!world.settings().body_contacts) return {};
  MassRatio found;
  for (int i = 0; i < static_cast<int>(world.bodies.size()); ++i) {
    const Body<D>& body = world.bodies[i];
    if (!body.moves()) continue;
    if (found.heavy < 0 || body.mass > world.bodies[found.heavy].mass) found.heavy = i;
    if (found.light < 0 || body.mass < world.bodies[found.light].mass) found.light = i;
  }
  if (found.heavy >= 0) found.ratio = world.bodies[found.heavy].mass / world.bodies[found.light].mass;
  return found;
}

template std::vector<SpringSwing> spring_swings(const Scenario&, const Instances&, const World<2>&,
                                                const WorldLaws&);
template std::vector<SpringSwing> spring_swings(const Scenario&, const Instances&, const World<3>&,
                                                const WorldLaws&);
template std::vector<CornerUnderLaw> corners_under_laws(const Scenario&, const Instances&, const World<2>&,
                                                        const WorldLaws&);
template std::vector<CornerUnderLaw> corners_under_laws(const Scenario&, const Instances&, const World<3>&,
                                                        const WorldLaws&);
template MassRatio mass_ratio(const World<2>&);
template MassRatio mass_ratio(const World<3>&);

}  // namespace flyrock
