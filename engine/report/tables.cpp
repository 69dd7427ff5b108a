#include "report/tables.h"

#include <fmt/format.h>

#include "batch/chunk.h"
#include "math/space.h"
#include "report/csv.h"
#include "report/hash_data.h"
#include "report/summary_data.h"

namespace flyrock {

std::string rocks_csv_header(const Plan& plan) {
  return fmt::format(
      "point,trial,rock,group,mass_kg,volume_m3,launch_speed_m_s,launch_elevation_deg,stop_reason,censored,"
      "runout_m,max_distance_m,stop_x_m,stop_y_m,{}flight_range_m,bounce_height_m,max_speed_m_s,max_energy_J,"
      "impacts,time_s\n",
      plan.points.front().dimension == 3 ? "stop_z_m," : "");
}

std::string rocks_csv_rows(const Plan& plan, int point, const std::vector<RockRecord>& rocks) {
  const Scenario& scenario = plan.points[static_cast<std::size_t>(point)];
  const std::vector<std::string> groups = group_names(scenario);
  std::string csv;
  for (const RockRecord& rock : rocks) {
    csv += fmt::format("{},{},{},{}", point, rock.trial, rock.rock, csv_text(groups.at(rock.group)));
    const auto number = [&](double value) { (csv += ',') += csv_number(value); };
    number(rock.mass), number(rock.volume), number(rock.launch_speed), number(rock.launch_elevation * 180 / pi);
    csv += fmt::format(",{},{}", name_of(rock.reason), rock.censored ? 1 : 0);
    number(rock.runout), number(rock.max_distance), number(rock.stop_x), number(rock.stop_y);
    if (scenario.dimension == 3) number(rock.stop_z);
    number(rock.flight_range), number(rock.bounce_height), number(rock.max_speed), number(rock.max_energy);
    csv += fmt::format(",{}", rock.impacts);
    number(rock.time);
    csv += '\n';
  }
  return csv;
}

std::string summary_json(const Plan& plan, const Results& results) {
  return summary_data(plan, results).dump(2) + '\n';
}

std::string manifest_json(const LoadedScenario& loaded) {
  using Json = nlohmann::ordered_json;
  const Scenario& first = loaded.plan.points.front();
  const Json manifest = {{"flyrock", FLYROCK_ENGINE_VERSION},
                         {"format", result_format},
                         {"scenario_sha256", loaded.hash},
                         {"seed", first.seed},
                         {"trials", first.trials},
                         {"points", loaded.plan.points.size()},
                         {"chunk_size", chunk_size(first.trials)},
                         {"plugins", hash_data(loaded.sources)},
                         {"files", hash_data(loaded.files)},
                         {"scenario", Json::parse(to_json(loaded.plan.resolved))}};
  return manifest.dump(2) + '\n';
}

std::string run_log(const RunLog& log) {
  const PhaseTimes& t = log.times;
  const auto total = static_cast<double>(t.flight + t.detect + t.solve + t.other);
  std::string text = fmt::format(
      "started  {}\nhost     {}\nthreads  {}\ntrials   {}\nkept     {}\nrocks    {}\nseconds  {:.3f}\n", log.started,
      log.host, log.threads, log.trials, log.kept, log.rocks, log.seconds);
  if (log.seconds > 0) text += fmt::format("rocks/s  {:.1f}\n", static_cast<double>(log.rocks) / log.seconds);
  const auto share = [&](std::string_view name, std::int64_t time) {
    if (total > 0) text += fmt::format("{:<8} {:5.1f} %\n", name, 100 * static_cast<double>(time) / total);
  };
  share("flight", t.flight), share("detect", t.detect), share("solve", t.solve), share("other", t.other);
  const auto wall = [&](std::string_view name, double seconds) {
    text += fmt::format("{:<8} {:.3f} s, {:.1f} % of the wall time\n", name, seconds,
                        100 * seconds / (log.seconds + log.finish_seconds));
  };
  wall("store", log.store_seconds), wall("tables", log.table_seconds + log.finish_seconds);
  text += fmt::format("memory   {:.1f} MB at most\n", static_cast<double>(log.peak_memory) / 1000);
  return text;
}

}  // namespace flyrock
