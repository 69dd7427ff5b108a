#include "report/envelope_data.h"

#include "report/rounded.h"

namespace flyrock {

namespace {

using Json = nlohmann::ordered_json;

Json group_data(const std::map<std::int64_t, EnvelopeBin>& bins, double width) {
  Json x = Json::array(), count = Json::array();
  for (const auto& [bin, envelope] : bins) {
    x.push_back(rounded(static_cast<double>(bin) * width));
    count.push_back(envelope.rocks());
  }
  Json data = {{"x", x}, {"count", count}};
  for (std::size_t q = 0; q < envelope_quantity_names.size(); ++q) {
    Json& quantity = data[std::string(envelope_quantity_names[q])];
    for (const auto& [name, p] : {std::pair("p50", 0.5), std::pair("p95", 0.95), std::pair("max", 1.0)}) {
      Json values = Json::array();
      for (const auto& [bin, envelope] : bins) values.push_back(rounded(envelope.quantile(static_cast<EnvelopeQuantity>(q), p)));
      quantity[name] = values;
    }
  }
  return data;
}

}  // namespace

Json envelope_data(const PointResult& point) {
  const Envelopes& envelopes = point.totals.envelopes;
  const double width = point.terrain.points.empty() ? 0 : envelope_width(point.terrain);
  Json groups = Json::array({group_data(envelopes.of_all(), width)});
  for (std::size_t g = 1; g < point.groups.size(); ++g)
    groups.push_back(group_data(envelopes.of_group(static_cast<int>(g) - 1), width));
  return {{"width", width}, {"groups", groups}};
}

}  // namespace flyrock
