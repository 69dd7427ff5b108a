#include "scenario/schema.h"

#include <fmt/format.h>

#include <stdexcept>

#include "blast/blast.h"
#include "document/wording.h"
#include "scenario/scenario.h"
#include "units/units.h"

namespace flyrock {

namespace {

constexpr UsualRange usual_firing{0, 20};  // of a hole after the first [s]
constexpr UsualRange usual_delay{0, 1};    // between holes or rows [s]

ParamSpec key(ParamType type, std::string name, std::string unit, std::string doc) {
  ParamSpec spec;
  spec.type = type;
  spec.name = std::move(name);
  spec.unit = std::move(unit);
  if (!spec.unit.empty()) spec.dimension = parse_unit(spec.unit).value().dimension;
  spec.doc = std::move(doc);
  return spec;
}

ParamSpec number(std::string name, std::string unit, std::string doc) {
  return key(ParamType::number, std::move(name), std::move(unit), std::move(doc));
}
ParamSpec integer(std::string name, std::string doc) {
  ParamSpec spec = key(ParamType::integer, std::move(name), "", std::move(doc));
  spec.max = 1e9;  // fits into an int
  return spec;
}
ParamSpec boolean(std::string name, bool value, std::string doc) {
  ParamSpec spec = key(ParamType::boolean, std::move(name), "", std::move(doc));
  spec.default_number = value;
  return spec;
}
ParamSpec text(std::string name, std::string doc) {
  return key(ParamType::text, std::move(name), "", std::move(doc));
}
ParamSpec choice(std::string name, std::vector<std::string> choices, std::string doc) {
  ParamSpec spec = key(ParamType::choice, std::move(name), "", std::move(doc));
  spec.choices = std::move(choices);
  return spec;
}
ParamSpec vector(std::string name, std::string unit, std::string doc) {
  return key(ParamType::vector, std::move(name), std::move(unit), std::move(doc));
}
ParamSpec plan_points(std::string name, std::string doc) {
  return key(ParamType::plan_points, std::move(name), "m", std::move(doc));
}
ParamSpec file(std::string name, std::string doc) {
  return key(ParamType::file, std::move(name), "", std::move(doc));
}
ParamSpec points(std::string name, std::string doc) {
  return key(ParamType::points, std::move(name), "m", std::move(doc));
}

ParamSpec optional(ParamSpec spec) {
  spec.optional = true;
  return spec;
}
template <auto member, class V>
ParamSpec with(ParamSpec spec, V value) {
  spec.*member = std::move(value);
  return spec;
}
ParamSpec at_least(ParamSpec spec, double limit) { return with<&ParamSpec::min>(std::move(spec), limit); }
ParamSpec at_most(ParamSpec spec, double limit) { return with<&ParamSpec::max>(std::move(spec), limit); }
ParamSpec above(ParamSpec spec, double limit) { return with<&ParamSpec::above>(std::move(spec), limit); }
ParamSpec below(ParamSpec spec, double limit) { return with<&ParamSpec::below>(std::move(spec), limit); }
ParamSpec usually(ParamSpec spec, const std::optional<UsualRange>& range) {
  return with<&ParamSpec::usual>(std::move(spec), range);
}
ParamSpec or_else(ParamSpec spec, double value) {
  return with<&ParamSpec::default_number>(std::move(spec), value);
}
ParamSpec or_else(ParamSpec spec, const char* value) {
  return with<&ParamSpec::default_text>(std::move(spec), value);
}
ParamSpec or_else(ParamSpec spec, std::vector<double> values) {
  return with<&ParamSpec::default_vector>(std::move(spec), std::move(values));
}
/// A number, or this word, which is the default.
ParamSpec or_word(ParamSpec spec, const char* word) {
  spec.choices = {word};
  return or_else(std::move(spec), word);
}

SectionSpec document() {
  return {"",
          {integer("flyrock", "format version"), or_else(text("title", "what the scenario is about"), ""),
           at_most(at_least(integer("dimension", "2: a vertical plane; 3: space"), 2), 3),
           choice("method", {"nscd", "lumped_mass", "ballistic"}, "how rocks move"),
           or_else(at_most(at_least(integer("seed", "of all random numbers"), 0), greatest_whole), 1),
           or_else(at_least(integer("trials", "realisations of each sweep point"), 1), 1),
           optional(choice("sampling", {"random", "latin_hypercube", "sobol"},
                           "how trials cover the draws of which each has one; random")),
           optional(at_most(
               at_least(integer("outer", "runs of so many trials, each with its own draws `per: run`; 1"), 1),
               static_cast<double>(most_outer_runs))),
           or_else(choice("rock_contacts", {"off", "on"}, "on: rocks also meet each other"), "off"),
           or_else(choice("body_contacts", {"on", "off"}, "off: bodies meet the terrain only"), "on"),
           or_else(at_most(at_least(number("gravity", "m/s2", "along -y in 2D, -z in 3D"), 0), 1000), 9.81)},
          {"document",  "include",  "plugins",  "air",    "terrain",  "materials", "pairs",
           "blast",     "branches", "rocks",    "bodies", "barriers", "gates",     "forest",
           "clearance", "exposure", "observed", "solver", "stop",     "output",    "sweep",
           "expect",    "answer",   "settle",   "shapes", "links",    "start"}};
}

/// Of a terrain.
ParamSpec north() {
  return at_most(
      at_least(optional(number("north", "rad", "where bearing 0 points, from +x towards +y; 90 deg")),
               -2 * pi),
      2 * pi);
}

/// Of a ditch or a bund.
ParamSpec slope_of_sides(double degrees) {
  return at_most(
      above(or_else(number("slope", "rad", fmt::format("of its sides; {} deg", degrees)), degrees * pi / 180),
            0),
      pi / 2);
}

/// In place of an azimuth.
ParamSpec bearing(const std::string& doc) {
  return at_most(
      at_least(optional(number("bearing", "rad", doc + ", clockwise from north; or `azimuth`")), -2 * pi),
      2 * pi);
}

/// Of a body that forces move.
ParamSpec force_on_body() { return optional(vector("force", "N", "constant, at the centre of mass")); }
ParamSpec hold_of_body() {
  return at_least(optional(number("hold", "s", "until when it stands; it then has its velocity")), 0);
}

/// The fields of the blast below `prefix` ("" or "hole."), from the table that velocity models also use.
std::vector<ParamSpec> blast_keys(std::string_view prefix) {
  std::vector<ParamSpec> keys;
  for (const BlastFieldInfo& info : blast_fields()) {
    std::string_view path = info.path;
    if (!path.starts_with(prefix)) continue;
    path.remove_prefix(prefix.size());
    if (path.find('.') != std::string_view::npos) continue;
    ParamSpec spec = usually(
        optional(number(std::string(path), std::string(info.unit), std::string(info.doc))), info.usual);
    const bool may_be_zero =
        info.field == BlastField::hole_stemming || info.field == BlastField::hole_subdrilling;
    if (info.field == BlastField::hole_deviation)
      keys.push_back(std::move(spec));  // negative away from the face
    else if (info.field == BlastField::hole_dip)
      keys.push_back(at_most(above(std::move(spec), 0), pi));
    else if (info.field == BlastField::hole_azimuth) {
      keys.push_back(at_most(at_least(std::move(spec), -2 * pi), 2 * pi));
      keys.push_back(bearing("direction in plan to which the hole leans downwards"));
    } else
      keys.push_back(may_be_zero ? at_least(std::move(spec), 0) : above(std::move(spec), 0));
  }
  return keys;
}

/// The columns of a table of holes, also the keys of a hole in a list.
std::vector<ParamSpec> hole_keys() {
  std::vector<ParamSpec> keys{optional(text("hole", "its name; else its number, from 1")),
                              at_least(or_else(integer("row", "from 1, the front row"), 1), 1),
                              optional(number("x", "m", "of the collar")),
                              optional(number("y", "m", "of the collar; not read in 2D")),
                              optional(number("z", "m", "of the collar; else on the ground"))};
  for (ParamSpec& spec : blast_keys("hole.")) keys.push_back(std::move(spec));
  for (ParamSpec& spec : blast_keys(""))
    if (spec.name.starts_with("burden") || spec.name == "spacing") keys.push_back(std::move(spec));
  for (const char* name : {"toe_x", "toe_y", "toe_z"})
    keys.push_back(optional(number(name, "m", "of the toe, in place of length, dip and bearing")));
  keys.push_back(usually(at_least(or_else(number("time", "s", "when it goes off"), 0.0), 0), usual_firing));
  return keys;
}

/// What may be added to the numbers of a hole: no places, no names and no bearing, which goes the other way.
std::vector<ParamSpec> scatter_keys() {
  std::vector<ParamSpec> keys;
  for (const ParamSpec& column : hole_keys())
    if (column.type == ParamType::number && column.name.size() > 1 && !column.name.starts_with("toe_") &&
        column.name != "bearing")
      keys.push_back(optional(number(column.name, column.unit, "added to " + column.name + " of each hole")));
  return keys;
}

/// Heads of a table that are not the names of its columns.
std::vector<ParamSpec> head_keys(const std::vector<ParamSpec>& columns) {
  std::vector<ParamSpec> keys;
  for (const ParamSpec& column : columns) keys.push_back(optional(text(column.name, "its head")));
  return keys;
}

std::vector<ParamSpec> mass_keys() {
  return {above(usually(optional(number("density", "kg/m3", "of the rock; or `mass`")), usual::density), 0),
          above(optional(number("mass", "kg", "of the rock; or `density`")), 0)};
}

/// The mass of rocks, whose table may say it.
std::vector<ParamSpec> mass_keys_of_rocks() {
  std::vector<ParamSpec> keys = mass_keys();
  keys.front().choices = {from_table};
  return keys;
}

/// A table of rocks, which takes the place of `per_trial`.
ParamSpec table() {
  return optional(file("table", "a line of heads, then a line for each rock of every trial"));
}

ParamSpec per_hole() {
  return at_least(
      optional(integer("per_hole", "rocks of each hole of `blast.holes`, in place of `per_trial`")), 1);
}

ParamSpec weight() {
  return above(optional(number("weight", "", "the number of real rocks that a rock stands for")), 0);
}

ParamSpec thickness() {
  return above(
      optional(number("thickness", "m", "by default that of the sphere of equal cross-section area")), 0);
}

ParamSpec spin(std::string doc) {
  return usually(or_else(key(ParamType::spin, "spin", "rad/s", std::move(doc)), 0.0), usual::spin);
}

/// The launch speed by the size of a rock.
std::vector<ParamSpec> launch_by_size_keys() {
  return {
      above(usually(number("reference", "m", "diameter of the rocks that start with the speed of `launch`"),
                    UsualRange{0.001, 20}),
            0),
      at_most(at_least(
                  or_else(number("exponent", "", "n of (reference / diameter)^n, the factor on it"), 1.0), 0),
              4),
      above(optional(usually(number("at_most", "m/s", "no rock is faster"), usual::launch)), 0)};
}

std::vector<ParamSpec> joined(std::vector<ParamSpec> first, std::vector<ParamSpec> second) {
  for (ParamSpec& spec : second) first.push_back(std::move(spec));
  return first;
}

/// How high a rock starts at a place in plan in 3D.
std::vector<ParamSpec> heights() {
  return {
      at_least(optional(number("above_ground", "m", "height of the centre of mass above the ground")), 0),
      boolean("on_ground", false, "lowered in its attitude until it touches the ground; or `above_ground`")};
}

/// Where a gate or barrier stands in 3D.
std::vector<ParamSpec> lines(const std::string& what) {
  return {text("name", "of the " + what), optional(number("x", "m", "where it stands, across x")),
          optional(plan_points("line", "in plan, along which it stands; in place of `x`"))};
}

/// What is exposed at a place, and how often.
std::vector<ParamSpec> exposure_keys() {
  return {
      at_most(above(or_else(number("area", "m2", "in plan: of a person, a vehicle, a roof"), 0.5), 0), 1e4),
      at_most(above(optional(number("occupied", "", "part of the time in which someone is there; 1")), 0), 1),
      above(optional(number("vehicles_per_hour", "", "both ways; with `length` and `speed`")), 0),
      above(optional(number("length", "m", "of a vehicle")), 0),
      above(optional(number("speed", "m/s", "of the vehicles")), 0),
      above(or_else(number("blasts_per_year", "", "for the probability per year"), 1.0), 0),
      at_most(above(optional(number("limit_per_blast", "", "probability that a blast may have at most")), 0),
              1),
      at_most(above(optional(number("limit_per_year", "", "probability that a year may have at most")), 0),
              1),
      at_least(or_else(number("energy", "J", "of the landings that count, at least"), 0.0), 0)};
}

std::vector<ParamSpec> barrier_keys() {
  return {above(usually(number("height", "m", "from its foot to its top"), usual::barrier_height), 0),
          above(usually(number("capacity", "J", "energy that it takes: the maximum energy level"),
                        usual::barrier_capacity),
                0),
          or_else(below(at_least(number("inclination", "rad", "from the vertical"), 0), pi / 2), 0.0),
          or_else(at_least(number("freeboard", "m", "that must stay free above a rock"), 0), 0.0),
          or_else(choice("level", {"mel", "sel"}, "maximum or service energy level: sel holds capacity/3"),
                  "mel"),
          or_else(above(number("energy_factor", "", "partial factor on the energy of rocks"), 0), 1.0),
          or_else(above(number("height_factor", "", "partial factor on the height of rocks"), 0), 1.0)};
}

/// What a tree does to a rock (world/tree_law.h).
std::vector<ParamSpec> tree_law_keys() {
  return {
      or_else(choice("law", {"dorren_berger", "fixed"},
                     "the energy that a tree takes: by its diameter and the eccentricity of the hit "
                     "(unverified), or the same for each tree"),
              "dorren_berger"),
      at_least(optional(number("energy", "J", "that a tree takes at most, with `law: fixed`")), 0),
      or_else(at_least(number("energy_factor", "", "on the energy that each tree takes"), 0), 1.0),
      or_else(
          at_most(at_least(number("turn", "rad", "of the direction at a hit, away from the stem"), -pi), pi),
          0.0)};
}

/// What a rock of a table, or a measured place, is called.
std::vector<ParamSpec> label_columns() {
  return {optional(text("name", "of the rock; a measured place has the name of its rock")),
          optional(text("group", "a label of rocks that belong together"))};
}

std::vector<ParamSpec> make_rock_columns() {
  const auto length = [](const char* name, std::string doc) {
    return above(usually(optional(number(name, "m", std::move(doc))), UsualRange{0.001, 20}), 0);
  };
  std::vector<ParamSpec> keys = label_columns();
  keys.push_back(above(optional(number("mass", "kg", "of the rock")), 0));
  for (const char* name : {"l1", "l2", "l3"}) keys.push_back(length(name, "a length of its bounding box"));
  keys.push_back(length("diameter", "of the sphere of equal volume, in place of the lengths"));
  for (const char* name : {"x", "y", "z"})
    keys.push_back(optional(number(name, "m", "of the centre of mass; not `y` in 2D")));
  for (const char* name : {"vx", "vy", "vz"})
    keys.push_back(optional(number(name, "m/s", "of its velocity; not `vy` in 2D")));
  return keys;
}

std::vector<ParamSpec> make_observed_columns() {
  std::vector<ParamSpec> keys = label_columns();
  for (const char* name : {"x", "y", "z"})
    keys.push_back(optional(number(name, "m", "of the place where it stopped; not `y` in 2D")));
  keys.push_back(at_least(optional(number("distance", "m", "from its start, in place of the place")), 0));
  return keys;
}

std::vector<SectionSpec> make_sections() {
  return {
      document(),
      {"branches",
       {text("name", "of the branch"),
        below(above(number("probability", "", "that it happens to a hole, or to a blast"), 0), 1),
        or_else(choice("per", {"hole", "blast"}, "what it happens to"), "hole")},
       {"set", "holes"}},
      {"air",
       // Bounded, because the steps of a flight shrink as the drag grows.
       {or_else(at_most(above(number("density", "kg/m3", "of the air"), 0), 100), 1.225),
        usually(
            at_most(at_least(number("cd", "", "drag coefficient, on the sphere of equal volume"), 0), 100),
            usual::drag_coefficient),
        optional(vector("wind", "m/s", "calm where it is not given"))},
       {}},
      {"terrain",
       {optional(text("material", "of a terrain of one part")), north()},
       {"type", "materials", "zones", "faces", "ditch", "bund"}},
      {"terrain 3D",
       {optional(
            vector("origin", "m",
                   "from which the engine counts, in whole metres; where it is not given, the lower left "
                   "corner of triangles or heights beyond 10 km, rounded down to 100 m")),
        optional(text("crs", "EPSG:n, the coordinate system; of the file where it is not given")), north()},
       {"zones", "faces"}},
      {"terrain: section",
       {vector("from", "m", "place in plan where x = 0"), vector("to", "m", "place in plan where it ends")},
       {"of"}},
      {"terrain.ditch",
       {number("x", "m", "where its near edge is"), above(number("width", "m", "of its level bottom"), 0),
        above(number("depth", "m", "of the bottom below the ground at its near edge"), 0),
        slope_of_sides(45)},
       {}},
      {"terrain.bund",
       {optional(number("x", "m", "where its near foot is; or by `distance` from a ditch")),
        optional(at_least(number("distance", "m", "from the far edge of the ditch; 0"), 0)),
        above(number("height", "m", "above the ground at its near foot"), 0),
        or_else(at_least(number("top", "m", "width of its level top"), 0), 1), slope_of_sides(37)},
       {}},
      {"layer",
       {file("layer", "of a GIS or of CAD, read by GDAL: GeoPackage, shapefile, KML, DXF, GeoJSON"),
        optional(text("name", "of the layer, where the file has several"))},
       {"where"}},
      {"terrain.zones",
       {text("name", "its part, in `materials`"), number("from", "m", "least x"),
        number("to", "m", "greatest x")},
       {}},
      {"terrain.zones: polygon 3D",
       {text("name", "its part, in `materials`"), plan_points("polygon", "its outline in plan")},
       {}},
      {"terrain.zones: geojson 3D",
       {text("name", "its part, in `materials`"), file("geojson", "polygons in metres"),
        optional(text("property", "of its features; all features where it is not given")),
        optional(text("is", "the value of `property`"))},
       {}},
      {"terrain.zones: raster 3D",
       {text("name", "its part, in `materials`"), file("raster", "a grid, as of the terrain `raster`"),
        number("value", "", "of the cells that belong to it")},
       {}},
      {"terrain.zones: group 3D",
       {text("name", "its part, in `materials`"), text("group", "the part that it takes the place of")},
       {}},
      {"terrain.faces",
       {text("name", "for `release: { from: face, face: NAME }`"), number("from", "m", "x of one end"),
        number("to", "m", "x of the other end; the higher one is the crest")},
       {}},
      {"terrain.faces 3D",
       {text("name", "for `release: { from: face, face: NAME }`"), text("zone", "that is the face")},
       {}},
      {"materials", {}, {"restitution", "friction", "rolling", "unilateral", "roughness"}},
      {"materials.roughness",
       {number(
           "angle", "rad",
           "added to the dip of the ground at each impact of a lumped mass, along its motion; in 3D another "
           "draw across it")},
       {}},
      {"pairs", {text("material", "in force between the two")}, {"between"}},
      {"blast",
       joined(blast_keys(""), {optional(choice("azimuths", {"mathematical"},
                                               "of a table of holes: they count from +x towards +y"))}),
       {"explosive", "hole", "rows", "holes", "scatter", "face"}},
      {"blast.explosive", blast_keys("explosive."), {}},
      {"blast.hole", blast_keys("hole."), {}},
      {"blast.holes", {file("file", "a table: a line of heads, then a line for each hole")}, {"columns"}},
      {"blast.holes: list", hole_keys(), {}},
      {"blast.holes.columns", head_keys(hole_keys()), {}},
      {"blast.scatter", scatter_keys(), {}},
      {"blast.face",
       {optional(file("mesh", "the face as triangles, an OBJ, PLY or STL file in metres")),
        optional(file("points", "measured points of the face: a table `x, y, z`, XYZ or LAS")),
        optional(at_most(
            at_least(integer("class", "of the points of a LAS file; all where it is left out"), 0), 255)),
        optional(file("profiles",
                      "a table `hole, depth, distance`: the horizontal distance from the axis of a "
                      "hole to the face, at right angles to its row")),
        optional(file("track", "a table `hole, depth, x, y, z`: where holes were drilled"))},
       {"columns"}},
      {"blast.face.columns",
       {optional(text("hole", "its head")), optional(text("depth", "its head")),
        optional(text("distance", "its head")), optional(text("x", "its head")),
        optional(text("y", "its head")), optional(text("z", "its head"))},
       {}},
      {"blast.rows",
       {or_else(at_least(integer("count", "rows of holes"), 1), 1),
        above(optional(number("distance", "m", "from row to row")), 0),
        or_else(at_least(integer("holes", "of a row"), 1), 1),
        at_least(usually(optional(number("delay_row", "s", "from row to row")), usual_delay), 0),
        at_least(usually(optional(number("delay_hole", "s", "from hole to hole")), usual_delay), 0),
        at_least(
            usually(optional(number("delay_in_hole", "s", "from the signal to the charge, in every hole")),
                    usual_firing),
            0)},
       {}},
      {"rocks",
       joined(joined({text("name", "of the group"), table()}, mass_keys_of_rocks()),
              {per_hole(), thickness(),
               optional(number("orientation", "rad", "random and uniform where it is not given")),
               optional(text("material", "shown to other rocks")), weight()}),
       {"type", "columns", "rows", "holes", "air", "shape", "release", "launch", "launch_by_size"}},
      {"rocks 3D",
       joined(joined({text("name", "of the group"), table()}, mass_keys_of_rocks()),
              {per_hole(), optional(text("material", "shown to other rocks")), weight()}),
       {"type", "columns", "rows", "holes", "air", "shape", "orientation", "release", "launch",
        "launch_by_size"}},
      {"rocks.columns", head_keys(rock_columns()), {}},
      {"rocks.launch_by_size", launch_by_size_keys(), {}},
      {"rocks.shape: from_lengths",
       {choice(
           "form", {"box", "cut", "ellipsoid", "sphere"},
           "of the lengths of the table: a box, a box with its edges and corners cut (EOTA), an ellipsoid "
           "of 20 corners, the sphere of the ellipsoid's volume")},
       {"type"}},
      {"rocks.release: from",
       {choice(
            "from", {"face", "collar", "bench_top"},
            "the face of a bench; above it, the collar of the rock's hole; the top as far as the last row"),
        or_else(at_least(integer("bench", "from 1, the uppermost"), 1), 1),
        optional(text("face", "its name, in place of `bench`"))},
       {}},
      {"rocks.release: x",
       {number("x", "m", "place along the profile"),
        at_least(number("above_ground", "m", "height of the centre of mass above the ground"), 0)},
       {}},
      {"rocks.release: x 3D",
       joined(
           {number("x", "m", "place on the ground"), or_else(number("y", "m", "place on the ground"), 0.0)},
           heights()),
       {}},
      {"rocks.release: position", {vector("position", "m", "of the centre of mass")}, {}},
      {"rocks.release: along", {points("along", "a poly-line, uniformly")}, {}},
      {"rocks.release: inside", {points("inside", "a convex polygon, uniformly")}, {}},
      {"rocks.release: along plan 3D",
       joined({plan_points("along", "a poly-line, uniformly")}, heights()),
       {}},
      {"rocks.release: inside plan 3D",
       joined({plan_points("inside", "a polygon, uniformly")}, heights()),
       {}},
      {"rocks.release: zone 3D", joined({text("zone", "uniformly in plan")}, heights()), {}},
      {"rocks.release: raster 3D",
       joined({file("raster", "a grid: its cells above 0, uniformly")}, heights()),
       {}},
      {"bodies",
       joined(joined({text("name", "of the body")}, mass_keys()),
              {thickness(), vector("position", "m", "of the centre of mass"),
               usually(optional(vector("velocity", "m/s", "at rest where it is not given")), usual::launch),
               usually(or_else(number("spin", "rad/s", "counter-clockwise"), 0.0), usual::spin),
               or_else(number("orientation", "rad", "counter-clockwise"), 0.0),
               boolean("fixed", false, "whether it never moves"),
               optional(text("material", "shown to other bodies, where `pairs` is silent")), force_on_body(),
               hold_of_body()}),
       {"shape", "driven"}},
      {"bodies 3D",
       joined(joined({text("name", "of the body")}, mass_keys()),
              {vector("position", "m", "of the centre of mass"),
               usually(optional(vector("velocity", "m/s", "at rest where it is not given")), usual::launch),
               spin("components in the world frame"), boolean("fixed", false, "whether it never moves"),
               optional(text("material", "shown to other bodies, where `pairs` is silent")), force_on_body(),
               hold_of_body()}),
       {"shape", "orientation", "driven"}},
      {"bodies.driven",
       {vector("velocity", "m/s", "at the start, and for all time without `acceleration`"),
        spin("that it keeps"), optional(vector("acceleration", "m/s2", "constant"))},
       {}},
      {"links",
       {text("name", "of the link"), choice("type", {"hinge", "rod", "spring", "rope"}, "what it does"),
        optional(vector("at", "m", "of a hinge: where it is, as built")),
        optional(points("ends", "of a rod, spring or rope: where it holds both, as built")),
        optional(vector("axis", "", "of a hinge in 3D: about which it turns")),
        at_least(optional(number("length", "m", "of a rod, a rope, a spring at rest; without it as built")),
                 0),
        at_least(optional(number("stiffness", "N/m", "of a spring")), 0),
        at_least(optional(number("damping", "N s/m", "of a spring")), 0)},
       {"between"}},
      {"rocks.shape.parts",
       {or_else(vector("at", "m", "where the origin of the part is in the frame of the whole"), {0, 0}),
        or_else(number("turn", "rad", "of the part about its origin, counter-clockwise"), 0.0)},
       {"type"}},
      {"rocks.shape.parts 3D",
       {or_else(vector("at", "m", "where the origin of the part is in the frame of the whole"), {0, 0, 0})},
       {"type", "turn"}},
      {"orientation 3D",
       {vector("axis", "", "about which it is turned"), number("angle", "rad", "by which it is turned")},
       {}},
      {"barriers",
       joined({text("name", "of the barrier"), number("x", "m", "where it stands")}, barrier_keys()),
       {}},
      {"barriers 3D", joined(lines("barrier"), barrier_keys()), {}},
      {"gates", {text("name", "of the gate"), number("x", "m", "where it stands")}, {}},
      {"gates 3D", lines("gate"), {}},
      {"forest: file 3D",
       joined({file("file", "trees: a table with the columns x, y, dbh, height and species")},
              tree_law_keys()),
       {"columns", "species"}},
      {"forest.columns 3D",
       {optional(text("x", "its head")), optional(text("y", "its head")), optional(text("dbh", "its head")),
        optional(text("height", "its head")), optional(text("species", "its head"))},
       {}},
      {"forest: density 3D",
       joined({at_most(at_least(number("density", "", "stems a m2"), 0), 10),
               at_most(above(number("diameter", "m", "at breast height; a distribution gives one a tree"), 0),
                       10),
               or_else(at_most(above(number("height", "m", "of a stem; a distribution gives one a tree"), 0),
                               200),
                       20.0),
               optional(text("zone", "part or zone of the terrain; all of it by default"))},
              tree_law_keys()),
       {}},
      {"forest.species 3D",
       {text("name", "as in the file"),
        at_least(number("factor", "", "on the energy that trees of the species take"), 0)},
       {}},
      {"document",
       {optional(text("number", "of the document")), optional(text("site", "where the blast is")),
        optional(text("client", "who asked")), optional(text("author", "who answers for it")),
        optional(text("date", "of the document, as it is to be printed")),
        optional(text("checked_by", "who checked it")), optional(text("revision", "of the document")),
        boolean("signature", false, "true: the first page has lines to sign on")},
       {}},
      {"clearance",
       {text("name", "of the clearance"),
        optional(text("group", "the group of rocks that the clearance applies to; all groups by default")),
        below(above(number("probability", "", "probability with which a rock exceeds the distance"), 0), 1),
        or_else(below(above(number("confidence", "", "of the interval"), 0), 1), 0.95),
        at_least(optional(number("factor", "", "safety factor on the distance; none by default")), 1),
        above(
            optional(number("customary", "m", "the legal or customary distance: the limit of the distance")),
            0),
        above(optional(number("known_throw", "m", "the farthest throw that is known of the site")), 0),
        above(optional(number("blasts_per_year", "", "for the probability per year")), 0),
        or_else(choice("per", {"rock", "blast"}, "blast: the farthest rock of a trial"), "rock"),
        or_else(choice("of", {"runout", "max_distance"}, "which distance"), "runout"),
        at_most(at_least(optional(integer("sectors",
                                          "3D: by azimuth, in so many sectors, from all release places")),
                         4),
                360),
        optional(choice("area", {"least"}, "3D: also the area of least size")),
        above(optional(number("radius", "m", "of the kernel of the least area; else the best of eight")), 0),
        optional(number("x", "m", "x of the point about which the sectors lie; 0 if only y is given")),
        optional(number("y", "m", "y of that point; 0 if only x is given"))},
       {}},
      {"exposure",
       joined({text("name", "of who or what is exposed"), number("at", "m", "x where it is"),
               at_most(above(number("spread", "rad", "angle in plan over which rocks are thrown evenly"), 0),
                       2 * pi)},
              exposure_keys()),
       {}},
      {"exposure 3D",
       joined(
           {text("name", "of who or what is exposed"), optional(vector("at", "m", "place in plan, [x, y]")),
            optional(plan_points("line", "in plan, somewhere on it, as on a road; in place of `at`")),
            above(optional(number("radius", "m", "of the kernel; else that of the 100 nearest landings")),
                  0)},
           exposure_keys()),
       {}},
      {"observed",
       {file("file", "a table of measured places: a line of heads, then a line for each"),
        choice(
            "of", {"runout", "place", "distance"},
            "what is compared: the runout, the place where it stops, the greatest distance from the start"),
        or_else(choice("per", {"rock", "blast", "hole"},
                       "of what a line tells: a rock, the farthest rock of a trial, that of a measured hole"),
                "rock")},
       {"columns"}},
      {"observed.columns", head_keys(observed_columns()), {}},
      {"solver",
       {or_else(choice("name", {"auto", "nlgs", "proximal_newton"}, "which contact solver"), "auto"),
        or_word(at_most(at_least(number("time_step", "s", "of the contact scheme"), 1e-7), 0.1), "auto"),
        or_else(
            at_most(at_least(number("step_tolerance", "",
                                    "of `time_step: auto`: error of a phase in contact, as a share of the "
                                    "diameter of a rock"),
                             1e-9),
                    0.1),
            SolverPlan{}.step_tolerance),
        or_else(at_most(at_least(number("theta", "", "of the theta scheme"), 0.5), 1), 0.5),
        or_else(above(number("tolerance", "", "of the scaled residual"), 0), SolverPlan{}.tolerance),
        or_else(at_least(integer("max_iterations", "of one contact problem"), 1), 1000),
        or_else(choice("flight", {"exact", "stepped"}, "motion between contacts"), "exact"),
        or_else(choice("impacts", {"together", "one_by_one"},
                       "contacts that close at one instant: one problem, or the fastest first, each alone"),
                "together"),
        or_else(choice("bodies", {"auto", "exact", "dense"},
                       "how bodies that touch move: each touch at its instant, dense steps of 4 ms (or "
                       "`time_step`), or dense from 40 contacts of one island on"),
                "auto"),
        or_else(at_least(number("rest_speed", "m/s", "below which a contact closes without restitution"), 0),
                0.02)},
       {}},
      {"stop",
       {usually(at_most(above(number("time", "s", "end of a trial"), 0), 1e5), usual::stop_time),
        or_else(at_least(number("speed", "m/s", "below which a rock is at rest; 0 never"), 0), 0.05)},
       {}},
      {"settle",
       {above(number("until", "m/s", "below which a body is at rest"), 0),
        at_most(above(number("at_most", "s", "before time 0"), 0), 1e5)},
       {}},
      {"start",
       {text("from", "the result folder of a run, in which bodies start as they ended there"),
        or_else(at_least(integer("point", "of its sweep"), 0), 0.0),
        or_else(at_least(integer("trial", "of the point"), 0), 0.0)},
       {"bodies"}},
      {"output",
       {boolean("rocks", true, "whether every rock has its rows; else only the first ones"),
        at_least(optional(integer("chunk", "trials of a chunk; else chosen from `trials`")), 1),
        or_else(at_least(integer("first", "rocks of each sweep point with rows where `rocks` is false"), 1),
                1000),
        boolean("envelopes", true, "whether a run in 2D makes envelopes along x"),
        boolean("impacts", true, "whether impacts are stored"),
        boolean("hard_problems", false, "whether problems that did not converge are kept as FCLIB files"),
        boolean("rank_outcomes", false,
                "whether the report also ranks what plugins draw: rock.volume, release.x, ...")},
       {"trajectories", "series", "maps"}},
      {"output.maps",
       {optional(above(number("cell", "m", "side of the cells; else chosen from the ground"), 0)),
        optional(plan_points("region", "two opposite corners; else the extent of the ground"))},
       {}},
      {"output.series",
       {boolean("contacts", true, "whether contacts have rows"),
        boolean("meshes", false, "whether the nodes and cells of deformable bodies have rows each time"),
        or_word(at_least(number("every", "s", "between rows; step: at the end of each step"), 1e-7), "step"),
        or_else(at_least(integer("first", "trials with series"), 1), 1)},
       {"bodies", "regions"}},
      {"output.series.regions",
       {text("name", "of the region"), points("corners", "two opposite corners of a box")},
       {}},
      {"output.trajectories",
       {or_else(at_least(integer("first", "trials with trajectories"), 0), 100),
        or_else(at_least(number("every", "s", "between stored points in flight"), 1e-4), 0.02)},
       {}},
      {"sweep",
       {optional(text("table", "a file of rows: a line of paths, then a line for each point")),
        boolean("product", false, "each row at each point of the sweeps elsewhere")},
       {"rows"}},
      {"expect",
       {text("measure", "what is compared"),
        optional(text("order_in", "a swept number: what is compared is the order of the error in it"))},
       {"equals", "tolerance", "relative", "below", "above", "between", "exact", "at"}},
      {"answer", {text("least", "the measure whose least number makes a point the best")}, {"such_that"}},
      {"answer.such_that", {text("measure", "what has a limit")}, {"below", "above"}},
  };
}

}  // namespace

std::vector<std::string> SectionSpec::key_names() const {
  std::vector<std::string> names = names_of(keys);
  names.insert(names.end(), parts.begin(), parts.end());
  return names;
}

std::string place_section(std::string_view name, int dimension) {
  return std::string(name) + (dimension == 3 ? " 3D" : "");
}

const std::vector<ParamSpec>& rock_columns() {
  static const std::vector<ParamSpec> columns = make_rock_columns();
  return columns;
}

const std::vector<ParamSpec>& observed_columns() {
  static const std::vector<ParamSpec> columns = make_observed_columns();
  return columns;
}

const std::vector<SectionSpec>& section_specs() {
  static const std::vector<SectionSpec> sections = make_sections();
  return sections;
}

const SectionSpec& section_spec(std::string_view name) {
  for (const SectionSpec& section : section_specs())
    if (section.name == name) return section;
  throw std::logic_error("no section " + std::string(name));
}

}  // namespace flyrock
