// The cost of one call of a law, in Lua and native: law_call newton_in_lua.lua

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>

#include "host/session.h"
#include "host/share.h"
#include "plugin/contact_law.h"

using namespace flyrock;

namespace {

/// ns a call of a restitution with e_n given, all else by default: the fastest of many batches, since others
/// use the machine too.
double cost_of(const Registry& registry, const std::string& name) {
  const Plugin* plugin = registry.find(PluginKind::restitution, name);
  if (!plugin) throw std::runtime_error("no restitution " + name);
  const PluginSpec& spec = plugin->spec;
  std::vector<ParamValue> params(spec.params.size());
  for (std::size_t i = 0; i < params.size(); ++i)
    if (const auto& text = spec.params[i].default_text) {
      params[i].given = true;
      params[i].text = *text;
    }
  ParamValue& e_n = params.at(static_cast<std::size_t>(spec.find("en")));
  e_n.given = true;
  e_n.numbers = {Number{0, -1}};
  const auto law = make_instance<RestitutionLaw>(PluginUse{plugin, params, dense_slots(params), "bench"}, 2);
  std::vector<double> values(dense_slots(params).size());
  ContactState contact;
  double best = 1e9, sum = 0;
  for (int batch = 0; batch < 50; ++batch) {
    constexpr int calls = 20'000;
    const auto start = std::chrono::steady_clock::now();
    for (int i = 0; i < calls; ++i) {
      contact.approach_speed = values[0] = 1e-5 * i;
      sum += law->impact(values, contact).e_n;
    }
    const std::chrono::duration<double, std::nano> spent = std::chrono::steady_clock::now() - start;
    best = std::min(best, spent.count() / calls);
  }
  if (!(sum > 0)) throw std::runtime_error(name + " answered nothing");
  return best;
}

}  // namespace

int main(int count, char** words) {
  if (count != 2) return 2;
  LuaSession session(share_folder());
  Diagnostics diagnostics;
  session.load_plugin(words[1], words[1], {}, diagnostics);
  if (diagnostics.has_errors()) {
    fmt::print(stderr, "{}", diagnostics.to_text());
    return 2;
  }
  fmt::print("{:.0f} ns in Lua, {:.0f} ns native\n", cost_of(session.registry(), "newton_in_lua"),
             cost_of(session.registry(), "newton"));
}
