// The common scenes S1 (a sphere, s1.yaml) and S2 (a polyhedron, s2.yaml) in Bullet: rocks per second to rest
// on one core, and their runout. run.sh builds it where Debian's libbullet-dev (double precision) is
// installed:
//   g++ -O3 -DBT_USE_DOUBLE_PRECISION -I/usr/include/bullet bullet_s12.cpp -lBulletDynamics-float64
//   -lBulletCollision-float64 -lLinearMath-float64 -o bullet_s12 && ./bullet_s12 sphere|scenes/rock20.obj
//   scenes/terrain.obj ROCKS STEP
// Steps of STEP seconds with Bullet's own settings, sleeping off. A rock is at rest when |v| and |w| times
// the radius of the sphere of equal volume stay below 0.05 m/s for 0.2 s, as in flyrock; 15 s at most.

#include <btBulletDynamicsCommon.h>

#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

namespace {

constexpr double radius = 0.5, density = 2700;

struct Obj {
  std::vector<btVector3> points;
  std::vector<int> corners;
};

Obj read_obj(const char* file) {
  Obj obj;
  std::ifstream in(file);
  for (std::string line, key; std::getline(in, line);) {
    std::istringstream row(line);
    row >> key;
    if (double x, y, z; key == "v" && row >> x >> y >> z) obj.points.emplace_back(x, y, z);
    if (key == "f")
      for (std::string corner; row >> corner;) obj.corners.push_back(std::stoi(corner) - 1);
  }
  return obj;
}

/// Uniform in [0, 1), the same on every machine.
double uniform() {
  static unsigned long long state = 1;
  state = state * 6364136223846793005ULL + 1442695040888963407ULL;
  return static_cast<double>(state >> 11) / 9007199254740992.0;
}

/// The runout of one rock [m]. Bullet multiplies the coefficients of two bodies: the ground has 1.
double runout(btCollisionShape& shape, btCollisionShape& terrain, double step) {
  btDefaultCollisionConfiguration configuration;
  btCollisionDispatcher dispatcher(&configuration);
  btDbvtBroadphase broad;
  btSequentialImpulseConstraintSolver solver;
  btDiscreteDynamicsWorld world(&dispatcher, &broad, &solver, &configuration);
  world.setGravity({0, 0, -9.81});
  btRigidBody::btRigidBodyConstructionInfo of_ground(0, nullptr, &terrain);
  of_ground.m_friction = of_ground.m_restitution = 1;
  btRigidBody ground(of_ground);
  world.addRigidBody(&ground);

  const double mass = density * 4 / 3 * SIMD_PI * radius * radius * radius;
  btVector3 inertia(0.4 * mass * radius * radius, 0.4 * mass * radius * radius, 0.4 * mass * radius * radius);
  if (shape.getShapeType() != SPHERE_SHAPE_PROXYTYPE) inertia = {157.999593, 140.645383, 132.921971};
  btRigidBody::btRigidBodyConstructionInfo of_rock(mass, nullptr, &shape, inertia);
  of_rock.m_friction = 0.6;
  of_rock.m_restitution = 0.35;
  const btVector3 axis(uniform() - 0.5, uniform() - 0.5, uniform() - 0.5);
  const double turn = 2 * SIMD_PI * uniform(), y = 10 + 40 * uniform();
  of_rock.m_startWorldTransform = btTransform(btQuaternion(axis.normalized(), turn), {19, y, 62});
  btRigidBody rock(of_rock);
  rock.setActivationState(DISABLE_DEACTIVATION);
  rock.setLinearVelocity({2, 0, -1});
  world.addRigidBody(&rock);

  double still = 0;
  for (double time = 0; time < 15 && still < 0.2; time += step) {
    world.stepSimulation(step, 0);
    const bool slow =
        rock.getLinearVelocity().length() < 0.05 && rock.getAngularVelocity().length() * radius < 0.05;
    still = slow ? still + step : 0;
    if (rock.getWorldTransform().getOrigin().z() < -5) break;
  }
  world.removeRigidBody(&rock);
  world.removeRigidBody(&ground);
  return rock.getWorldTransform().getOrigin().x() - 19;
}

}  // namespace

int main(int count, char** words) {
  if (count != 5) return 2;
  Obj mesh = read_obj(words[2]);
  btTriangleIndexVertexArray triangles(static_cast<int>(mesh.corners.size() / 3), mesh.corners.data(),
                                       3 * sizeof(int), static_cast<int>(mesh.points.size()),
                                       &mesh.points[0][0], sizeof(btVector3));
  btBvhTriangleMeshShape terrain(&triangles, true);
  std::unique_ptr<btConvexShape> shape = std::make_unique<btSphereShape>(radius);
  if (std::string(words[1]) != "sphere") {
    const Obj hull = read_obj(words[1]);
    shape = std::make_unique<btConvexHullShape>(&hull.points[0][0], static_cast<int>(hull.points.size()),
                                                sizeof(btVector3));
  }
  const int rocks = std::atoi(words[3]);
  const double step = std::atof(words[4]);
  double sum = 0;
  const std::clock_t begin = std::clock();
  for (int i = 0; i < rocks; ++i) sum += runout(*shape, terrain, step);
  const double seconds = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
  std::printf("Bullet %s, %g ms: %.1f rocks/s, mean runout %.1f m\n", words[1], 1e3 * step, rocks / seconds,
              sum / rocks);
}
