#include "geometry/contactor3.h"
#include "plugin/models.h"
#include "plugins/factories.h"
#include "random/stream.h"

namespace flyrock::plugins {

namespace {

class PlaneBody : public ShapeModel {
 public:
  explicit PlaneBody(Params& params) { params.require_dimension(3); }

  std::vector<Contactor3> build_3d(Values, RandomStream&) const override {
    return {Contactor3::half_space()};
  }
};

}  // namespace

std::unique_ptr<ShapeModel> make_plane_body(Params& params) { return std::make_unique<PlaneBody>(params); }

}  // namespace flyrock::plugins
