// The common scene S3 (s3.yaml) in Box2D: rocks per second to rest on one core, and their runout. run.sh
// builds it where Debian's libbox2d-dev is installed:
//   g++ -O3 box2d_s3.cpp -lbox2d -o box2d_s3 && ./box2d_s3 scenes/profile.txt ROCKS STEP
// Steps of STEP seconds, 8 velocity and 3 position iterations (its recommendation), sleeping off. A rock is
// at rest when |v| and |w| times the radius of the disk of equal area stay below 0.05 m/s for 0.2 s, as in
// flyrock; 15 s at most. Box2D takes no restitution below its own threshold of 1 m/s.

#include <box2d/box2d.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

namespace {

const b2Vec2 outline[] = {{0.599283052f, 0.0138377161f},   {0.40002977f, 0.348831688f},
                          {-0.0387167731f, 0.466227632f},  {-0.460847822f, 0.294404481f},
                          {-0.593065109f, -0.0260703856f}, {-0.375217636f, -0.361107956f},
                          {-0.0633341312f, -0.463853894f}, {0.421309821f, -0.332597627f}};

std::vector<b2Vec2> read_profile(const char* file) {
  std::vector<b2Vec2> points;
  std::ifstream in(file);
  for (std::string line; std::getline(in, line);) {
    std::istringstream row(line);
    if (float x, z; row >> x >> z) points.emplace_back(x, z);
  }
  return points;
}

b2FixtureDef rock_of(const b2Shape& shape) {
  b2FixtureDef fixture;
  fixture.shape = &shape;
  fixture.density = 2700;
  fixture.friction = 0.6f;
  fixture.restitution = 0.35f;
  return fixture;
}

/// The runout of one rock [m].
float runout(const std::vector<b2Vec2>& profile, float angle, float step) {
  b2World world(b2Vec2(0, -9.81f));
  world.SetAllowSleeping(false);
  b2ChainShape chain;  // solid on the right of its direction when it runs from right to left
  const std::vector<b2Vec2> leftwards(profile.rbegin(), profile.rend());
  chain.CreateChain(leftwards.data(), static_cast<int>(leftwards.size()), leftwards.front(),
                    leftwards.back());
  b2BodyDef ground;
  const b2FixtureDef of_ground = rock_of(chain);
  world.CreateBody(&ground)->CreateFixture(&of_ground);

  b2PolygonShape polygon;
  polygon.Set(outline, 8);
  b2BodyDef start;
  start.type = b2_dynamicBody;
  start.position.Set(19, 62);
  start.angle = angle;
  start.linearVelocity.Set(2, -1);
  b2Body* rock = world.CreateBody(&start);
  const b2FixtureDef of_rock = rock_of(polygon);
  rock->CreateFixture(&of_rock);
  const float radius = std::sqrt(rock->GetMass() / 2700 / b2_pi);

  float still = 0;
  for (float time = 0; time < 15 && still < 0.2f; time += step) {
    world.Step(step, 8, 3);
    const bool slow =
        rock->GetLinearVelocity().Length() < 0.05f && std::abs(rock->GetAngularVelocity()) * radius < 0.05f;
    still = slow ? still + step : 0;
    if (rock->GetPosition().x > profile.back().x) break;
  }
  return rock->GetPosition().x - 19;
}

}  // namespace

int main(int count, char** words) {
  if (count != 4) return 2;
  const std::vector<b2Vec2> profile = read_profile(words[1]);
  const int rocks = std::atoi(words[2]);
  const float step = static_cast<float>(std::atof(words[3]));
  double sum = 0;
  const std::clock_t begin = std::clock();
  for (int i = 0; i < rocks; ++i)
    sum += runout(profile, 2 * b2_pi * (static_cast<float>(i) + 0.5f) / static_cast<float>(rocks), step);
  const double seconds = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
  std::printf("Box2D S3, %g ms: %.1f rocks/s, mean runout %.1f m\n", 1e3 * static_cast<double>(step),
              rocks / seconds, sum / rocks);
}
