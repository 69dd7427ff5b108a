#include "results/compare/throws.h"

namespace flyrock {

namespace {

constexpr double usual_cover = 0.95;
constexpr std::size_t least_to_fit = 10;  // fewer blasts have no 95 % to speak of

double ratio(const Throw& one) { return one.measured / one.model; }

CoveringFactor factor_for(double covers, const std::vector<Throw>& throws) {
  std::vector<Bounded> ratios;
  for (const Throw& one : throws) ratios.push_back({ratio(one), false});
  const Sample sample = sample_of(ratios, {{covers}, {{covers, stated_confidence}}});
  return {covers, sample.quantile(covers).value, sample.quantile_interval(covers, stated_confidence)};
}

template <class Is>
Share share_where(const std::vector<Throw>& throws, Is is) {
  std::uint64_t count = 0;
  for (const Throw& one : throws) count += is(one);
  return share_of(count, throws.size());
}

std::optional<SiteFactor> site_factor(const std::vector<Throw>& throws) {
  std::vector<Throw> halves[2];
  for (std::size_t i = 0; i < throws.size(); ++i) halves[i % 2].push_back(throws[i]);
  const auto& [fitted, others] = halves;
  if (others.size() < least_to_fit) return std::nullopt;
  const double factor = factor_for(usual_cover, fitted).factor;
  return SiteFactor{factor, fitted.size(),
                    share_where(others, [&](const Throw& one) { return ratio(one) <= factor; }),
                    others.size()};
}

}  // namespace

ThrowSummary summary_of(const std::vector<Throw>& throws) {
  ThrowSummary summary;
  summary.blasts = throws.size();
  if (throws.empty()) return summary;
  summary.short_of = share_where(throws, [](const Throw& one) { return one.model < one.measured; });
  for (const double covers : {0.5, usual_cover, 0.99}) summary.factors.push_back(factor_for(covers, throws));
  std::vector<double> measured, model;
  PairUnits units;
  for (const Throw& one : throws) {
    units.add(measured.size(), 1);
    measured.push_back(one.measured);
    model.push_back(one.model);
  }
  summary.rank = rank_correlation(model, measured, units);
  summary.rank_interval = summary.rank.interval(stated_confidence);
  summary.site = site_factor(throws);
  return summary;
}

}  // namespace flyrock
