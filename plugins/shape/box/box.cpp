#include <fmt/format.h>

#include "geometry/contactor3.h"
#include "plugin/models.h"
#include "plugins/factories.h"
#include "random/stream.h"

namespace flyrock::plugins {

namespace {

class Box : public ShapeModel {
 public:
  explicit Box(Params& params) : size_(params.vector_slot("size")) { params.require_dimension(3); }

  std::vector<Contactor3> build_3d(Values values, RandomStream&) const override {
    const Vec3 size(values[size_], values[size_ + 1], values[size_ + 2]);
    if (!(size.minCoeff() > 0))
      throw PluginError(fmt::format("plugin box: size is [{:.6g}, {:.6g}, {:.6g}] m, each must be above 0",
                                    size.x(), size.y(), size.z()));
    return {Contactor3::box(size)};
  }

 private:
  int size_;
};

}  // namespace

std::unique_ptr<ShapeModel> make_box(Params& params) { return std::make_unique<Box>(params); }

}  // namespace flyrock::plugins
