#include "trial/make_links.h"

#include <fmt/format.h>

#include "trial/scenario_error.h"

namespace flyrock {

namespace {

/// A place in the frame of a body, or of the world.
template <int D>
Vec<D> in_frame(const World<D>& world, int body, const Vec<D>& place) {
  if (body < 0) return place;
  const auto pose = world.bodies[static_cast<std::size_t>(body)].pose();
  return pose.r.inverse(Vec<D>(place - pose.x));
}

/// The axis of a hinge in 3D, and two directions at right angles to it, in the frames of both.
void give_axis(const World<3>& world, const Vec3& axis, Link<3>& link) {
  const auto turned = [&](int body, const Vec3& v) {
    return body < 0 ? v : world.bodies[static_cast<std::size_t>(body)].pose().r.inverse(v);
  };
  const Eigen::Matrix3d frame = contact_frame(axis);
  link.axis = turned(link.a, axis);
  link.side = turned(link.a, frame.col(1));
  for (int k = 0; k < 3; ++k) link.frame_b[static_cast<std::size_t>(k)] = turned(link.b, frame.col(k));
}

}  // namespace

template <int D>
void make_links(const Scenario& scenario, World<D>& world) {
  for (std::size_t i = 0; i < scenario.links.size(); ++i) {
    const LinkPlan& plan = scenario.links[i];
    for (const int body : {plan.a, plan.b})
      if (body >= 0 && world.bodies[static_cast<std::size_t>(body)].deformation.moves())
        throw ScenarioError(fmt::format("links.{}.between", i),
                            fmt::format("`{}` is deformable, and links hold rigid bodies only",
                                        scenario.bodies[static_cast<std::size_t>(body)].name));
    const auto place = [&](const Vec3& end) -> Vec<D> {
      return (end - scenario.terrain.origin).template head<D>();
    };
    Link<D> link;
    link.name = plan.name;
    link.type = plan.type;
    link.a = plan.a;
    link.b = plan.b;
    link.end_a = in_frame(world, plan.a, place(plan.end_a));
    link.end_b = in_frame(world, plan.b, place(plan.end_b));
    link.length = plan.length;
    link.stiffness = plan.stiffness;
    link.damping = plan.damping;
    if constexpr (D == 3) {
      if (plan.type == LinkType::hinge) give_axis(world, plan.axis, link);
    } else {
      const auto angle = [&](int body) {
        return body < 0 ? 0 : world.bodies[static_cast<std::size_t>(body)].attitude.angle;
      };
      link.turned = angle(plan.a) - angle(plan.b);
    }
    world.links.add(std::move(link));
  }
}

template void make_links(const Scenario&, World<2>&);
template void make_links(const Scenario&, World<3>&);

}  // namespace flyrock
