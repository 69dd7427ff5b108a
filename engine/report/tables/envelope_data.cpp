#include "report/tables/envelope_data.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "report/page/rounded.h"

namespace flyrock {

namespace {

using Json = nlohmann::ordered_json;

std::vector<EnvelopeRow> rows_of_group(const EnvelopeBins& bins, double width) {
  std::vector<EnvelopeRow> rows;
  bins.visit([&](std::int64_t number, const EnvelopeBin& bin) {
    EnvelopeRow& row = rows.emplace_back();
    row.x = static_cast<double>(number) * width;
    row.rocks = bin.rocks();
    for (std::size_t q = 0; q < row.levels.size(); ++q)
      for (std::size_t level = 0; level < envelope_levels.size(); ++level)
        row.levels[q][level] = bin.quantile(static_cast<EnvelopeQuantity>(q), envelope_levels[level].second);
  });
  return rows;
}

Json group_data(const std::vector<EnvelopeRow>& rows) {
  Json x = Json::array(), count = Json::array();
  for (const EnvelopeRow& row : rows) {
    x.push_back(rounded(row.x));
    if (row.rocks == std::floor(row.rocks))
      count.push_back(static_cast<std::uint64_t>(row.rocks));
    else
      count.push_back(rounded(row.rocks));
  }
  Json data = {{"x", x}, {"count", count}};
  for (std::size_t q = 0; q < envelope_quantity_names.size(); ++q) {
    Json& quantity = data[std::string(envelope_quantity_names[q])];
    for (std::size_t level = 0; level < envelope_levels.size(); ++level) {
      Json values = Json::array();
      for (const EnvelopeRow& row : rows) values.push_back(rounded(row.levels[q][level]));
      quantity[envelope_levels[level].first] = values;
    }
  }
  return data;
}

}  // namespace

double envelope_width(const PointResult& point) {
  const Profile& profile = point.terrain.profile;
  return profile.points.empty() ? 0 : envelope_width(profile.x_max() - profile.x_min());
}

std::vector<std::vector<EnvelopeRow>> envelope_rows(const PointResult& point) {
  const Envelopes& envelopes = point.totals.envelopes;
  const double width = envelope_width(point);
  std::vector<std::vector<EnvelopeRow>> groups = {rows_of_group(envelopes.of_all(), width)};
  for (std::size_t g = 1; g < point.groups.size(); ++g)
    groups.push_back(rows_of_group(envelopes.of_group(static_cast<int>(g) - 1), width));
  return groups;
}

Json envelope_data(const PointResult& point) {
  Json groups = Json::array();
  for (const std::vector<EnvelopeRow>& rows : envelope_rows(point)) groups.push_back(group_data(rows));
  return {{"width", envelope_width(point)}, {"groups", groups}};
}

}  // namespace flyrock
