#include "collision/contact_patch.h"
#include "collision/terrain_contact.h"

namespace flyrock {

void terrain_contacts(const Placed3& contactor, int contactor_index, const Terrain3& terrain, double reach,
                      std::vector<ContactPoint<3>>& out) {
  const Plane& plane = terrain.plane();
  const double radius = contactor.shape.radius;
  const std::size_t begin = out.size();
  for (int i = 0; i < contactor.count(); ++i) {
    const Vec3 p = contactor.point(i);
    const double gap = plane.distance(p) - radius;
    if (gap > reach) continue;
    out.push_back({p - (radius + 0.5 * gap) * plane.normal, plane.normal, gap,
                   feature_id(contactor_index, FeatureKind::vertex, i), feature_id(0, FeatureKind::face, 0)});
  }
  keep_four(out, begin);
}

}  // namespace flyrock
