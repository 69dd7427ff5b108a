// The norm blocks eota111 and eota221.

#include <fmt/format.h>

#include "geometry/hull.h"
#include "plugin/models.h"
#include "plugins/factories.h"
#include "random/stream.h"

namespace flyrock::plugins {

namespace {

class NormBlock : public ShapeModel {
 public:
  NormBlock(Params& params, const char* name, const Vec3& sides)
      : name_(name), block_(norm_block(sides)), length_(params.slot("length")) {
    params.require_dimension(3);
  }
  std::vector<Contactor3> build_3d(Values values, RandomStream&) const override {
    const double length = values[length_];
    if (!(length > 0))
      throw PluginError(fmt::format("plugin {}: length is {:.6g} m, must be above 0", name_, length));
    Contactor3 block = block_;
    block.scale(length);
    return {block};
  }

 private:
  const char* name_;
  Contactor3 block_;  ///< of length 1
  int length_;
};

}  // namespace

std::unique_ptr<ShapeModel> make_eota111(Params& params) {
  return std::make_unique<NormBlock>(params, "eota111", Vec3(1, 1, 1));
}
std::unique_ptr<ShapeModel> make_eota221(Params& params) {
  return std::make_unique<NormBlock>(params, "eota221", Vec3(1, 1, 0.5));
}

}  // namespace flyrock::plugins
