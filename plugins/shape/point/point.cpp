#include "geometry/contactor.h"
#include "geometry/contactor3.h"
#include "plugin/models.h"
#include "plugins/factories.h"
#include "random/stream.h"

namespace flyrock::plugins {

namespace {

class PointMass : public ShapeModel {
 public:
  explicit PointMass(Params&) {}

  std::vector<Contactor2> build(Values, RandomStream&) const override { return {Contactor2::disk(0)}; }
  std::vector<Contactor3> build_3d(Values, RandomStream&) const override { return {Contactor3::sphere(0)}; }
};

}  // namespace

std::unique_ptr<ShapeModel> make_point(Params& params) { return std::make_unique<PointMass>(params); }

}  // namespace flyrock::plugins
