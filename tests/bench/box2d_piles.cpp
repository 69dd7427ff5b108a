// The piles of tests/analytic/piles_test.cpp in Box2D (Debian: libbox2d-dev), by hand:
//   g++ -O3 tests/bench/box2d_piles.cpp -lbox2d -o /tmp/box2d_piles && /tmp/box2d_piles
// Prints milliseconds of processor time a step and how far the highest box has sunk after 5 s at 1/240 s,
// sleeping off. Box2D: 8 velocity and 3 position iterations, its recommendation. It keeps polygons apart by a
// skin of 2 x 0.005 m less a slop of 0.005 m, so that boxes placed at gap 0 are first pushed apart: what it
// has sunk may be negative.

#include <box2d/box2d.h>

#include <cstdio>
#include <ctime>

struct Pile {
  b2World world{b2Vec2(0, -9.81f)};
  b2Body* top = nullptr;

  Pile() {
    world.SetAllowSleeping(false);
    b2BodyDef ground;
    b2EdgeShape line;
    line.SetTwoSided(b2Vec2(-30, 0), b2Vec2(30, 0));
    b2FixtureDef fixture;
    fixture.shape = &line;
    fixture.friction = 0.6f;
    world.CreateBody(&ground)->CreateFixture(&fixture);
  }
  void add(float x, float y, float width, float height) {
    b2BodyDef definition;
    definition.type = b2_dynamicBody;
    definition.position.Set(x, y);
    b2PolygonShape box;
    box.SetAsBox(width / 2, height / 2);
    b2FixtureDef fixture;
    fixture.shape = &box;
    fixture.density = 2700;
    fixture.friction = 0.6f;
    top = world.CreateBody(&definition);
    top->CreateFixture(&fixture);
  }
  void rest(const char* name) {
    constexpr int steps = 1200;
    const float start = top->GetPosition().y;
    const std::clock_t begin = std::clock();
    for (int k = 0; k < steps; ++k) world.Step(1.0f / 240, 8, 3);
    const double ms = 1e3 * static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC / steps;
    std::printf("%s: %.3g ms a step, sunk by %.3g m\n", name, ms, start - top->GetPosition().y);
  }
};

int main() {
  Pile stack;
  for (int i = 0; i < 10; ++i) stack.add(0, 0.5f + i, 1, 1);
  stack.rest("stack of ten boxes");
  Pile wall;
  for (int row = 0; row < 10; ++row)
    for (int i = 0; i < 10; ++i) wall.add(1.01f * i + (row % 2 ? 0.25f : 0.0f), 0.25f + 0.5f * row, 1, 0.5f);
  wall.rest("wall of a hundred bricks");
}
