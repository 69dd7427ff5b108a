#include "scenario/decode_document.h"

#include <fmt/format.h>

#include <algorithm>

#include "scenario/decode_sections.h"
#include "scenario/leaning_holes.h"
#include "scenario/load_table.h"
#include "scenario/measure.h"
#include "scenario/normalise.h"
#include "scenario/plan.h"
#include "scenario/trial_design.h"

namespace flyrock {

namespace {

class DocumentDecoder {
 public:
  DocumentDecoder(DecodeContext& context, const Node& root) : context_(context), root_(root) {}

  Scenario decode() {
    decode_keys();
    if (const auto document = root_.find("document")) decode_head(*document);
    if (const auto air = root_.find("air")) scenario_.air = decode_air(context_, *air);
    check_method();
    const bool flies = scenario_.method == Method::ballistic;
    if (const auto terrain = root_.find("terrain"))
      if (const Value* north = terrain->value->find("north"); north && !north->is_null())
        context_.north = si_of(*north);
    if (const auto materials = root_.find("materials")) {
      scenario_.materials = decode_materials(context_, *materials);
      check_mu_of_points(*materials);
    }
    DecodedTerrain terrain;
    if (const auto node = root_.find("terrain")) {
      terrain = decode_terrain(context_, *node, scenario_.materials, !flies, scenario_.streams.seed);
      scenario_.terrain = terrain.plan;
      scenario_.terrain.north = context_.north;
    }
    if (const auto pairs = root_.find("pairs"))
      scenario_.pairs = decode_pairs(context_, *pairs, scenario_.materials, pair_names(terrain.parts));
    if (const auto blast = root_.find("blast")) {
      const std::size_t errors_before = context_.diagnostics.errors_given();
      scenario_.blast = decode_blast(context_, *blast);
      blast_is_sound_ =
          context_.is_sound(blast->path) && context_.diagnostics.errors_given() == errors_before;
      if (blast_is_sound_) check_hole(context_, *blast, *scenario_.blast, scenario_.terrain);
      context_.has_holes = scenario_.blast->has_holes();
      if (blast_is_sound_ && context_.has_holes && context_.forced_fields.empty())
        warn_of_holes_away_from_faces(context_, *blast, *scenario_.blast, terrain);
    }
    decode_moving(terrain);
    if (const auto barriers = root_.find("barriers"))
      scenario_.barriers = decode_barriers(context_, *barriers, terrain.profile);
    if (const auto gates = root_.find("gates"))
      scenario_.gates = decode_gates(context_, *gates, terrain.profile);
    if (const auto forest = root_.find("forest"))
      scenario_.forest = decode_forest(context_, *forest, terrain);
    if (const auto clearances = root_.find("clearance")) {
      if (!root_.find("rocks"))
        clearances->error(context_.diagnostics, "needs `rocks`, the scenario has none");
      std::vector<std::string> groups;
      for (const RockGroup& group : scenario_.rocks) groups.push_back(group.name);
      scenario_.clearances = decode_clearances(context_, *clearances, groups);
    }
    if (const auto exposures = root_.find("exposure")) {
      scenario_.exposures = decode_exposures(context_, *exposures, terrain.profile);
      check_exposures(*exposures);
    }
    if (const auto observed = root_.find("observed")) decode_measured(*observed);
    scenario_.solver = decode_solver(context_, *root_.find("solver"));
    if (const auto links = root_.find("links")) {
      scenario_.links = decode_links(context_, *links, scenario_.bodies);
      check_links(*links);
    }
    if (const auto settle = root_.find("settle")) {
      scenario_.settle = decode_settle(context_, *settle);
      check_together(*settle);
    }
    if (const auto start = root_.find("start")) start_bodies(*start);
    if (const auto stop = root_.find("stop")) scenario_.stop = decode_stop(context_, *stop);
    scenario_.output = decode_output(context_, *root_.find("output"), names_for_series());
    if (const auto series = root_.find("output")->find("series"))
      if (const auto regions = series->find("regions")) check_together(*regions);
    if (scenario_.observed && !scenario_.output.rocks)
      error_at("observed", "compares each rock, which needs `output.rocks: true`");
    if (const auto expect = root_.find("expect"))
      scenario_.expect = decode_expect(*expect, measure_names(root_, scenario_.dimension));
    if (const auto answer = root_.find("answer"))
      scenario_.answer = decode_answer(*answer, measure_names(root_, scenario_.dimension));
    scenario_.draws = context_.draws;
    scenario_.tables = context_.tables;
    spread_runs();
    cover_draws(root_, scenario_, context_.diagnostics);
    return std::move(scenario_);
  }

 private:
  void error_at(std::string_view key, const std::string& text) {
    if (const auto node = root_.find(key)) node->error(context_.diagnostics, text);
  }

  void decode_keys() {
    const Section section = decode_section(context_, root_, "");
    if (section.given("flyrock") && section.constant("flyrock") != 1)
      error_at("flyrock", "this version reads format 1");
    for (const Method method : {Method::lumped_mass, Method::ballistic})
      if (section.text("method") == name_of(method)) scenario_.method = method;
    if (section.constant("dimension") == 3) scenario_.dimension = context_.dimension = 3;
    scenario_.title = section.text("title");
    scenario_.streams.seed = static_cast<std::uint64_t>(section.constant("seed"));
    scenario_.trials = static_cast<std::uint64_t>(section.constant("trials"));
    if (section.given("outer"))  // a number beyond its limits is already reported
      scenario_.outer = static_cast<std::uint64_t>(
          std::clamp(section.constant("outer"), 1.0, static_cast<double>(most_outer_runs)));
    scenario_.trials *= scenario_.outer;
    scenario_.rock_contacts = section.text("rock_contacts") == "on";
    scenario_.body_contacts = section.text("body_contacts") == "on";
    scenario_.gravity = section.number("gravity");
    scenario_.gravity_over_time = decode_gravity_over_time(root_.find("gravity"), scenario_.dimension);
  }

  void decode_head(const Node& node) {
    const Section section = decode_section(context_, node, "document");
    DocumentPlan& head = scenario_.document;
    head = {section.text("number"),   section.text("site"),
            section.text("client"),   section.text("author"),
            section.text("date"),     section.text("checked_by"),
            section.text("revision"), section.constant("signature") != 0};
  }

  /// Reports what the method cannot do.
  void check_method() {
    if (scenario_.method == Method::nscd) return;
    if (scenario_.gravity_over_time) error_at("gravity", table_of_points);
    if (scenario_.rock_contacts)
      error_at("rock_contacts",
               fmt::format("rocks of the method `{}` are points that never meet", name_of(scenario_.method)));
    if (scenario_.method == Method::lumped_mass) return;
    for (const char* key : {"bodies", "pairs"})
      error_at(key,
               "belongs to `nscd` and `lumped_mass`; `ballistic` flies rocks to the first ground they meet");
  }

  /// Links join bodies, which then move step by step.
  void check_links(const Node& links) {
    if (scenario_.method != Method::nscd)
      links.error(context_.diagnostics, "needs the method `nscd`");
    else if (!root_.find("bodies"))
      links.error(context_.diagnostics, "needs `bodies`, the scenario has none");
    else if (scenario_.solver.dense.bodies == "dense")
      links.error(context_.diagnostics, "a run with links takes no dense steps: `solver.bodies: exact`");
  }

  /// Refuses a key about the bodies of one world where these do not meet.
  void check_together(const Node& key) {
    if (scenario_.method != Method::nscd)
      key.error(context_.diagnostics, "needs the method `nscd`");
    else if (!root_.find("bodies") && !scenario_.rock_contacts)
      key.error(context_.diagnostics, "needs `bodies`, or `rock_contacts: on`");
  }

  /// Bodies start where others ended.
  void start_bodies(const Node& start) {
    if (scenario_.method != Method::nscd)
      start.error(context_.diagnostics, "needs the method `nscd`");
    else if (!root_.find("bodies"))
      start.error(context_.diagnostics, "needs `bodies`, the scenario has none");
    else
      decode_start(context_, start, scenario_.bodies);
  }

  static constexpr const char* table_of_points = "changes over time, which needs the method `nscd`";

  /// Points are under loads that do not change.
  void check_mu_of_points(const Node& materials) {
    if (scenario_.method == Method::nscd) return;
    const std::vector<Node> entries = materials.entries();
    for (std::size_t m = 0; m < scenario_.materials.size(); ++m)
      if (scenario_.materials[m].mu_over_time)
        entries[m].find("friction")->find("mu")->error(context_.diagnostics, table_of_points);
  }

  /// Points take neither forces nor holds.
  void check_bodies_of_points(const Node& bodies) {
    if (scenario_.method == Method::nscd) return;
    for (const Node& body : bodies.items())
      for (const char* key : {"force", "hold"})
        if (const auto node = find_given(body, key))
          node->error(context_.diagnostics, "needs the method `nscd`");
    for (std::size_t i = 0; i < scenario_.bodies.size(); ++i)
      if (const auto& body = scenario_.bodies[i]; body.driven && body.over_time)
        bodies.items()[i].find("driven")->find("velocity")->error(context_.diagnostics, table_of_points);
  }

  /// The names of bodies or groups; none if one of them has no name, which is an error.
  std::vector<std::string> names_for_series() const {
    const auto list = root_.find(root_.find("bodies") ? "bodies" : "rocks");
    const std::vector<std::string> names = element_names(list);
    return list && names.size() == list->items().size() ? names : std::vector<std::string>();
  }

  std::vector<std::string> pair_names(const std::vector<std::string>& parts) const {
    std::vector<std::string> names = element_names(root_.find("bodies"));
    for (const std::string& name : element_names(root_.find("rocks"))) names.push_back(name);
    names.emplace_back("terrain");
    for (const std::string& part : parts)
      if (!part.empty()) names.push_back("terrain." + part);
    return names;
  }

  /// Decodes rocks or bodies.
  void decode_moving(const DecodedTerrain& terrain) {
    const auto rocks = root_.find("rocks"), bodies = root_.find("bodies");
    if (rocks && bodies)
      context_.diagnostics.error(bodies->key_at, bodies->path,
                                 "`bodies` and `rocks` cannot stand in one scenario");
    if (rocks) {
      scenario_.rocks = decode_rocks(context_, *rocks, scenario_.materials, terrain);
      check_group_names(*rocks);
      give_air(*rocks);
      choose_holes(*rocks);
      check_reads(*rocks);
      check_places_of_holes(*rocks);
      check_materials(*rocks, scenario_.rocks, 0,
                      [&](const RockGroup&, const RockGroup&) { return scenario_.rock_contacts; });
    }
    if (bodies) {
      scenario_.bodies = decode_bodies(context_, *bodies, scenario_.materials);
      check_bodies_of_points(*bodies);
      check_materials(*bodies, scenario_.bodies, 1, [&](const BodyPlan& a, const BodyPlan& b) {
        return scenario_.method == Method::nscd && scenario_.body_contacts && (a.is_moved() || b.is_moved());
      });
    }
  }

  /// A group without `air` of its own has that of the scenario.
  void give_air(const Node& rocks) {
    const std::vector<Node> items = rocks.items();
    for (std::size_t g = 0; g < items.size() && g < scenario_.rocks.size(); ++g)
      if (!items[g].find("air")) scenario_.rocks[g].air = scenario_.air;
  }

  /// The holes of the groups `per_hole`: all, or those of `rows` or `holes`.
  void choose_holes(const Node& rocks) {
    if (!scenario_.blast || !blast_is_sound_) return;
    const std::vector<Hole>& holes = scenario_.blast->pattern.measured;
    const std::vector<Node> items = rocks.items();
    for (std::size_t g = 0; g < items.size() && g < scenario_.rocks.size(); ++g) {
      RockGroup& group = scenario_.rocks[g];
      const auto rows = items[g].find("rows"), names = items[g].find("holes");
      if (rows)
        group.holes = holes_named(context_.diagnostics, *rows, holes, true);
      else if (names)
        group.holes = holes_named(context_.diagnostics, *names, holes, false);
      else if (group.per_hole)
        for (std::size_t h = 0; h < holes.size(); ++h) group.holes.push_back(static_cast<int>(h));
      if (group.per_hole && !rows && !names) warn_of_later_rows(items[g], group, holes);
    }
  }

  /// The face is in front of the first row.
  void warn_of_later_rows(const Node& item, const RockGroup& group, const std::vector<Hole>& holes) {
    if (!group.release || group.release->kind != ReleaseKind::face || holes.empty()) return;
    int front = holes.front().row;
    for (const Hole& hole : holes) front = std::min(front, hole.row);
    const auto behind =
        std::count_if(holes.begin(), holes.end(), [&](const Hole& hole) { return hole.row > front; });
    if (behind > 0)
      context_.diagnostics.warning(
          item.find("per_hole")->key_at, item.path + ".per_hole",
          fmt::format("{} of the {} holes stand behind row {}, and their rocks leave from the free face too: "
                      "`rows: [{}]` takes those of the front row alone",
                      behind, holes.size(), front, front));
  }

  /// What hits is told by where rocks first land.
  void check_exposures(const Node& exposures) {
    if (!root_.find("rocks")) exposures.error(context_.diagnostics, "needs `rocks`, the scenario has none");
    if (scenario_.method != Method::ballistic)
      exposures.error(context_.diagnostics,
                      "needs `method: ballistic`: who is hit is told by where rocks first land. Where rocks "
                      "bounce, a gate tells how many pass (`gate.NAME.passed.per_trial`)");
  }

  /// The draws `per: run` of each run of `outer`, and what its numbers need.
  void spread_runs() {
    if (scenario_.outer == 1) return;
    const Node node = *root_.find("outer");
    if (!root_.find("rocks")) node.error(context_.diagnostics, "needs `rocks`, the scenario has none");
    if (!scenario_.output.rocks)
      node.error(context_.diagnostics, "needs the row of each rock: `output.rocks: true`");
    for (Draw& draw : scenario_.draws) draw.trials_of_run = scenario_.trials_of_run();
  }

  void decode_measured(const Node& observed) {
    if (!root_.find("rocks"))
      return observed.error(context_.diagnostics, "is compared with `rocks`, the scenario has none");
    scenario_.observed = decode_observed(context_, observed, scenario_);
  }

  /// Refuses groups with the name of a quantity: `rocks.runout.p95` would be ambiguous.
  void check_group_names(const Node& rocks) {
    const std::vector<std::string> reserved = rock_quantities();
    for (const Node& item : rocks.items())
      if (const auto name = item.find("name"); name && name->value->text())
        if (std::find(reserved.begin(), reserved.end(), *name->value->text()) != reserved.end())
          name->error(context_.diagnostics, "is the name of a measured quantity, a group needs another one");
  }

  /// Checks that velocity models find the fields of the blast that they read. Skipped if the blast has
  /// errors, because its fields are then unknown.
  void check_reads(const Node& rocks) {
    if (!blast_is_sound_) return;
    const std::vector<Node> items = rocks.items();
    for (const Node& item : items) {
      const auto launch = item.find("launch");
      const Value* type = launch ? launch->value->find("type") : nullptr;
      const Plugin* plugin =
          type && type->text() ? context_.registry.find(PluginKind::velocity, *type->text()) : nullptr;
      if (!plugin) continue;
      for (const FieldRead& read : plugin->spec.reads)
        if (const std::string missing = missing_field(read.field);
            asks_for(read, *launch->value) && !missing.empty()) {
          const std::optional<std::size_t> hole = only_hole_without(missing);
          context_.diagnostics.error(
              hole ? scenario_.blast->hole_places[*hole] : launch->key_at, launch->path,
              fmt::format(
                  "{} reads `blast.{}`, which {}", *type->text(), missing,
                  hole ? fmt::format("hole {} does not have", scenario_.blast->pattern.measured[*hole].name)
                       : "the scenario does not give"));
        }
    }
  }

  /// Rocks of a hole need holes, and a place where their hole is if they leave from it.
  void check_places_of_holes(const Node& rocks) {
    const std::vector<Node> items = rocks.items();
    if (items.size() != scenario_.rocks.size() || !blast_is_sound_) return;
    const bool has_holes = scenario_.blast && scenario_.blast->has_holes();
    for (std::size_t g = 0; g < items.size(); ++g) {
      const RockGroup& group = scenario_.rocks[g];
      if (const auto per_hole = items[g].find("per_hole"); per_hole && !has_holes)
        per_hole->error(context_.diagnostics, "needs `blast.holes`, the scenario has none");
      if (!has_holes || !group.release) continue;
      if (group.release->kind == ReleaseKind::bench_top)
        items[g].find("release")->error(
            context_.diagnostics,
            "`bench_top` ends at the last of `blast.rows`; with `blast.holes` expected `collar` or `face`");
      const bool needs_place = group.release->kind == ReleaseKind::collar ||
                               (group.release->kind == ReleaseKind::face && context_.dimension == 3);
      if (!needs_place) continue;
      const std::vector<Hole>& holes = scenario_.blast->pattern.measured;
      for (std::size_t i = 0; i < holes.size(); ++i)
        if (!holes[i].is_placed(context_.dimension)) {
          context_.diagnostics.error(
              scenario_.blast->hole_places[i], items[g].path,
              fmt::format("rocks leave from their hole, and hole {} has no {}", holes[i].name,
                          context_.dimension == 2 ? "`x`" : "`x` and `y`"));
          break;
        }
    }
  }

  /// Whether the plugin reads the field when it is used like this. Its parameters may be wrong.
  static bool asks_for(const FieldRead& read, const Value& use) {
    if (read.always()) return true;
    const Value* chosen = use.find(read.param);
    return chosen && chosen->text() &&
           std::find(read.choices.begin(), read.choices.end(), *chosen->text()) != read.choices.end();
  }

  /// The first hole that has not got a field of the blast, where others have it.
  std::optional<std::size_t> only_hole_without(const std::string& path) const {
    if (!scenario_.blast) return std::nullopt;
    const auto info = std::find_if(blast_fields().begin(), blast_fields().end(),
                                   [&](const BlastFieldInfo& known) { return known.path == path; });
    const std::vector<Blast>& holes = scenario_.blast->holes;
    const auto lacks = [&](const Blast& hole) { return std::isnan(hole[info->field]); };
    const auto first = std::find_if(holes.begin(), holes.end(), lacks);
    if (first == holes.end() || std::all_of(holes.begin(), holes.end(), lacks)) return std::nullopt;
    return static_cast<std::size_t>(first - holes.begin());
  }

  /// The path of a field that a manifest names and the scenario lacks; empty if there is none.
  std::string missing_field(const std::string& field) const {
    for (const BlastFieldInfo& info : blast_fields()) {
      if (field != fmt::format("blast.{}", info.path) && field != fmt::format("blast.{}", info.name))
        continue;
      const bool given = scenario_.blast && scenario_.blast->provides(info.field);
      return given ? std::string() : std::string(info.path);
    }
    return {};
  }

  bool has_pair(const std::string& a, const std::string& b) const {
    return std::any_of(scenario_.pairs.begin(), scenario_.pairs.end(), [&](const PairPlan& pair) {
      return (pair.a == a && pair.b == b) || (pair.a == b && pair.b == a);
    });
  }

  /// Checks that things that meet have a material between them: the same one, or an entry of `pairs`.
  /// `first` is 1 if things of one kind do not meet each other.
  template <class Plan, class Meet>
  void check_materials(const Node& list, const std::vector<Plan>& plans, std::size_t first, Meet meet) {
    const std::vector<Node> items = list.items();
    if (items.size() != plans.size()) return;  // one of them is not a map, which is already reported
    for (std::size_t j = 0; j < plans.size(); ++j)
      for (std::size_t i = 0; i + first <= j; ++i) {
        const Plan& a = plans[i];
        const Plan& b = plans[j];
        const bool same = a.material >= 0 && a.material == b.material;
        if (!meet(a, b) || same || has_pair(a.name, b.name)) continue;
        context_.diagnostics.error(
            items[j].key_at, items[j].path,
            fmt::format("`{}` and `{}` can meet, and nothing says how: expected the same "
                        "`material`, or an entry of `pairs` between them",
                        a.name, b.name));
      }
  }

  DecodeContext& context_;
  const Node& root_;
  Scenario scenario_;
  bool blast_is_sound_ = true;
};

}  // namespace

Scenario decode_document(DecodeContext& context, const Node& root) {
  return DocumentDecoder(context, root).decode();
}

}  // namespace flyrock
