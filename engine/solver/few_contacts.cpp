#include "solver/few_contacts.h"

namespace flyrock {

namespace {

using Row = ContactLcp::Row;

std::vector<ContactLcp::Pair> pairs_of(const FewContacts& problem) {
  std::vector<ContactLcp::Pair> pairs;
  for (int contact = 0; contact < problem.size(); ++contact) {
    pairs.push_back({contact, Row::normal});
    if (!problem.contacts[contact].may_stick()) continue;
    for (const Row row : {Row::forward, Row::back, Row::slip}) pairs.push_back({contact, row});
  }
  return pairs;
}

/// r = columns z: what the impulses are of a unit of each z.
Eigen::MatrixXd impulse_columns(const FewContacts& problem, const std::vector<ContactLcp::Pair>& pairs) {
  Eigen::MatrixXd columns = Eigen::MatrixXd::Zero(problem.q.size(), static_cast<Eigen::Index>(pairs.size()));
  for (Eigen::Index k = 0; k < columns.cols(); ++k) {
    const auto [contact, row] = pairs[static_cast<std::size_t>(k)];
    const FewContacts::Contact& of = problem.contacts[contact];
    if (row == Row::normal) {
      columns(problem.normal(contact), k) = 1;
      if (problem.rows > 1) columns(problem.tangential(contact), k) = -of.slip * of.mu;
    } else if (row != Row::slip) {
      columns(problem.tangential(contact), k) = row == Row::forward ? 1 : -1;
    }
  }
  return columns;
}

}  // namespace

ContactLcp lcp_of(const FewContacts& problem) {
  ContactLcp lcp;
  lcp.pairs = pairs_of(problem);
  lcp.scale = problem.w.size() ? problem.w.diagonal().cwiseAbs().maxCoeff() : 1;
  const auto size = static_cast<Eigen::Index>(lcp.pairs.size());
  lcp.m = Eigen::MatrixXd::Zero(size, size);
  lcp.q = Eigen::VectorXd::Zero(size);
  const Eigen::MatrixXd velocities = problem.w / lcp.scale * impulse_columns(problem, lcp.pairs);
  for (Eigen::Index i = 0; i < size; ++i) {
    const auto [contact, row] = lcp.pairs[static_cast<std::size_t>(i)];
    switch (row) {
      case Row::normal:
        lcp.m.row(i) = velocities.row(problem.normal(contact));
        lcp.q[i] = problem.q[problem.normal(contact)];
        break;
      case Row::forward:
        lcp.m.row(i) = velocities.row(problem.tangential(contact));
        lcp.q[i] = problem.q[problem.tangential(contact)];
        lcp.m(i, i + 2) += 1;
        break;
      case Row::back:
        lcp.m.row(i) = -velocities.row(problem.tangential(contact));
        lcp.q[i] = -problem.q[problem.tangential(contact)];
        lcp.m(i, i + 1) += 1;
        break;
      case Row::slip:
        lcp.m(i, i - 3) = problem.contacts[contact].mu;
        lcp.m(i, i - 2) = -1;
        lcp.m(i, i - 1) = -1;
        break;
    }
  }
  return lcp;
}

Eigen::VectorXd impulses_of(const FewContacts& problem, const ContactLcp& lcp, const Eigen::VectorXd& z) {
  return impulse_columns(problem, lcp.pairs) * z / lcp.scale;
}

}  // namespace flyrock
