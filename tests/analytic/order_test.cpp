// The order of accuracy: error against time step for a slide, a frictional impact and a rocking block. With
// FLYROCK_PICTURES set to a folder, the figure of docs/numerics.md is drawn there from the computed numbers.
#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <cstdlib>
#include <fstream>
#include <functional>

#include "analytic/lab.h"

using namespace flyrock;
using namespace flyrock::lab;

namespace order_test {

namespace {

constexpr double g = 9.81;
const std::vector<double> steps = {1.6e-2, 8e-3, 4e-3, 2e-3, 1e-3, 5e-4, 2.5e-4};

WorldSettings settings_of(double h) {
  WorldSettings settings;
  settings.time_step = h;
  settings.tolerance = 1e-12;
  settings.max_iterations = 10000;
  return settings;
}

/// The worst over starts that shift the event through a step.
double worst(const std::function<double(double)>& error) {
  double most = 0;
  for (int i = 0; i < 16; ++i) most = std::max(most, std::abs(error(i / 16.0)));
  return most;
}

/// Where a block that slides on level ground stops [m].
double slide(double h) {
  const double mu = 0.5;
  return worst([&](double shift) {
    const double v = 2 + shift * mu * g * h;
    Material material(0, mu);
    Bench bench(ground(20), material, settings_of(h));
    bench.add(box(1, 1, 1000, {0, 0.5}));
    bench.world.bodies[0].v = {v, 0};
    return bench.run(1).last.position.x() - v * v / (2 * mu * g);
  });
}

/// Place after a bounce with friction [m], in fixed steps or with exact flight.
double bounce(double h, bool exact) {
  const double mu = 0.2, e = 0.6, radius = 0.1;  // it slips throughout
  return worst([&](double shift) {
    const double fall = 0.4 + shift * h;  // time to the impact
    Material material(e, mu);
    Bench bench(ground(20), material, settings_of(h));
    bench.run_settings.exact_flight = exact;
    bench.add(disk(radius, 1000, {0, radius + 0.5 * g * fall * fall}, {5, 0}));
    const double end = 0.8, left = end - fall, up = e * g * fall;
    const BodyHistory& history = bench.run(end);
    const Vec2 place(5 * fall + (5 - mu * (1 + e) * g * fall) * left,
                     radius + up * left - 0.5 * g * left * left);
    return (history.last.position.head<2>() - place).norm();
  });
}

/// Angle of a block that was released on one corner and rocks towards its base [rad], before the base lands.
double rock(double h) {
  const double b = 0.2, height = 0.6, start = 0.15, end = 0.2;
  const double r = std::hypot(b, height), alpha = std::atan2(b, height), p2 = 3 * g / (4 * r);
  // theta'' = -p^2 sin(alpha - theta), by Runge and Kutta's scheme in steps that leave no error to speak of.
  double theta = start, rate = 0;
  constexpr int parts = 20000;
  const double dt = end / parts;
  const auto slope = [&](double t) { return -p2 * std::sin(alpha - t); };
  for (int i = 0; i < parts; ++i) {
    const double k1 = rate, l1 = slope(theta), k2 = rate + 0.5 * dt * l1, l2 = slope(theta + 0.5 * dt * k1);
    const double k3 = rate + 0.5 * dt * l2, l3 = slope(theta + 0.5 * dt * k2), k4 = rate + dt * l3,
                 l4 = slope(theta + dt * k3);
    theta += dt / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
    rate += dt / 6 * (l1 + 2 * l2 + 2 * l3 + l4);
  }
  REQUIRE(theta > 0);
  Material material(0, 5);
  Bench bench(ground(20), material, settings_of(h));
  const double turn = -start;  // about the right lower corner, which stays at the origin
  bench.add(box(2 * b, 2 * height, 1000, Rotation2::from_angle(turn) * Vec2(-b, height), turn));
  const BodyHistory& history = bench.run(end);
  return std::abs(-history.last.angle - theta);
}

struct Line {
  const char* name;
  const char* color;
  double order;
  std::vector<double> errors;
};

/// The slope of the logarithms by least squares.
double fitted_order(const std::vector<double>& errors) {
  double sx = 0, sy = 0, sxx = 0, sxy = 0;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const double x = std::log(steps[i]), y = std::log(errors[i]);
    sx += x, sy += y, sxx += x * x, sxy += x * y;
  }
  const double n = static_cast<double>(steps.size());
  return (n * sxy - sx * sy) / (n * sxx - sx * sx);
}

void draw(const std::vector<Line>& lines, const std::string& file) {
  constexpr double width = 640, height = 420, left = 70, right = 210, top = 20, bottom = 50;
  const double x0 = std::log10(2e-4), x1 = std::log10(2e-2), y0 = -14, y1 = 0;
  const auto x = [&](double h) { return left + (std::log10(h) - x0) / (x1 - x0) * (width - left - right); };
  const auto y = [&](double error) {
    return height - bottom - (std::log10(std::max(error, 1e-14)) - y0) / (y1 - y0) * (height - top - bottom);
  };
  std::ofstream svg(file);
  svg << fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {} {}\" font-family=\"sans-serif\" "
      "font-size=\"12\">\n"
      "<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n",
      width, height);
  for (int decade = -14; decade <= 0; decade += 2) {
    const double at = y(std::pow(10.0, decade));
    svg << fmt::format(
        "<path d=\"M{} {:.1f}H{}\" stroke=\"#ddd\"/><text x=\"{}\" y=\"{:.1f}\" "
        "text-anchor=\"end\">1e{}</text>\n",
        left, at, width - right, left - 6, at + 4, decade);
  }
  for (const double h : steps)
    svg << fmt::format(
        "<path d=\"M{:.1f} {}V{}\" stroke=\"#eee\"/><text x=\"{:.1f}\" y=\"{}\" "
        "text-anchor=\"middle\">{:g}</text>\n",
        x(h), top, height - bottom, x(h), height - bottom + 16, 1e3 * h);
  svg << fmt::format("<text x=\"{}\" y=\"{}\" text-anchor=\"middle\">time step, ms</text>\n",
                     0.5 * (left + width - right), height - 12);
  svg << fmt::format(
      "<text transform=\"translate(16 {}) rotate(-90)\" text-anchor=\"middle\">error, m or rad</text>\n",
      0.5 * (height - bottom + top));
  for (std::size_t k = 0; k < lines.size(); ++k) {
    std::string path, marks;
    for (std::size_t i = 0; i < steps.size(); ++i) {
      path += fmt::format("{}{:.1f} {:.1f}", i == 0 ? "M" : "L", x(steps[i]), y(lines[k].errors[i]));
      marks += fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"3\" fill=\"{}\"/>", x(steps[i]),
                           y(lines[k].errors[i]), lines[k].color);
    }
    const std::string slope = lines[k].order > 0 ? fmt::format(", slope {:.2f}", lines[k].order) : "";
    svg << fmt::format("<path d=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"1.5\"/>{}\n", path,
                       lines[k].color, marks);
    svg << fmt::format("<text x=\"{}\" y=\"{}\" fill=\"{}\">{}{}</text>\n", width - right + 12,
                       top + 20 + 22 * static_cast<double>(k), lines[k].color, lines[k].name, slope);
  }
  svg << "</svg>\n";
}

}  // namespace

TEST_CASE(
    "a slide and rocking are of second order in the step, impacts in fixed steps of first, exact flight has "
    "no error",
    "[slow]") {
  std::vector<Line> lines = {{"slide to a stop", "#1f77b4", 0, {}},
                             {"rocking block", "#2ca02c", 0, {}},
                             {"impact, fixed steps", "#d62728", 0, {}},
                             {"impact, exact flight", "#7f7f7f", 0, {}}};
  for (const double h : steps) {
    lines[0].errors.push_back(slide(h));
    lines[1].errors.push_back(rock(h));
    lines[2].errors.push_back(bounce(h, false));
    lines[3].errors.push_back(bounce(h, true));
  }
  for (int k : {0, 1, 2}) lines[k].order = fitted_order(lines[k].errors);
  for (const Line& line : lines) {
    std::string errors;
    for (double error : line.errors) errors += fmt::format(" {:.2e}", error);
    UNSCOPED_INFO(line.name << ": slope " << line.order << "," << errors);
  }
  CHECK(lines[0].order == Approx(2).margin(0.1));
  CHECK(lines[1].order == Approx(2).margin(0.1));
  CHECK(lines[2].order == Approx(1).margin(0.15));
  for (const double error : lines[3].errors) CHECK(error < 1e-10);
  if (const char* folder = std::getenv("FLYROCK_PICTURES"))
    draw(lines, std::string(folder) + "/order_of_accuracy.svg");
}

}  // namespace order_test
