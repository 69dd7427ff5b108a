#include "plugin/module.h"

namespace {

/// A slab twice as long as high; in 3D of square plan.
class MyShape : public flyrock::ShapeModel {
 public:
  explicit MyShape(flyrock::Params& params) : size_(params.slot("size")) {}
  /// The corners of a convex body, counter-clockwise, in its own frame.
  std::vector<flyrock::Contactor2> build(flyrock::Values values, flyrock::RandomStream&) const override {
    const double a = values[size_] / 2, b = values[size_] / 4;
    return {flyrock::Contactor2::polygon({{-a, -b}, {a, -b}, {a, b}, {-a, b}})};
  }
  std::vector<flyrock::Contactor3> build_3d(flyrock::Values values, flyrock::RandomStream&) const override {
    const double size = values[size_];
    return {flyrock::Contactor3::box({size, size, size / 2})};
  }

 private:
  int size_;
};

}  // namespace

FLYROCK_MODULE(table) {
  table[{flyrock::PluginKind::shape, "my_shape"}] = flyrock::FactoryOf<flyrock::ShapeModel>(
      [](flyrock::Params& params) { return std::make_unique<MyShape>(params); });
  return nullptr;
}
