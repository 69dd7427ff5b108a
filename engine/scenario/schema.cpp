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

/// A key of a section, described from left to right: `number("top", "m", "its
/// width").at_least(0).or_else(1)`.
struct Key : ParamSpec {
  Key&& at_least(double limit) && { return with<&ParamSpec::min>(limit); }
  Key&& at_most(double limit) && { return with<&ParamSpec::max>(limit); }
  Key&& above(double limit) && { return with<&ParamSpec::above>(limit); }
  Key&& below(double limit) && { return with<&ParamSpec::below>(limit); }
  Key&& usually(const std::optional<UsualRange>& range) && { return with<&ParamSpec::usual>(range); }
  /// It may be left out, and has no default.
  Key&& optional() && { return with<&ParamSpec::optional>(true); }
  Key&& or_else(double value) && { return with<&ParamSpec::default_number>(value); }
  Key&& or_else(const char* value) && { return with<&ParamSpec::default_text>(value); }
  Key&& or_else(std::vector<double> values) && { return with<&ParamSpec::default_vector>(std::move(values)); }
  /// Also this word, which is the default.
  Key&& or_word(const char* word) && {
    choices = {word};
    return std::move(*this).or_else(word);
  }

 private:
  template <auto member, class V>
  Key&& with(V value) {
    this->*member = std::move(value);
    return std::move(*this);
  }
};

Key key(ParamType type, std::string name, std::string unit, std::string doc) {
  Key spec;
  spec.type = type;
  spec.name = std::move(name);
  spec.unit = std::move(unit);
  if (!spec.unit.empty()) spec.dimension = parse_unit(spec.unit).value().dimension;
  spec.doc = std::move(doc);
  return spec;
}

Key number(std::string name, std::string unit, std::string doc) {
  return key(ParamType::number, std::move(name), std::move(unit), std::move(doc));
}
Key integer(std::string name, std::string doc) {
  constexpr double greatest_int = 1e9;  // fits into an int
  return key(ParamType::integer, std::move(name), "", std::move(doc)).at_most(greatest_int);
}
Key boolean(std::string name, bool value, std::string doc) {
  return key(ParamType::boolean, std::move(name), "", std::move(doc)).or_else(value ? 1.0 : 0.0);
}
Key text(std::string name, std::string doc) {
  return key(ParamType::text, std::move(name), "", std::move(doc));
}
Key choice(std::string name, std::vector<std::string> choices, std::string doc) {
  Key spec = key(ParamType::choice, std::move(name), "", std::move(doc));
  spec.choices = std::move(choices);
  return spec;
}
Key vector(std::string name, std::string unit, std::string doc) {
  return key(ParamType::vector, std::move(name), std::move(unit), std::move(doc));
}
Key plan_points(std::string name, std::string doc) {
  return key(ParamType::plan_points, std::move(name), "m", std::move(doc));
}
Key file(std::string name, std::string doc) {
  return key(ParamType::file, std::move(name), "", std::move(doc));
}
Key points(std::string name, std::string doc) {
  return key(ParamType::points, std::move(name), "m", std::move(doc));
}

SectionSpec document() {
  return {"",
          {integer("flyrock", "format version"), text("title", "what the scenario is about").or_else(""),
           integer("dimension", "2: a vertical plane; 3: space").at_least(2).at_most(3),
           choice("method", {"nscd", "lumped_mass", "ballistic"}, "how rocks move"),
           integer("seed", "of all random numbers").at_least(0).at_most(greatest_whole).or_else(1),
           integer("trials", "realisations of each sweep point").at_least(1).or_else(1),
           choice("sampling", {"random", "latin_hypercube", "sobol"},
                  "how trials cover the draws of which each has one; random")
               .optional(),
           integer("outer", "runs of so many trials, each with its own draws `per: run`; 1")
               .at_least(1)
               .at_most(static_cast<double>(most_outer_runs))
               .optional(),
           choice("rock_contacts", {"off", "on"}, "on: rocks also meet each other").or_else("off"),
           choice("body_contacts", {"on", "off"}, "off: bodies meet the terrain only").or_else("on"),
           number("gravity", "m/s2", "along -y in 2D, -z in 3D").at_least(0).at_most(1000).or_else(9.81)},
          {"document",  "include",  "plugins",  "air",    "terrain",  "materials", "pairs",
           "blast",     "branches", "rocks",    "bodies", "barriers", "gates",     "forest",
           "clearance", "exposure", "observed", "solver", "stop",     "output",    "sweep",
           "expect",    "answer",   "settle",   "shapes", "links",    "start"}};
}

/// The key `north` of a terrain.
ParamSpec north() {
  return number("north", "rad", "where bearing 0 points, from +x towards +y; 90 deg")
      .at_least(-2 * pi)
      .at_most(2 * pi)
      .optional();
}

/// The key `slope` of a ditch or a bund.
ParamSpec slope_of_sides(double degrees) {
  return number("slope", "rad", fmt::format("of its sides; {} deg", degrees))
      .above(0)
      .at_most(pi / 2)
      .or_else(degrees * pi / 180);
}

/// In place of an azimuth.
ParamSpec bearing(const std::string& doc) {
  return number("bearing", "rad", doc + ", clockwise from north; or `azimuth`")
      .at_least(-2 * pi)
      .at_most(2 * pi)
      .optional();
}

/// The keys of a body that forces move.
ParamSpec force_on_body() { return vector("force", "N", "constant, at the centre of mass").optional(); }
ParamSpec hold_of_body() {
  return number("hold", "s", "until when it stands; it then has its velocity").at_least(0).optional();
}

/// The fields of the blast below `prefix` ("" or "hole."), from the table that velocity models also use.
std::vector<ParamSpec> blast_keys(std::string_view prefix) {
  std::vector<ParamSpec> keys;
  for (const BlastFieldInfo& info : blast_fields()) {
    std::string_view path = info.path;
    if (!path.starts_with(prefix)) continue;
    path.remove_prefix(prefix.size());
    if (path.find('.') != std::string_view::npos) continue;
    Key spec = number(std::string(path), std::string(info.unit), std::string(info.doc))
                   .usually(info.usual)
                   .optional();
    const bool may_be_zero =
        info.field == BlastField::hole_stemming || info.field == BlastField::hole_subdrilling;
    if (info.field == BlastField::hole_deviation)
      keys.push_back(std::move(spec));  // negative away from the face
    else if (info.field == BlastField::hole_dip)
      keys.push_back(std::move(spec).above(0).at_most(pi));
    else if (info.field == BlastField::hole_azimuth) {
      keys.push_back(std::move(spec).at_least(-2 * pi).at_most(2 * pi));
      keys.push_back(bearing("direction in plan to which the hole leans downwards"));
    } else
      keys.push_back(may_be_zero ? std::move(spec).at_least(0) : std::move(spec).above(0));
  }
  return keys;
}

/// The columns of a table of holes, also the keys of a hole in a list.
std::vector<ParamSpec> hole_keys() {
  std::vector<ParamSpec> keys{text("hole", "its name; else its number, from 1").optional(),
                              integer("row", "from 1, the front row").at_least(1).or_else(1),
                              number("x", "m", "of the collar").optional(),
                              number("y", "m", "of the collar; not read in 2D").optional(),
                              number("z", "m", "of the collar; else on the ground").optional()};
  for (ParamSpec& spec : blast_keys("hole.")) keys.push_back(std::move(spec));
  for (ParamSpec& spec : blast_keys(""))
    if (spec.name.starts_with("burden") || spec.name == "spacing") keys.push_back(std::move(spec));
  for (const char* name : {"toe_x", "toe_y", "toe_z"})
    keys.push_back(number(name, "m", "of the toe, in place of length, dip and bearing").optional());
  keys.push_back(number("time", "s", "when it goes off").at_least(0).usually(usual_firing).or_else(0.0));
  return keys;
}

/// What may be added to the numbers of a hole: no places, no names and no bearing, which goes the other way.
std::vector<ParamSpec> scatter_keys() {
  std::vector<ParamSpec> keys;
  for (const ParamSpec& column : hole_keys())
    if (column.type == ParamType::number && column.name.size() > 1 && !column.name.starts_with("toe_") &&
        column.name != "bearing")
      keys.push_back(
          number(column.name, column.unit, "added to " + column.name + " of each hole").optional());
  return keys;
}

/// Heads of a table that are not the names of its columns.
std::vector<ParamSpec> head_keys(const std::vector<ParamSpec>& columns) {
  std::vector<ParamSpec> keys;
  for (const ParamSpec& column : columns) keys.push_back(text(column.name, "its head").optional());
  return keys;
}

std::vector<ParamSpec> mass_keys() {
  return {number("density", "kg/m3", "of the rock; or `mass`").above(0).usually(usual::density).optional(),
          number("mass", "kg", "of the rock; or `density`").above(0).optional()};
}

/// The mass of rocks, whose table may say it.
std::vector<ParamSpec> mass_keys_of_rocks() {
  std::vector<ParamSpec> keys = mass_keys();
  keys.front().choices = {from_table};
  return keys;
}

/// A table of rocks, which takes the place of `per_trial`.
ParamSpec table() {
  return file("table", "a line of heads, then a line for each rock of every trial").optional();
}

ParamSpec per_hole() {
  return integer("per_hole", "rocks of each hole of `blast.holes`, in place of `per_trial`")
      .at_least(1)
      .optional();
}

ParamSpec weight() {
  return number("weight", "", "the number of real rocks that a rock stands for").above(0).optional();
}

ParamSpec thickness() {
  return number("thickness", "m", "by default that of the sphere of equal cross-section area")
      .above(0)
      .optional();
}

ParamSpec spin(std::string doc) {
  return key(ParamType::spin, "spin", "rad/s", std::move(doc)).usually(usual::spin).or_else(0.0);
}

/// The launch speed by the size of a rock.
std::vector<ParamSpec> launch_by_size_keys() {
  return {number("reference", "m", "diameter of the rocks that start with the speed of `launch`")
              .above(0)
              .usually(UsualRange{0.001, 20}),
          number("exponent", "", "n of (reference / diameter)^n, the factor on it")
              .at_least(0)
              .at_most(4)
              .or_else(1.0),
          number("at_most", "m/s", "no rock is faster").above(0).usually(usual::launch).optional()};
}

std::vector<ParamSpec> joined(std::vector<ParamSpec> first, std::vector<ParamSpec> second) {
  for (ParamSpec& spec : second) first.push_back(std::move(spec));
  return first;
}

/// How high a rock starts at a place in plan in 3D.
std::vector<ParamSpec> heights() {
  return {
      number("above_ground", "m", "height of the centre of mass above the ground").at_least(0).optional(),
      boolean("on_ground", false, "lowered in its attitude until it touches the ground; or `above_ground`")};
}

/// Where a gate or barrier stands in 3D.
std::vector<ParamSpec> lines(const std::string& what) {
  return {text("name", "of the " + what), number("x", "m", "where it stands, across x").optional(),
          plan_points("line", "in plan, along which it stands; in place of `x`").optional()};
}

/// What is exposed at a place, and how often.
std::vector<ParamSpec> exposure_keys() {
  return {
      number("area", "m2", "in plan: of a person, a vehicle, a roof").above(0).at_most(1e4).or_else(0.5),
      number("occupied", "", "part of the time in which someone is there; 1").above(0).at_most(1).optional(),
      number("vehicles_per_hour", "", "both ways; with `length` and `speed`").above(0).optional(),
      number("length", "m", "of a vehicle").above(0).optional(),
      number("speed", "m/s", "of the vehicles").above(0).optional(),
      number("blasts_per_year", "", "for the probability per year").above(0).or_else(1.0),
      number("limit_per_blast", "", "probability that a blast may have at most")
          .above(0)
          .at_most(1)
          .optional(),
      number("limit_per_year", "", "probability that a year may have at most").above(0).at_most(1).optional(),
      number("energy", "J", "of the landings that count, at least").at_least(0).or_else(0.0)};
}

std::vector<ParamSpec> barrier_keys() {
  return {
      number("height", "m", "from its foot to its top").above(0).usually(usual::barrier_height),
      number("capacity", "J", "energy that it takes: the maximum energy level")
          .above(0)
          .usually(usual::barrier_capacity),
      number("inclination", "rad", "from the vertical").at_least(0).below(pi / 2).or_else(0.0),
      number("freeboard", "m", "that must stay free above a rock").at_least(0).or_else(0.0),
      choice("level", {"mel", "sel"}, "maximum or service energy level: sel holds capacity/3").or_else("mel"),
      number("energy_factor", "", "partial factor on the energy of rocks").above(0).or_else(1.0),
      number("height_factor", "", "partial factor on the height of rocks").above(0).or_else(1.0)};
}

/// What a tree does to a rock (world/tree_law.h).
std::vector<ParamSpec> tree_law_keys() {
  return {choice("law", {"dorren_berger", "fixed"},
                 "the energy that a tree takes: by its diameter and the eccentricity of the hit "
                 "(unverified), or the same for each tree")
              .or_else("dorren_berger"),
          number("energy", "J", "that a tree takes at most, with `law: fixed`").at_least(0).optional(),
          number("energy_factor", "", "on the energy that each tree takes").at_least(0).or_else(1.0),
          number("turn", "rad", "of the direction at a hit, away from the stem")
              .at_least(-pi)
              .at_most(pi)
              .or_else(0.0)};
}

/// What a rock of a table, or a measured place, is called.
std::vector<ParamSpec> label_columns() {
  return {text("name", "of the rock; a measured place has the name of its rock").optional(),
          text("group", "a label of rocks that belong together").optional()};
}

std::vector<ParamSpec> make_rock_columns() {
  const auto length = [](const char* name, std::string doc) {
    return number(name, "m", std::move(doc)).above(0).usually(UsualRange{0.001, 20}).optional();
  };
  std::vector<ParamSpec> keys = label_columns();
  keys.push_back(number("mass", "kg", "of the rock").above(0).optional());
  for (const char* name : {"l1", "l2", "l3"}) keys.push_back(length(name, "a length of its bounding box"));
  keys.push_back(length("diameter", "of the sphere of equal volume, in place of the lengths"));
  for (const char* name : {"x", "y", "z"})
    keys.push_back(number(name, "m", "of the centre of mass; not `y` in 2D").optional());
  for (const char* name : {"vx", "vy", "vz"})
    keys.push_back(number(name, "m/s", "of its velocity; not `vy` in 2D").optional());
  return keys;
}

std::vector<ParamSpec> make_observed_columns() {
  std::vector<ParamSpec> keys = label_columns();
  for (const char* name : {"x", "y", "z"})
    keys.push_back(number(name, "m", "of the place where it stopped; not `y` in 2D").optional());
  keys.push_back(number("distance", "m", "from its start, in place of the place").at_least(0).optional());
  return keys;
}

std::vector<SectionSpec> make_sections() {
  return {
      document(),
      {"branches",
       {text("name", "of the branch"),
        number("probability", "", "that it happens to a hole, or to a blast").above(0).below(1),
        choice("per", {"hole", "blast"}, "what it happens to").or_else("hole")},
       {"set", "holes"}},
      {"air",
       // Bounded, because the steps of a flight shrink as the drag grows.
       {number("density", "kg/m3", "of the air").above(0).at_most(100).or_else(1.225),
        number("cd", "", "drag coefficient, on the sphere of equal volume")
            .at_least(0)
            .at_most(100)
            .usually(usual::drag_coefficient),
        vector("wind", "m/s", "calm where it is not given").optional()},
       {}},
      {"terrain",
       {text("material", "of a terrain of one part").optional(), north()},
       {"type", "materials", "zones", "faces", "ditch", "bund"}},
      {"terrain 3D",
       {vector("origin", "m",
               "from which the engine counts, in whole metres; where it is not given, the lower left "
               "corner of triangles or heights beyond 10 km, rounded down to 100 m")
            .optional(),
        text("crs", "EPSG:n, the coordinate system; of the file where it is not given").optional(), north()},
       {"zones", "faces"}},
      {"terrain: section",
       {vector("from", "m", "place in plan where x = 0").optional(),
        vector("to", "m", "place in plan where it ends").optional(),
        plan_points("line", "both places, or a layer with a line between two; in place of `from` and `to`")
            .optional()},
       {"of"}},
      {"terrain.ditch",
       {number("x", "m", "where its near edge is"), number("width", "m", "of its level bottom").above(0),
        number("depth", "m", "of the bottom below the ground at its near edge").above(0), slope_of_sides(45)},
       {}},
      {"terrain.bund",
       {number("x", "m", "where its near foot is; or by `distance` from a ditch").optional(),
        number("distance", "m", "from the far edge of the ditch; 0").at_least(0).optional(),
        number("height", "m", "above the ground at its near foot").above(0),
        number("top", "m", "width of its level top").at_least(0).or_else(1), slope_of_sides(37)},
       {}},
      {"layer",
       {file("layer", "of a GIS or of CAD, read by GDAL: GeoPackage, shapefile, KML, DXF, GeoJSON"),
        text("name", "of the layer, where the file has several").optional(),
        text("each", "an attribute: one zone, gate, barrier or exposure for each of its values").optional()},
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
        text("property", "of its features; all features where it is not given").optional(),
        text("is", "the value of `property`").optional()},
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
       joined(blast_keys(""),
              {choice("azimuths", {"mathematical"}, "of a table of holes: they count from +x towards +y")
                   .optional()}),
       {"explosive", "hole", "rows", "holes", "scatter", "face"}},
      {"blast.explosive", blast_keys("explosive."), {}},
      {"blast.hole", blast_keys("hole."), {}},
      {"blast.holes", {file("file", "a table: a line of heads, then a line for each hole")}, {"columns"}},
      {"blast.holes: list", hole_keys(), {}},
      {"blast.holes.columns", head_keys(hole_keys()), {}},
      {"blast.scatter", scatter_keys(), {}},
      {"blast.face",
       {file("mesh", "the face as triangles, an OBJ, PLY or STL file in metres").optional(),
        file("points", "measured points of the face: a table `x, y, z`, XYZ or LAS").optional(),
        integer("class", "of the points of a LAS file; all where it is left out")
            .at_least(0)
            .at_most(255)
            .optional(),
        file("profiles",
             "a table `hole, depth, distance`: the horizontal distance from the axis of a "
             "hole to the face, at right angles to its row")
            .optional(),
        file("track", "a table `hole, depth, x, y, z`: where holes were drilled").optional()},
       {"columns"}},
      {"blast.face.columns",
       {text("hole", "its head").optional(), text("depth", "its head").optional(),
        text("distance", "its head").optional(), text("x", "its head").optional(),
        text("y", "its head").optional(), text("z", "its head").optional()},
       {}},
      {"blast.rows",
       {integer("count", "rows of holes").at_least(1).or_else(1),
        number("distance", "m", "from row to row").above(0).optional(),
        integer("holes", "of a row").at_least(1).or_else(1),
        number("delay_row", "s", "from row to row").at_least(0).usually(usual_delay).optional(),
        number("delay_hole", "s", "from hole to hole").at_least(0).usually(usual_delay).optional(),
        number("delay_in_hole", "s", "from the signal to the charge, in every hole")
            .at_least(0)
            .usually(usual_firing)
            .optional()},
       {}},
      {"rocks",
       joined(joined({text("name", "of the group"), table()}, mass_keys_of_rocks()),
              {per_hole(), thickness(),
               number("orientation", "rad", "random and uniform where it is not given").optional(),
               text("material", "shown to other rocks").optional(), weight()}),
       {"type", "columns", "rows", "holes", "air", "shape", "release", "launch", "launch_by_size"}},
      {"rocks 3D",
       joined(joined({text("name", "of the group"), table()}, mass_keys_of_rocks()),
              {per_hole(), text("material", "shown to other rocks").optional(), weight()}),
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
        integer("bench", "from 1, the uppermost").at_least(1).or_else(1),
        text("face", "its name, in place of `bench`").optional()},
       {}},
      {"rocks.release: x",
       {number("x", "m", "place along the profile"),
        number("above_ground", "m", "height of the centre of mass above the ground").at_least(0)},
       {}},
      {"rocks.release: x 3D",
       joined({number("x", "m", "place on the ground"), number("y", "m", "place on the ground").or_else(0.0)},
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
               vector("velocity", "m/s", "at rest where it is not given").usually(usual::launch).optional(),
               number("spin", "rad/s", "counter-clockwise").usually(usual::spin).or_else(0.0),
               number("orientation", "rad", "counter-clockwise").or_else(0.0),
               boolean("fixed", false, "whether it never moves"),
               text("material", "shown to other bodies, where `pairs` is silent").optional(), force_on_body(),
               hold_of_body()}),
       {"shape", "driven"}},
      {"bodies 3D",
       joined(joined({text("name", "of the body")}, mass_keys()),
              {vector("position", "m", "of the centre of mass"),
               vector("velocity", "m/s", "at rest where it is not given").usually(usual::launch).optional(),
               spin("components in the world frame"), boolean("fixed", false, "whether it never moves"),
               text("material", "shown to other bodies, where `pairs` is silent").optional(), force_on_body(),
               hold_of_body()}),
       {"shape", "orientation", "driven"}},
      {"bodies.driven",
       {vector("velocity", "m/s", "at the start, and for all time without `acceleration`"),
        spin("that it keeps"), vector("acceleration", "m/s2", "constant").optional()},
       {}},
      {"links",
       {text("name", "of the link"), choice("type", {"hinge", "rod", "spring", "rope"}, "what it does"),
        vector("at", "m", "of a hinge: where it is, as built").optional(),
        points("ends", "of a rod, spring or rope: where it holds both, as built").optional(),
        vector("axis", "", "of a hinge in 3D: about which it turns").optional(),
        number("length", "m", "of a rod, a rope, a spring at rest; without it as built")
            .at_least(0)
            .optional(),
        number("stiffness", "N/m", "of a spring").at_least(0).optional(),
        number("damping", "N s/m", "of a spring").at_least(0).optional()},
       {"between"}},
      {"rocks.shape.parts",
       {vector("at", "m", "where the origin of the part is in the frame of the whole").or_else({0, 0}),
        number("turn", "rad", "of the part about its origin, counter-clockwise").or_else(0.0)},
       {"type"}},
      {"rocks.shape.parts 3D",
       {vector("at", "m", "where the origin of the part is in the frame of the whole").or_else({0, 0, 0})},
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
       {text("x", "its head").optional(), text("y", "its head").optional(),
        text("dbh", "its head").optional(), text("height", "its head").optional(),
        text("species", "its head").optional()},
       {}},
      {"forest: density 3D",
       joined({number("density", "", "stems a m2").at_least(0).at_most(10),
               number("diameter", "m", "at breast height; a distribution is drawn once per tree")
                   .above(0)
                   .at_most(10),
               number("height", "m", "height of the stem; a distribution is drawn once per tree")
                   .above(0)
                   .at_most(200)
                   .or_else(20.0),
               text("zone", "part or zone of the terrain; all of it by default").optional()},
              tree_law_keys()),
       {}},
      {"forest.species 3D",
       {text("name", "as in the file"),
        number("factor", "", "on the energy that trees of the species take").at_least(0)},
       {}},
      {"document",
       {text("number", "of the document").optional(), text("site", "where the blast is").optional(),
        text("client", "who asked").optional(), text("author", "who answers for it").optional(),
        text("date", "of the document, as it is to be printed").optional(),
        text("checked_by", "who checked it").optional(), text("revision", "of the document").optional(),
        boolean("signature", false, "true: the first page has lines to sign on")},
       {}},
      {"clearance",
       {text("name", "of the clearance"),
        text("group", "the group of rocks that the clearance applies to; all groups by default").optional(),
        number("probability", "", "probability with which a rock exceeds the distance").above(0).below(1),
        number("confidence", "", "of the interval").above(0).below(1).or_else(0.95),
        number("factor", "", "safety factor on the distance; none by default").at_least(1).optional(),
        number("customary", "m", "the legal or customary distance: the limit of the distance")
            .above(0)
            .optional(),
        number("known_throw", "m", "the farthest throw that is known of the site").above(0).optional(),
        number("blasts_per_year", "", "for the probability per year").above(0).optional(),
        choice("per", {"rock", "blast"}, "blast: the farthest rock of a trial").or_else("rock"),
        choice("of", {"runout", "max_distance"}, "which distance").or_else("runout"),
        integer("sectors", "3D: by azimuth, in so many sectors, from all release places")
            .at_least(4)
            .at_most(360)
            .optional(),
        choice("area", {"least"}, "3D: also the area of least size").optional(),
        number("radius", "m", "of the kernel of the least area; else the best of eight").above(0).optional(),
        number("x", "m", "x of the point about which the sectors lie; 0 if only y is given").optional(),
        number("y", "m", "y of that point; 0 if only x is given").optional()},
       {}},
      {"exposure",
       joined({text("name", "of who or what is exposed"), number("at", "m", "x where it is"),
               number("spread", "rad", "angle in plan over which rocks are thrown evenly")
                   .above(0)
                   .at_most(2 * pi)},
              exposure_keys()),
       {}},
      {"exposure 3D",
       joined(
           {text("name", "of who or what is exposed"), vector("at", "m", "place in plan, [x, y]").optional(),
            plan_points("line", "in plan, somewhere on it, as on a road; in place of `at`").optional(),
            number("radius", "m", "of the kernel; else that of the 100 nearest landings")
                .above(0)
                .optional()},
           exposure_keys()),
       {}},
      {"observed",
       {file("file", "a table of measured places: a line of heads, then a line for each"),
        choice(
            "of", {"runout", "place", "distance"},
            "what is compared: the runout, the place where it stops, the greatest distance from the start"),
        choice("per", {"rock", "blast", "hole"},
               "of what a line tells: a rock, the farthest rock of a trial, that of a measured hole")
            .or_else("rock")},
       {"columns"}},
      {"observed.columns", head_keys(observed_columns()), {}},
      {"solver",
       {choice("name", {"auto", "nlgs", "proximal_newton"}, "which contact solver").or_else("auto"),
        number("time_step", "s", "of the contact scheme").at_least(1e-7).at_most(0.1).or_word("auto"),
        number("step_tolerance", "",
               "of `time_step: auto`: error of a phase in contact, as a share of the "
               "diameter of a rock")
            .at_least(1e-9)
            .at_most(0.1)
            .or_else(SolverPlan{}.step_tolerance),
        number("theta", "", "of the theta scheme").at_least(0.5).at_most(1).or_else(0.5),
        number("tolerance", "", "of the scaled residual").above(0).or_else(SolverPlan{}.tolerance),
        integer("max_iterations", "of one contact problem").at_least(1).or_else(1000),
        choice("flight", {"exact", "stepped"}, "motion between contacts").or_else("exact"),
        choice("impacts", {"together", "one_by_one"},
               "contacts that close at one instant: one problem, or the fastest first, each alone")
            .or_else("together"),
        choice("bodies", {"auto", "exact", "dense"},
               "how bodies that touch move: each touch at its instant, dense steps of 4 ms (or "
               "`time_step`), or dense from 40 contacts of one island on")
            .or_else("auto"),
        number("rest_speed", "m/s", "below which a contact closes without restitution")
            .at_least(0)
            .or_else(0.02)},
       {}},
      {"stop",
       {number("time", "s", "end of a trial").above(0).at_most(1e5).usually(usual::stop_time),
        number("speed", "m/s", "below which a rock is at rest; 0 never").at_least(0).or_else(0.05)},
       {}},
      {"settle",
       {number("until", "m/s", "below which a body is at rest").above(0),
        number("at_most", "s", "before time 0").above(0).at_most(1e5)},
       {}},
      {"start",
       {text("from", "the result folder of a run, in which bodies start as they ended there"),
        integer("point", "of its sweep").at_least(0).or_else(0.0),
        integer("trial", "of the point").at_least(0).or_else(0.0)},
       {"bodies"}},
      {"output",
       {boolean("rocks", true, "write rows of all rocks (true) or only of the first `first`"),
        integer("chunk", "trials of a chunk; else chosen from `trials`").at_least(1).optional(),
        integer("first", "rocks of each sweep point with rows where `rocks` is false")
            .at_least(1)
            .or_else(1000),
        boolean("envelopes", true, "whether a run in 2D makes envelopes along x"),
        boolean("impacts", true, "whether impacts are stored"),
        boolean("hard_problems", false, "whether problems that did not converge are kept as FCLIB files"),
        boolean("rank_outcomes", false,
                "whether the report also ranks what plugins draw: rock.volume, release.x, ...")},
       {"trajectories", "series", "maps"}},
      {"output.maps",
       {number("cell", "m", "side of the cells; else chosen from the ground").above(0).optional(),
        plan_points("region", "two opposite corners; else the extent of the ground").optional()},
       {}},
      {"output.series",
       {boolean("contacts", true, "whether contacts have rows"),
        boolean("meshes", false, "whether the nodes and cells of deformable bodies have rows each time"),
        number("every", "s", "between rows; step: at the end of each step").at_least(1e-7).or_word("step"),
        integer("first", "trials with series").at_least(1).or_else(1)},
       {"bodies", "regions"}},
      {"output.series.regions",
       {text("name", "of the region"), points("corners", "two opposite corners of a box")},
       {}},
      {"output.trajectories",
       {integer("first", "trials with trajectories").at_least(0).or_else(100),
        number("every", "s", "between stored points in flight").at_least(1e-4).or_else(0.02)},
       {}},
      {"sweep",
       {text("table", "a file of rows: a line of paths, then a line for each point").optional(),
        boolean("product", false, "each row at each point of the sweeps elsewhere")},
       {"rows"}},
      {"expect",
       {text("measure", "what is compared"),
        text("order_in", "a swept number: what is compared is the order of the error in it").optional()},
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
