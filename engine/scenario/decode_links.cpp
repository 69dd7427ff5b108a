// Links between bodies. None of their values is drawn.

#include <fmt/format.h>

#include <algorithm>

#include "scenario/decode_sections.h"

namespace flyrock {

namespace {

/// A place or direction in the dimension of the scenario.
Vec3 vector_of(const Section& section, std::string_view name) {
  Vec3 vector = Vec3::Zero();
  const std::vector<Number>& numbers = section.vector(name);
  for (std::size_t k = 0; k < std::min<std::size_t>(3, numbers.size()); ++k)
    vector[static_cast<Eigen::Index>(k)] = numbers[k].constant;
  return vector;
}

class LinkDecoder {
 public:
  LinkDecoder(DecodeContext& context, const Node& node, const std::vector<BodyPlan>& bodies)
      : context_(context), node_(node), bodies_(bodies), section_(decode_section(context, node, "links")) {}

  LinkPlan decode() {
    link_.name = section_.text("name");
    for (int k = 0; k < 4; ++k)
      if (section_.text("type") == link_type_names[k]) link_.type = static_cast<LinkType>(k);
    decode_ends();
    const bool is_hinge = link_.type == LinkType::hinge, in_space = context_.dimension == 3;
    expect("at", is_hinge, "of a hinge only");
    expect("ends", !is_hinge, "of a rod, spring or rope: a hinge has one place, `at`");
    expect("axis", is_hinge && in_space, "of a hinge in 3D only");
    for (const char* key : {"stiffness", "damping"})
      if (link_.type != LinkType::spring) refuse(key, "of a spring only");
    if (is_hinge) {
      refuse("length", "of a rod, spring or rope only");
      decode_hinge();
    } else {
      decode_length();
    }
    return link_;
  }

 private:
  void refuse(const char* key, const std::string& whose) {
    if (const auto given = find_given(node_, key)) given->error(context_.diagnostics, "is " + whose);
  }
  void expect(const char* key, bool wanted, const std::string& whose) {
    if (!wanted) return refuse(key, whose);
    if (!node_.find(key))
      node_.error(context_.diagnostics,
                  fmt::format("`{}` is missing, which a {} needs", key, name_of(link_.type)));
  }

  /// The bodies, of which the first is not the terrain.
  void decode_ends() {
    std::vector<std::string> names;
    for (const BodyPlan& body : bodies_) names.push_back(body.name);
    names.emplace_back("terrain");
    const auto between = node_.find("between");
    if (!between || between->items().size() != 2) return;  // already reported
    const std::vector<Node> items = between->items();
    std::vector<int> found;
    for (const Node& item : items) {
      const std::string* name = item.value->text();
      const auto place = name ? std::find(names.begin(), names.end(), *name) : names.end();
      if (place == names.end())
        return item.error(context_.diagnostics,
                          fmt::format("{} is neither a body nor `terrain`{}", shown(*item.value),
                                      name ? suggestion(*name, names) : ""));
      found.push_back(place + 1 == names.end() ? -1 : static_cast<int>(place - names.begin()));
    }
    link_.a = found[0];
    link_.b = found[1];
    const auto moves = [&](int i) { return i >= 0 && bodies_[static_cast<std::size_t>(i)].is_moved(); };
    if (link_.a >= 0 && link_.a == link_.b)
      between->error(context_.diagnostics, "links a body to itself, expected two");
    else if (!moves(link_.a) && !moves(link_.b))
      between->error(context_.diagnostics,
                     "neither of the two can move, expected at least one body that "
                     "forces move");
  }

  void decode_hinge() {
    link_.end_a = link_.end_b = vector_of(section_, "at");
    if (context_.dimension == 2) return;
    link_.axis = vector_of(section_, "axis");
    if (const auto axis = node_.find("axis"); axis && !(link_.axis.norm() > 0))
      axis->error(context_.diagnostics, "has no direction");
    link_.axis.normalize();
  }

  void decode_length() {
    const std::vector<Vec3> ends = section_.points("ends");
    if (ends.size() != 2) {
      if (const auto node = node_.find("ends"))
        node->error(context_.diagnostics,
                    fmt::format("has {} points, expected two: where it holds the first and the second of "
                                "`between`",
                                ends.size()));
      return;
    }
    link_.end_a = ends[0];
    link_.end_b = ends[1];
    const double apart = (ends[0] - ends[1]).norm();
    const auto given = node_.find("length");
    link_.length = given ? section_.constant("length") : apart;
    const Node where = given ? *given : *node_.find("ends");
    const bool is_spring = link_.type == LinkType::spring;
    constexpr double rounding = 1e-9;
    if (is_spring)
      decode_spring();
    else if (!(link_.length > 0))
      where.error(context_.diagnostics, fmt::format("a {} needs a length above 0 m", name_of(link_.type)));
    else if (link_.type == LinkType::rod && std::abs(apart - link_.length) > rounding * link_.length)
      where.error(context_.diagnostics,
                  fmt::format("is {:.9g} m, but its ends are {:.9g} m apart", link_.length, apart));
    else if (link_.type == LinkType::rope && apart > (1 + rounding) * link_.length)
      where.error(context_.diagnostics,
                  fmt::format("is {:.9g} m, but its ends are {:.9g} m apart: a rope is at least as long",
                              link_.length, apart));
  }

  void decode_spring() {
    if (section_.given("stiffness")) link_.stiffness = section_.constant("stiffness");
    if (section_.given("damping")) link_.damping = section_.constant("damping");
    if (link_.stiffness == 0 && link_.damping == 0)
      node_.error(context_.diagnostics, "a spring needs `stiffness`, or `damping`, above 0");
  }

  DecodeContext& context_;
  const Node& node_;
  const std::vector<BodyPlan>& bodies_;
  Section section_;
  LinkPlan link_;
};

}  // namespace

std::vector<LinkPlan> decode_links(DecodeContext& context, const Node& node,
                                   const std::vector<BodyPlan>& bodies) {
  std::vector<LinkPlan> links = decode_list<LinkPlan>(
      node, [&](const Node& item) { return LinkDecoder(context, item, bodies).decode(); });
  // The first of a link is a body.
  for (LinkPlan& link : links) {
    if (link.a >= 0 || link.b < 0) continue;
    std::swap(link.a, link.b);
    std::swap(link.end_a, link.end_b);
  }
  return links;
}

}  // namespace flyrock
