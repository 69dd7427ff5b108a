#include <fmt/format.h>

#include "geometry/bound.h"
#include "geometry/contactor.h"
#include "geometry/contactor3.h"
#include "plugin/models.h"
#include "plugin/registry.h"
#include "plugin/turn.h"
#include "plugins/factories.h"

namespace flyrock::plugins {

namespace {

/// The place of a part in the frame of the compound: x = at + turn x_of_the_part.
template <int D>
struct PartPose {
  Vec<D> at;
  typename Space<D>::Rotation turn;
};

/// `place`: the slots of a ShapePart before those of its shape.
template <int D>
PartPose<D> pose_of(const ShapePart& part, Values place) {
  if constexpr (D == 2)
    return {Vec2(place[0], place[1]), Rotation2::from_angle(place[2])};
  else
    return {Vec3(place[0], place[1], place[2]), turn_of(place.subspan<3, 4>(), part.about_axis)};
}

void move_to(Contactor2& contactor, const PartPose<2>& pose) {
  for (Vec2& point : contactor.points) point = pose.at + pose.turn * point;
  for (Vec2& normal : contactor.normals) normal = pose.turn * normal;
  contactor.bound = bound_of(contactor.points, contactor.radius);
}
void move_to(Contactor3& contactor, const PartPose<3>& pose) {
  const Rotation3 back = pose.turn.inverse();
  contactor.change_frame(-(back * pose.at), back);
}

class Compound : public ShapeModel {
 public:
  explicit Compound(Params& params) : dimension_(params.dimension()) {
    int slot = 0;
    const std::vector<ShapePart>& parts = params.shapes("parts", slot);
    if (parts.empty()) throw PluginError("plugin compound: has no parts, expected at least one");
    for (const ShapePart& part : parts) {
      parts_.push_back({part, make_instance<ShapeModel>(part.shape, dimension_), slot});
      slot += static_cast<int>(ShapePart::place_slots(dimension_) + part.shape.slots.size());
    }
  }

  std::vector<Contactor2> build(Values values, RandomStream& rng) const override {
    return assemble<2>(values, rng);
  }
  std::vector<Contactor3> build_3d(Values values, RandomStream& rng) const override {
    return assemble<3>(values, rng);
  }

 private:
  struct Part {
    ShapePart part;
    std::unique_ptr<ShapeModel> model;
    int slot = 0;  ///< the first one
  };

  template <int D>
  static ShapeAnswer<D> ask(const ShapeModel& shape, Values values, RandomStream& rng) {
    if constexpr (D == 2)
      return shape.shape(values, rng);
    else
      return shape.shape_3d(values, rng);
  }

  template <int D>
  decltype(ShapeAnswer<D>::contactors) assemble(Values values, RandomStream& rng) const {
    constexpr std::size_t before = ShapePart::place_slots(D);
    decltype(ShapeAnswer<D>::contactors) contactors;
    for (std::size_t i = 0; i < parts_.size(); ++i) {
      const ShapePart& part = parts_[i].part;
      const Values slots = values.subspan(static_cast<std::size_t>(parts_[i].slot));
      const PartPose<D> pose = pose_of<D>(part, slots.first(before));
      ShapeAnswer<D> shape = ask<D>(*parts_[i].model, slots.subspan(before, part.shape.slots.size()), rng);
      if (shape.own.given())
        throw PluginError(
            fmt::format("plugin compound: parts.{} ({}) answers with a mass of its own, expected parts whose "
                        "volume gives mass, centre and inertia",
                        i, part.shape.plugin->spec.name));
      if (shape.pneumatic)
        throw PluginError(
            fmt::format("plugin compound: parts.{} ({}) changes its radius, expected rigid parts", i,
                        part.shape.plugin->spec.name));
      if (shape.deformable)
        throw PluginError(fmt::format("plugin compound: parts.{} ({}) is deformable, expected rigid parts", i,
                                      part.shape.plugin->spec.name));
      for (auto& contactor : shape.contactors) {
        if (is_hollow(contactor.form))
          throw PluginError(
              fmt::format("plugin compound: parts.{} ({}) is touched from inside only, expected solid parts",
                          i, part.shape.plugin->spec.name));
        if (contactor.form == Form::outline)
          throw PluginError(
              fmt::format("plugin compound: parts.{} ({}) is a surface, expected a body of its own for it", i,
                          part.shape.plugin->spec.name));
        move_to(contactor, pose);
        contactors.push_back(std::move(contactor));
      }
    }
    return contactors;
  }

  int dimension_;
  std::vector<Part> parts_;
};

}  // namespace

std::unique_ptr<ShapeModel> make_compound(Params& params) { return std::make_unique<Compound>(params); }

}  // namespace flyrock::plugins
