#include "trial/shape_code.h"

#include <fmt/format.h>

#include "random/stream.h"

namespace flyrock {

namespace {

void add(std::string& bytes, double number) {
  bytes.append(reinterpret_cast<const char*>(&number), sizeof number);
}

template <class Point>
void add_point(std::string& bytes, const Point& point) {
  for (const double coordinate : point) add(bytes, coordinate);
}

void add_circles(std::string&, const Contactor2&) {}
void add_circles(std::string& bytes, const Contactor3& contactor) {
  for (const Contactor3::Circle& circle : contactor.circles) {
    add_point(bytes, circle.centre);
    add_point(bytes, circle.axis);
    add(bytes, circle.radius);
  }
}

template <class Contactor>
std::string code_of(const std::vector<Contactor>& contactors) {
  std::string bytes;
  for (const Contactor& contactor : contactors) {
    bytes += static_cast<char>(contactor.form);
    add(bytes, contactor.radius);
    add(bytes, contactor.outer);
    for (const auto& point : contactor.points) add_point(bytes, point);
    add_circles(bytes, contactor);
  }
  return fmt::format("{:016x}", hash_name(bytes));
}

}  // namespace

std::string shape_code(const std::vector<Contactor2>& contactors) { return code_of(contactors); }
std::string shape_code(const std::vector<Contactor3>& contactors) { return code_of(contactors); }

}  // namespace flyrock
