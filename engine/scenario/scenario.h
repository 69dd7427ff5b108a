#pragma once
// The typed scenario: what a run needs, with every unit converted and every name resolved.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "blast/design.h"
#include "document/location.h"
#include "geometry/earthworks.h"
#include "geometry/forest.h"
#include "geometry/height_grid.h"
#include "geometry/plan_region.h"
#include "math/over_time.h"
#include "math/space.h"
#include "plugin/registry.h"
#include "record/last_state.h"
#include "record/link_type.h"
#include "record/series.h"
#include "scenario/ground_store.h"
#include "scenario/observed.h"
#include "scenario/rock_table.h"

namespace flyrock {

enum class Method {
  nscd,
  lumped_mass,  ///< each rock is a point that rebounds from the ground and slides on it
  ballistic     ///< each rock is a point that flies to the first ground it meets
};

/// The name as the scenario writes it.
inline std::string_view name_of(Method method) {
  constexpr std::array<std::string_view, 3> names = {"nscd", "lumped_mass", "ballistic"};
  return names[static_cast<std::size_t>(method)];
}

/// The air that flying rocks pass through.
struct AirPlan {
  Number density;            ///< kg/m3
  Number cd;                 ///< drag coefficient on the sphere of equal volume
  std::vector<Number> wind;  ///< m/s; empty: calm
};

/// The laws of a surface. A law that is absent takes the default: no restitution, no friction, no rolling
/// resistance, signorini.
struct Material {
  std::string name;
  std::optional<PluginUse> restitution, friction, rolling, unilateral;
  std::optional<Number> roughness;               ///< rad, tilt of a face at an impact of a lumped mass
  std::shared_ptr<const OverTime> mu_over_time;  ///< in place of what the friction law answers; null: none
};

/// A region of the terrain with a name of its own. In 2D a stretch from x = `from` to x = `to`; in 3D one of
/// a polygon in plan, the cells of a raster with a value, or an existing part of the terrain, which gets a
/// new name.
struct Zone {
  std::string name;
  double from = 0, to = 0;
  std::vector<Vec2> polygon;
  std::vector<PlanPolygon> polygons;  ///< of a file: all of them together
  std::shared_ptr<const HeightGrid> raster;
  double value = 0;
  std::string group;
};

/// A face that rocks may leave, beside those of the terrain's plugin. In 2D between two places x, of which
/// the higher one is the crest; in 3D a zone.
struct FacePlan {
  std::string name;
  double from = 0, to = 0;
  std::string zone;
};

/// A profile that is cut out of a terrain in 3D.
struct SectionPlan {
  Vec2 from = Vec2::Zero(), to = Vec2::Zero();  ///< m, in plan
};

struct TerrainPlan {
  PluginUse model;                     ///< of a section: of the terrain in 3D
  std::optional<SectionPlan> section;  ///< 2D
  Earthworks works;                    ///< 2D, on top of what the model answers
  std::map<std::string, int>
      material_of_part;  ///< index into Scenario::materials; "" for a terrain of one part
  std::vector<Zone> zones;
  std::vector<FacePlan> faces;
  /// 3D: the place from which the engine counts [m]. Scenario and results have the coordinates of files.
  Vec3 origin = Vec3::Zero();
  double north = pi / 2;                 ///< rad, from +x towards +y: the direction of bearing 0
  std::string crs;                       ///< "EPSG:2056", of the scenario or its file; empty: not known
  std::string survey;                    ///< what was read of its file, "525 cells of 5 m, 2 to 31 m"
  std::string text;                      ///< of all of it, resolved: equal texts make equal grounds
  std::shared_ptr<GroundStore> grounds;  ///< of all points of the sweep
};

/// The burden along a measured hole: the distance from its axis to the surveyed face, by the depth along it.
struct BurdenCurve {
  std::vector<double> depth, burden;  ///< m
  std::vector<bool> is_known;         ///< false: the survey ends there, and the face may be nearer
  double charge_from = 0, charge_to = 0;
};

/// What the survey of the face says of the burdens of the holes.
struct SurveyedFace {
  double noise = std::numeric_limits<double>::quiet_NaN();  ///< m, of its points; NaN: profiles
  double error = std::numeric_limits<double>::quiet_NaN();  ///< m, of the least burden, because of the noise
  std::vector<BurdenCurve> curves;  ///< of each hole; empty of holes behind the front row
};

/// The blast, with the number of each field that is given.
struct BlastPlan {
  std::map<BlastField, Number> fields;
  bool is_anfo = false;
  bool has_mathematical_azimuths = false;  ///< in the table of holes: from +x, not bearings
  bool gurney_follows = false;             ///< the Gurney constant is D/3 and not given separately
  Pattern pattern;                         ///< rock k belongs to hole k mod holes
  Blast typical;       ///< completed, with the medians of all distributions; of a field the median hole
  BlastDesign design;  ///< of the typical blast, or of all holes
  /// What is added to measured holes: to a field, or to the time, of each hole in each trial.
  std::map<BlastField, Number> scatter;
  std::optional<Number> time_scatter;
  std::vector<Blast> holes;  ///< measured holes, completed, with the medians of all distributions
  std::vector<BlastDesign> hole_designs;  ///< of each of them
  std::vector<BlastSources> sources;      ///< of each of them; without measured holes one, of `typical`
  std::set<BlastField> columns;           ///< fields that a measured hole gives
  std::vector<Location> hole_places;      ///< where each of them is written
  std::vector<std::string> other_heads;   ///< of the table of holes, which are no columns

  std::optional<SurveyedFace> face;
  /// What a branch sets: it takes the place of what the measured holes say.
  std::map<BlastField, Number> forced;

  bool has_holes() const { return !pattern.measured.empty(); }
  /// Whether a field is given or follows from other fields.
  bool provides(BlastField field) const { return !std::isnan(typical[field]); }
};

enum class ReleaseKind {
  face,
  collar,     ///< on the bench above, at the collar of the rock's hole
  bench_top,  ///< on the bench above, between the crest and the last row of holes
  above_ground,
  position,
  along,
  inside,
  zone,   ///< 3D: anywhere in a zone
  raster  ///< 3D: anywhere in the cells of a raster that are above 0
};

/// Where a rock starts.
struct Release {
  ReleaseKind kind = ReleaseKind::position;
  int bench = 1;  ///< for face, collar, bench_top: the number of the bench, from 1
  Number x, y,
      above_ground;  ///< for above_ground: height of the centre of mass above the ground at x (and y in 3D)
  std::vector<Number> position;  ///< of the centre of mass
  std::vector<Vec3> points;      ///< along a polyline, or uniform inside a flat polygon; z = 0 in 2D
  std::string face;              ///< for face, collar, bench_top: its name, in place of the number
  std::string zone;
  std::shared_ptr<const HeightGrid> raster;
  std::shared_ptr<const std::vector<std::size_t>> raster_cells;  ///< those of the raster that are above 0
  bool in_plan = false;    ///< 3D: the place is one in plan, at a height above the ground (`above_ground`)
  bool on_ground = false;  ///< 3D: lowered in its attitude until it touches the ground
};

/// The orientation of a body in 3D, which maps body to world, by four numbers as in plugin/turn.h.
struct TurnPlan {
  std::array<Number, 4> numbers;
  bool about_axis = false;
};

/// The launch speed by the size of a rock: that of `launch` times (reference / diameter)^exponent. The
/// diameter is that of the sphere of equal volume (2D: of the circle of equal area). With the exponent 1
/// rocks get the same impulse per area, so that speed x size x density is constant, as in Lundborg's model of
/// the launch.
struct LaunchBySize {
  Number reference;  ///< m
  Number exponent;
  std::optional<Number> at_most;  ///< m/s
};

struct RockGroup {
  std::string name;
  PluginUse population;
  /// Its lines are the rocks of each trial, in place of those of the population; null: none.
  std::shared_ptr<const RockTable> table;
  std::optional<int> per_hole;  ///< rocks of each measured hole, in place of those of the population
  std::vector<int> holes;       ///< with `per_hole`: the holes that have rocks, by their index
  std::optional<PluginUse> shape;
  std::optional<Release> release;
  std::optional<PluginUse> launch;  ///< absent: at rest
  /// The azimuth of the launch is one of a bearing, from +x and not from the face: its slot; -1: it is not.
  int absolute_azimuth = -1;
  std::optional<LaunchBySize> launch_by_size;
  std::optional<double> assumed_elevation;  ///< rad, of a launch whose elevation the scenario does not give
  std::optional<double> weight;       ///< real rocks that a rock stands for; absent: 1, or its population's
  Number density;                     ///< kg/m3
  std::optional<Number> mass;         ///< kg; in place of density
  std::optional<Number> thickness;    ///< m; absent: default_thickness
  std::optional<Number> orientation;  ///< 2D, rad; absent: random and uniform
  std::optional<TurnPlan> turn;       ///< 3D; absent: random and uniform
  std::optional<AirPlan> air;         ///< its own, or that of the scenario; absent: none
  int material = -1;                  ///< for contacts with other rocks; -1: none
};

struct BodyPlan {
  std::string name;
  PluginUse shape;
  std::optional<Number> density, mass, thickness;
  std::vector<Number> position, velocity;
  std::vector<Number> spin;      ///< one number in 2D, three in 3D
  Number orientation;            ///< 2D, rad
  std::optional<TurnPlan> turn;  ///< 3D; absent: in the orientation of the shape's description
  bool fixed = false;
  struct Driven {
    std::vector<double> velocity, spin, acceleration;
  };
  std::optional<Driven> driven;
  std::vector<Number> force;                  ///< N; empty: none
  std::shared_ptr<const OverTime> over_time;  ///< of `force`, or of the velocity of a driven body; null: none
  std::optional<Number> hold;                 ///< s; absent: it is not held
  std::shared_ptr<const LastState> start;     ///< of another run; null: it starts as it is placed
  int material = -1;

  /// Whether forces move it.
  bool is_moved() const { return !fixed && !driven; }
};

/// A link between two bodies, or a body and the terrain (world/links.h).
struct LinkPlan {
  std::string name;
  LinkType type = LinkType::rod;
  int a = -1, b = -1;                 ///< indices of bodies; b = -1: the terrain
  Vec3 end_a = Vec3::Zero();          ///< m, as built; of a hinge both ends
  Vec3 end_b = Vec3::Zero();          ///< m
  Vec3 axis = Vec3::Zero();           ///< of a hinge in 3D
  double length = 0;                  ///< m; of a hinge 0
  double stiffness = 0, damping = 0;  ///< N/m and N s/m, of a spring
};

/// The material between two named things: a body, a group, `terrain` or `terrain.<part>`.
struct PairPlan {
  std::string a, b;
  int material = -1;
};

/// A place where passing rocks are recorded: at x, or in 3D along a line in plan.
struct GatePlan {
  std::string name;
  double x = 0;                 ///< m
  std::vector<Vec2> line = {};  ///< m; empty: at x
};

/// A fence or berm at x, or in 3D along a line in plan. world/places.h describes what it does.
struct BarrierPlan {
  std::string name;
  double x = 0, height = 0;                     ///< m; height: along the barrier
  double capacity = 0;                          ///< J, maximum energy level
  std::vector<Vec2> line = {};                  ///< m; empty: at x
  double inclination = 0;                       ///< rad, from the vertical
  double freeboard = 0;                         ///< m, that stays above a rock
  bool service_level = false;                   ///< holds a third of the capacity
  double energy_factor = 1, height_factor = 1;  ///< partial factors on what rocks bring

  /// The height above the ground that a rock may reach with its top [m].
  double held_height() const { return height * std::cos(inclination) - freeboard; }
  /// The greatest energy of a rock that is caught [J].
  double held_energy() const { return (service_level ? capacity / 3 : capacity) / energy_factor; }
};

/// Trees in 3D: of a file or drawn, once a run. world/tree_law.h describes what they do.
struct ForestPlan {
  std::vector<Stem> stems;  ///< of the file, in its coordinates
  bool is_drawn = false;
  double density = 0;                    ///< of drawn trees, stems a m2
  Number diameter, height;               ///< of drawn trees [m]; their draws are those of this plan
  std::string zone;                      ///< part of the terrain where trees are drawn; empty: all of it
  std::vector<std::string> other_heads;  ///< of the file, which are no columns
  bool is_fixed = false;                 ///< the law: each tree takes the same energy
  double energy = 0;                     ///< J, of that law
  double factor = 1;                     ///< on the energy of each tree
  Number turn;                           ///< rad, at each hit
  std::vector<Draw> draws;
  std::string text;  ///< of all of it, resolved: equal texts over equal grounds make equal trees
};

/// A clearance that a run must compute: the distance that a rock, or the farthest rock of a blast, exceeds
/// with `probability`.
struct ClearancePlan {
  std::string name;
  int group = -1;  ///< index into Scenario::rocks; -1: rocks of all groups
  double probability = 0;
  double confidence = 0.95;           ///< of the interval
  std::optional<double> factor = {};  ///< safety factor; absent: none is applied
  bool per_blast = false;
  bool of_max_distance = false;            ///< use max_distance instead of runout
  int sectors = 0;                         ///< 3D: number of sectors by azimuth; 0: no sectors
  bool least_area = false;                 ///< 3D: also the area of least size
  double radius = 0;                       ///< m, of its kernel; 0: chosen (results/measured/least_area.h)
  std::optional<double> customary = {};    ///< m, the legal or customary distance: the limit of the distance
  std::optional<double> known_throw = {};  ///< m, the farthest throw that is known of the site
  std::optional<double> blasts_per_year = {};
  std::optional<Vec2> about =
      {};  ///< m: origin of distances and azimuths; absent: distances from the hull of all release places

  bool counts(int rock_group) const { return group < 0 || group == rock_group; }
  /// The share of simulated blasts that may go farther, where a rock stands for up to `weight` real ones: 1 -
  /// (1 - p)^(1/w) per blast, so that at most p of the real ones do (results/statistics/blast_bounds.h); else
  /// p.
  double simulated_probability(double weight) const {
    return per_blast && weight > 1 ? -std::expm1(std::log1p(-probability) / weight) : probability;
  }
};

/// People, a vehicle or a building that rocks may hit: at a place, or 3D somewhere along a line in plan.
struct ExposurePlan {
  std::string name;
  Vec2 at = Vec2::Zero();  ///< m, in plan; (x, 0) in 2D
  std::vector<Vec2> line;  ///< m; empty: at one place
  double area = 0;         ///< m2, in plan
  double spread = 0;       ///< rad, 2D: the directions in plan over which rocks are thrown evenly
  double radius = 0;       ///< m, of the kernel; 0: chosen from the landings (results/risk/exposure.h)
  double length = 0;       ///< m, of a vehicle; 0: none is given
  double occupied = 1;     ///< part of the time in which someone is there, on a line in each of its lengths
  bool is_stream = false;  ///< of vehicles, by `vehicles_per_hour`
  double blasts_per_year = 1;
  std::optional<double> limit_per_blast = {}, limit_per_year = {};  ///< probabilities that the user allows
  double energy = 0;                                                ///< J, of the landings that count

  /// A stream of vehicles on a line.
  bool has_traffic() const { return is_stream && !line.empty(); }
  double vehicles_per_metre() const { return occupied / length; }

  /// The least radius of the kernel [m]: under a smaller one, a rock hits the area more than once.
  double least_radius() const { return std::sqrt(2 * area / pi); }
};

/// How far beyond the farthest throw that is known of a site people are kept, by custom.
inline constexpr double beyond_known_throw = 1.5;

enum class FlightMode { exact, stepped };

/// Dense steps (world/dense_step.cpp): when they are made, and what they take where the scenario gives
/// nothing.
struct DensePlan {
  std::string bodies = "auto";             ///< or "exact", "dense"
  double time_step = 4e-3;                 ///< s
  std::optional<double> tolerance = {};    ///< absent: by the stop speed
  std::optional<int> max_iterations = {};  ///< absent: by the number of contacts
};

struct SolverPlan {
  std::string name = "auto";        ///< solver/solve_settings.h
  std::optional<double> time_step;  ///< s; absent: chosen by error (world/step_control.h)
  double step_tolerance = 1e-3;     ///< of chosen steps, a share of a rock's diameter; found by measurement
  double theta = 0.5;
  double tolerance = 1e-7;  ///< found by measurement, see default_tolerance
  int max_iterations = 1000;
  FlightMode flight = FlightMode::exact;
  bool one_by_one = false;   ///< impacts at one instant, not together
  double rest_speed = 0.02;  ///< m/s
  DensePlan dense;
};

struct StopPlan {
  double time = 0;      ///< s
  double speed = 0.05;  ///< m/s
};

/// How bodies settle before time 0 (flight/settle.h).
struct SettlePlan {
  double until = 0;    ///< m/s
  double at_most = 0;  ///< s
};

/// Rows over time (world/series.h).
struct SeriesPlan {
  std::vector<std::string> bodies;  ///< bodies or groups of rocks; empty: all
  bool contacts = true;
  bool meshes = false;  ///< of deformable bodies at each row; else when they are stressed most
  std::vector<RegionBox> regions;
  double every = 0;  ///< s between rows; 0: each step
  int first = 1;     ///< number of trials with series
};

/// The maps of a 3D run (record/maps.h).
struct MapsPlan {
  bool wanted = true;
  double cell = 0;           ///< m; 0: chosen from the ground
  std::vector<Vec2> region;  ///< two opposite corners in plan; empty: the extent of the ground
};

struct OutputPlan {
  int trajectories_first = 100;      ///< number of trials with trajectories
  double trajectories_every = 0.02;  ///< s
  bool impacts = true;
  bool hard_problems = false;        ///< keep each step that did not converge as an FCLIB file
  bool rocks = true;                 ///< whether each rock has a row; else only the first ones
  int first = 1000;                  ///< rocks of a point with rows, where `rocks` is false
  bool envelopes = true;             ///< 2D: whether envelopes are made
  bool rank_outcomes = false;        ///< also rank outcomes of what plugins draw (batch/inputs.h)
  std::optional<SeriesPlan> series;  ///< absent: none
  MapsPlan maps;
};

enum class ExpectKind { equals, below, above, between };
inline constexpr std::array<std::string_view, 4> expect_kind_names = {"equals", "below", "above", "between"};

struct Expectation {
  std::string measure;
  ExpectKind kind = ExpectKind::equals;
  double value = 0, high = 0;      ///< for between: from value to high
  double tolerance = 0;            ///< for equals: absolute
  std::optional<double> relative;  ///< for equals: relative to the value
  /// The values of axes (SI; of choices the index) at which it is judged; empty: at all points
  std::vector<std::pair<std::string, double>> at;
  std::string unit;  ///< SI, of the measure

  /// What is compared is the order of the measure's error: the slope of log |measure - exact| over log of a
  /// swept number.
  struct Order {
    double exact = 0;  ///< SI
    std::string in;    ///< the path of the axis
  };
  std::optional<Order> order;
};

/// What is asked of the points of a sweep (`answer`): the one with the least number of those that keep the
/// limits.
struct AnswerPlan {
  struct Limit {
    std::string measure;
    bool is_below = true;  ///< the measure must be below the value; else above it
    double value = 0;      ///< SI
    std::string unit;      ///< SI, of the measure
  };
  std::string least;  ///< a measure
  std::string unit;   ///< SI, of `least`
  std::vector<Limit> limits;
};

/// Who asked for a run and who answers for it, as the head of the report says.
struct DocumentPlan {
  std::string number, site, client, author, date, checked_by, revision;  ///< empty: not given
  bool signature = false;                                                ///< lines to sign on
};

struct Scenario;

/// What may become of a hole or of a blast, in place of the regular one.
struct BranchPlan {
  std::string name;
  double probability = 0;
  bool per_blast = false;                    ///< of all holes at once; else of each hole
  std::vector<int> holes;                    ///< the measured holes that may take it; empty: all
  std::shared_ptr<const Scenario> scenario;  ///< the regular one with what the branch sets
  std::vector<int>
      own_draw;  ///< of each draw of the regular scenario, its index in this one; -1: it has none

  bool may_happen_to(int hole) const {
    return holes.empty() || std::find(holes.begin(), holes.end(), hole) != holes.end();
  }
};

/// The largest number of trials of all sweep points together.
inline constexpr std::uint64_t most_trials = 1'000'000'000;
/// Each run keeps its numbers in memory.
inline constexpr std::uint64_t most_outer_runs = 10'000;

/// One point of a sweep, fully decoded. All points have the same draws and streams, except where a sweep
/// stands inside a distribution.
struct Scenario {
  std::string title;
  DocumentPlan document;
  int dimension = 2;
  Method method = Method::nscd;
  Streams streams;
  std::uint64_t trials = 1;  ///< of all runs
  /// Runs with equally many trials each, one after the other (results/measured/outer.h).
  std::uint64_t outer = 1;
  bool rock_contacts = false;
  bool body_contacts = true;
  Number gravity;
  std::shared_ptr<const OverTime> gravity_over_time;  ///< m/s2, a vector; null: `gravity`, downwards
  std::optional<AirPlan> air;                         ///< absent: none
  TerrainPlan terrain;
  std::vector<Material> materials;
  std::vector<PairPlan> pairs;
  std::optional<BlastPlan> blast;
  std::vector<RockGroup> rocks;
  std::vector<BodyPlan> bodies;
  std::vector<LinkPlan> links;
  std::vector<BarrierPlan> barriers;
  std::vector<GatePlan> gates;
  std::optional<ForestPlan> forest;
  std::vector<ClearancePlan> clearances;
  std::vector<ExposurePlan> exposures;
  std::optional<ObservedPlan> observed;  ///< absent: nothing is compared
  SolverPlan solver;
  std::optional<SettlePlan> settle;  ///< absent: bodies start as they are placed
  StopPlan stop;
  OutputPlan output;
  std::vector<Expectation> expect;
  std::optional<AnswerPlan> answer;  ///< absent: no point is called best
  std::vector<Draw> draws;
  std::vector<BranchPlan> branches;  ///< exclusive; the rest is regular
  std::vector<std::string> tables;   ///< a line for each table that was read, for `check`

  std::uint64_t trials_of_run() const { return trials / outer; }

  /// Whether a group has a weight. A population may answer weights too.
  bool gives_weights() const {
    return std::any_of(rocks.begin(), rocks.end(),
                       [](const RockGroup& group) { return group.weight.has_value(); });
  }
};

/// What RockRecord::branch counts: "regular", then the branches.
inline std::vector<std::string> branch_names(const Scenario& scenario) {
  std::vector<std::string> names{"regular"};
  for (const BranchPlan& branch : scenario.branches) names.push_back(branch.name);
  return names;
}

/// The names of the groups of rocks, or of the bodies: RockRecord::group counts them.
inline std::vector<std::string> group_names(const Scenario& scenario) {
  std::vector<std::string> names;
  for (const RockGroup& group : scenario.rocks) names.push_back(group.name);
  for (const BodyPlan& body : scenario.bodies) names.push_back(body.name);
  return names;
}

}  // namespace flyrock
