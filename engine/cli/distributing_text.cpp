#include "cli/distributing_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "cli/command.h"
#include "cli/explain_text.h"

namespace flyrock::cli {

namespace {

constexpr std::size_t shown_points = 16;  // of a path

void require_distributable(const Explanation& all) {
  if (all.step > 0) throw InputError("--distributing follows an impact: expected --impact N");
  for (std::size_t i = 0; i < all.contacts.size(); ++i) {
    const ExplainedContact& contact = all.contacts[i];
    if (contact.mu > 0)
      throw InputError(
          fmt::format("--distributing: contact {} has friction, which this law does not know", i + 1));
  }
}

/// The coefficient of an impact's contact that approaches fastest. A contact at which nothing approaches yet
/// has none of its own, as no law was asked there: it takes this one.
double e_of_fastest(const Explanation& all, const std::vector<int>& contacts) {
  const auto approach = [&](int a, int b) {
    return all.contacts[static_cast<std::size_t>(a)].before[0] <
           all.contacts[static_cast<std::size_t>(b)].before[0];
  };
  const int fastest = *std::min_element(contacts.begin(), contacts.end(), approach);
  const double e = all.contacts[static_cast<std::size_t>(fastest)].law.e_n;
  if (!(e > 0))
    throw InputError(fmt::format(
        "--distributing: e_n of contact {} is {:.6g}, expected a coefficient above 0", fastest + 1, e));
  return e;
}

/// Evenly chosen points of a path, with both ends.
std::vector<const DistributingPoint*> samples(const std::vector<DistributingPoint>& path) {
  const std::size_t count = std::min(shown_points, path.size());
  std::vector<const DistributingPoint*> points;
  for (std::size_t k = 0; k < count; ++k)
    points.push_back(&path[count == 1 ? 0 : k * (path.size() - 1) / (count - 1)]);
  return points;
}

}  // namespace

std::vector<DistributedIsland> distribute(const Explanation& all, double exponent) {
  require_distributable(all);
  std::vector<DistributedIsland> islands;
  for (const std::vector<int>& contacts : all.islands) {
    const auto count = static_cast<Eigen::Index>(contacts.size());
    std::vector<Eigen::Index> rows;
    Eigen::VectorXd before(count);
    DistributingSprings springs{exponent, Eigen::VectorXd::Ones(count), Eigen::VectorXd(count)};
    const double e = e_of_fastest(all, contacts);
    for (Eigen::Index i = 0; i < count; ++i) {
      const int contact = contacts[static_cast<std::size_t>(i)];
      rows.push_back(Eigen::Index{contact} * all.rows);
      before[i] = all.contacts[static_cast<std::size_t>(contact)].before[0];
      const double own = all.contacts[static_cast<std::size_t>(contact)].law.e_n;
      springs.restitution[i] = own > 0 ? own : e;
    }
    islands.push_back({contacts, exponent, distributing_path(all.w(rows, rows), before, springs)});
  }
  return islands;
}

std::string text_of(const Explanation& all, const std::vector<DistributedIsland>& islands) {
  std::string text;
  const auto out = std::back_inserter(text);
  for (const DistributedIsland& island : islands) {
    fmt::format_to(
        out,
        "\nthe law of Liu, Zhao and Brogliato, springs F = K d^{0:.6g} of equal K: along the impulse P_i of "
        "the primary contact\n"
        "dP_j/dP_i = (E_j/E_i)^({0:.6g}/{1:.6g}), dE_j = -v_j dP_j (in expansion divided by e_n^2)\n",
        island.exponent, island.exponent + 1);
    fmt::format_to(out, "{:>8}", "primary");
    for (const char* name : {"P", "E", "v"})
      for (const int contact : island.contacts)
        fmt::format_to(out, "{:>13}", fmt::format("{} {}", name, contact + 1));
    fmt::format_to(out, "   (P in N s, E in J, v = v_n in m/s)\n");
    for (const DistributingPoint* point : samples(island.path)) {
      fmt::format_to(out, "{:>8}", island.contacts[static_cast<std::size_t>(point->primary)] + 1);
      for (const Eigen::VectorXd* values : {&point->impulse, &point->energy, &point->velocity})
        for (const double value : *values) fmt::format_to(out, "{:>13.6g}", value + 0.0);
      fmt::format_to(out, "\n");
    }
    for (std::size_t i = 0; i < island.contacts.size(); ++i) {
      const ExplainedContact& contact = all.contacts[static_cast<std::size_t>(island.contacts[i])];
      fmt::format_to(
          out, "{:>8}  P = {:.6g} N s, v_n = {:.6g} m/s; the run ({}): P = {:.6g} N s, v_n = {:.6g} m/s\n",
          island.contacts[i] + 1, island.path.back().impulse[static_cast<Eigen::Index>(i)],
          island.path.back().velocity[static_cast<Eigen::Index>(i)], name_of(contact.law.form),
          contact.impulse[0], contact.after[0]);
    }
  }
  return text;
}

nlohmann::ordered_json json_of(const std::vector<DistributedIsland>& islands) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const DistributedIsland& island : islands) {
    nlohmann::ordered_json contacts = nlohmann::ordered_json::array(), path = contacts;
    for (const int contact : island.contacts) contacts.push_back(contact + 1);
    for (const DistributingPoint* point : samples(island.path))
      path.push_back({{"primary", island.contacts[static_cast<std::size_t>(point->primary)] + 1},
                      {"P_N_s", list_of(point->impulse)},
                      {"E_J", list_of(point->energy)},
                      {"vn_m_s", list_of(point->velocity)}});
    list.push_back({{"contacts", contacts}, {"exponent", island.exponent}, {"path", path}});
  }
  return list;
}

}  // namespace flyrock::cli
