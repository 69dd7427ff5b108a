// Files of surveyors, damaged: workbooks with a table of holes, layers of zones, point clouds.

#include <fmt/format.h>

#include "../las_file.h"
#include "../workbook_file.h"
#include "corpus.h"
#include "host/session.h"
#include "host/share.h"
#include "kind.h"
#include "mutate_text.h"
#include "mutate_tree.h"

namespace flyrock::fuzz {

namespace {

/// What stands around `holes`.
std::string blast_with(const std::string& holes) {
  return "flyrock: 1\ndimension: 3\nmethod: ballistic\ntrials: 1\nterrain: { type: plane }\nblast:\n"
         "  hole: { diameter: 102 mm, length: 12 m }\n  explosive: ANFO\n  burden: 3 m\n  rock_density: "
         "2700\n"
         "  holes: { file: \"" +
         holes +
         "\" }\nrocks:\n  - { name: r, per_hole: 1, density: 2700, shape: { type: sphere, radius: 0.1 }, "
         "launch: { type: richards_moore, k: 14 } }\nstop: { time: 60 s }\n";
}

/// Workbooks whose parts, or whose archive, are damaged.
class SheetFiles : public Kind {
 public:
  void attempt(Dice& dice, Calls& call) override {
    const bool is_ods = dice.one_in(2);
    workbooks::Parts parts = is_ods ? ods_parts() : xlsx_parts();
    if (!dice.one_in(4)) {
      std::string& content = dice.pick(parts).second;
      dice.one_in(2) ? mutate_text(content, dictionary_, dice) : mutate_bytes(content, dice);
    }
    std::string bytes = workbooks::zip_of(parts);
    if (dice.one_in(4)) mutate_bytes(bytes, dice);
    const std::string file = is_ods ? "holes.ods" : "holes.xlsx";
    write_here(file, bytes);
    write_here("s.yaml", blast_with(file + (dice.one_in(4) ? "" : dice.one_in(8) ? "#Hols" : "#Holes")));
    call({"check", "s.yaml"}, ErrorForm::placed);
  }

 private:
  static workbooks::Parts xlsx_parts() {
    const std::string texts =
        "<si><t>Hole ID</t></si><si><t>x</t></si><si><t>y</t></si><si><t>Burden (m)</t></si>";
    const std::string sheet =
        R"(<sheetData><row r="1"><c r="A1" t="s"><v>0</v></c><c r="B1" t="s"><v>1</v></c><c r="C1" t="s"><v>2</v></c>)"
        R"(<c r="D1" t="s"><v>3</v></c></row><row r="2"><c r="A2" t="inlineStr"><is><t>H1</t></is></c><c r="B2"><v>0</v></c>)"
        R"(<c r="C2"><v>0</v></c><c r="D2" s="2"><v>3.1</v></c></row><row r="3"><c r="A3"><v>2</v></c><c r="B3"><v>0</v></c>)"
        R"(<c r="C3"><f>C2+3</f><v>3</v></c><c r="D3" t="str"><v>2.9</v></c></row></sheetData>)";
    return workbooks::xlsx_parts({{"Holes", sheet}, {"Notes", workbooks::xlsx_sheet({{"note"}})}}, texts);
  }

  static workbooks::Parts ods_parts() {
    const auto cell = [](const std::string& text) {
      return "<table:table-cell office:value-type=\"string\"><text:p>" + text +
             "</text:p></table:table-cell>";
    };
    const auto number = [](const std::string& text) {
      return "<table:table-cell office:value-type=\"float\" office:value=\"" + text + "\"/>";
    };
    return {
        {"mimetype", "application/vnd.oasis.opendocument.spreadsheet"},
        {"content.xml",
         "<office:document-content xmlns:office=\"o\" xmlns:table=\"t\" xmlns:text=\"x\"><office:body>"
         "<office:spreadsheet><table:table table:name=\"Holes\"><table:table-row>" +
             cell("Hole ID") + cell("x") + cell("y") + cell("Burden (m)") +
             "</table:table-row><table:table-row>" + cell("H1") + number("0") + number("0") + number("3.1") +
             "</table:table-row><table:table-row table:number-rows-repeated=\"1\">" + cell("H2") +
             number("0") + number("3") + number("2.9") +
             "</table:table-row><table:table-row table:number-rows-repeated=\"1048573\"><table:table-cell "
             "table:number-columns-repeated=\"16384\"/></table:table-row></table:table></office:spreadsheet>"
             "</office:body></office:document-content>"}};
  }

  Dictionary dictionary_ = make_dictionary(LuaSession(share_folder()).registry());
};

/// Layers of a zone, 3D faces of a drawing and clouds of points, whose bytes are damaged; layers of which
/// each feature is a zone, a gate or a row of a table.
class LayerFiles : public Kind {
 public:
  void attempt(Dice& dice, Calls& call) override {
    switch (dice.below(4)) {
      case 0:
        return attempt_each(dice, call);
      case 1:
        return attempt_table(dice, call);
      default:
        return attempt_place(dice, call);
    }
  }

 private:
  void attempt_place(Dice& dice, Calls& call) {
    const std::size_t form = dice.below(6);
    static constexpr const char* endings[] = {"geojson", "dxf", "kml", "las", "xyz", "dxf"};
    const std::string file = fmt::format("site.{}", endings[form]);
    std::string bytes =
        form == 0   ? geojson
        : form == 1 ? dxf
        : form == 2 ? kml
        : form == 3
            ? las_files::las_of(survey(), {dice.one_in(2) ? 4 : 2, dice.one_in(2) ? 6 : 0, 30, 2056, 9001})
        : form == 4 ? xyz()
                    : faces();
    form == 3 || dice.one_in(2) ? mutate_bytes(bytes, dice) : mutate_text(bytes, dictionary_, dice);
    write_here(file, bytes);
    write_slope();
    const bool is_cloud = form == 3 || form == 4, is_ground = form >= 3;
    write_here(
        "s.yaml",
        "flyrock: 1\ndimension: 3\nmethod: lumped_mass\nterrain: { " +
            (is_cloud ? "type: points, file: " + file + ", " +
                            (dice.one_in(2) ? "cell: 2 m, max_gap: 4 m" : "triangulate: true, max_gap: 4 m")
             : is_ground
                 ? "type: mesh, file: " + file
                 : "type: mesh, file: slope.obj, crs: EPSG:2056, zones: [{ name: soft, polygon: { layer: " +
                       file + " } }]") +
            ", material: rock" + (is_ground ? "" : ", materials: { soft: rock }") +
            " }\nmaterials: { rock: { restitution: { type: newton, en: 0.3 }, friction: { type: coulomb, mu: "
            "0.5 } } }\n"
            "rocks: [{ name: r, density: 2700, shape: { type: sphere, radius: 0.3 }, release: { x: 2600004, "
            "y: 1200004, "
            "above_ground: 1 } }]\nstop: { time: 1 s }\n");
    call({"check", "s.yaml"}, ErrorForm::placed);
  }

  static void write_slope() {
    write_here("slope.obj",
               "v 2600000 1200000 40\nv 2600080 1200000 0\nv 2600080 1200060 0\nv 2600000 1200060 40\n"
               "f 1 2 3\nf 1 3 4\n");
  }

  /// A zone and a gate for each value of an attribute, whose values, names and geometries are damaged.
  void attempt_each(Dice& dice, Calls& call) {
    const bool is_drawing = dice.one_in(4);
    const std::string file = is_drawing ? "site.dxf" : "site.geojson";
    std::string bytes = is_drawing ? dxf : features();
    if (!is_drawing && !dice.one_in(3))
      change_value(bytes, dice);
    else
      dice.one_in(3) ? mutate_bytes(bytes, dice) : mutate_text(bytes, dictionary_, dice);
    write_here(file, bytes);
    write_slope();
    const std::string attribute = is_drawing ? "Layer" : dice.one_in(2) ? "kind" : "number";
    std::string text =
        "flyrock: 1\ndimension: 3\nmethod: lumped_mass\nterrain: { type: mesh, file: slope.obj, crs: "
        "EPSG:2056, "
        "material: rock, zones: [{ name: soil, polygon: { layer: " +
        file + ", where: { form: area }, each: " + attribute +
        " } }] }\ngates: [{ name: road, line: { layer: " + file +
        ", where: { form: line }, each: " + attribute +
        " } }]\nmaterials: { rock: { restitution: { type: newton, en: 0.3 }, friction: { type: coulomb, mu: "
        "0.5 } } }\n"
        "rocks: [{ name: r, density: 2700, shape: { type: sphere, radius: 0.3 }, release: { x: 2600004, "
        "y: 1200004, above_ground: 1 } }]\nstop: { time: 1 s }\n";
    if (is_drawing)
      for (const char* of_form : {", where: { form: area }", ", where: { form: line }"})
        text.erase(text.find(of_form), std::string_view(of_form).size());
    if (dice.one_in(4)) mutate_text(text, dictionary_, dice);
    write_here("s.yaml", text);
    call({"check", "s.yaml"}, ErrorForm::placed);
  }

  /// Gives an attribute of a feature a value of which it is hard to make a name.
  static void change_value(std::string& bytes, Dice& dice) {
    static constexpr const char* attributes[] = {"\"scree\"", "\"moss\"",     "\"house\"",
                                                 "\"road\"",  "\"number\":1", "\"number\":3"};
    static constexpr const char* values[] = {"null",         "\"\"",      "\" \"",    "\"a b\"",
                                             "\"a_b\"",      "\"moss\"",  "\"road\"", "\"\\u00e4\"",
                                             "\"a/b: [c]\"", "\"a\\nb\"", "true",     "-1",
                                             "1e300",        "0.1",       "[1, 2]",   "{}",
                                             "\"rock\"",     "\"1\"",     "\"..\"",   "12345678901234567890"};
    const std::string attribute = attributes[dice.below(std::size(attributes))];
    const std::string value = values[dice.below(std::size(values))];
    const std::string changed = attribute.find(':') == attribute.npos ? value : "\"number\":" + value;
    bytes.replace(bytes.find(attribute), attribute.size(), changed);
  }

  /// The attributes of a layer as a table of holes.
  void attempt_table(Dice& dice, Calls& call) {
    const bool is_dbf = dice.one_in(2);
    std::string bytes = is_dbf ? dbf_of_holes() : geojson_of_holes();
    is_dbf || dice.one_in(3) ? mutate_bytes(bytes, dice) : mutate_text(bytes, dictionary_, dice);
    const std::string file = is_dbf ? "holes.dbf" : "holes.geojson";
    write_here(file, bytes);
    write_here("s.yaml", blast_with(file));
    call({"check", "s.yaml"}, ErrorForm::placed);
  }

  static std::vector<las_files::LasPoint> survey() {
    std::vector<las_files::LasPoint> points;
    for (int row = 0; row < 6; ++row)
      for (int column = 0; column < 6; ++column)
        points.push_back(
            {{2600000. + 2 * column, 1200000. + 2 * row, 10 - 0.5 * column}, column == 3 ? 5 : 2});
    return points;
  }
  static std::string xyz() {
    std::string text = "x y z\n";
    for (const las_files::LasPoint& point : survey())
      text += fmt::format("{} {} {}\n", point.place.x(), point.place.y(), point.place.z());
    return text;
  }

  /// The slope as two faces and a polyface mesh of two more.
  static std::string faces() {
    const auto place = [](int code, double x, double y, double z) {
      return fmt::format("{}\n{}\n{}\n{}\n{}\n{}\n", code, x, code + 10, y, code + 20, z);
    };
    std::string text = "0\nSECTION\n2\nENTITIES\n";
    for (const double x : {2600000., 2600040.})
      text += "0\n3DFACE\n8\nPIT\n" + place(10, x, 1200000, 20) + place(11, x + 40, 1200000, 10) +
              place(12, x + 40, 1200060, 10) + place(13, x, 1200060, 20);
    text += "0\nPOLYLINE\n8\nPIT\n66\n1\n70\n64\n71\n4\n72\n1\n" + place(10, 0, 0, 0);
    for (const double x : {2600080., 2600120.})
      for (const double y : {1200000., 1200060.})
        text += "0\nVERTEX\n8\nPIT\n70\n192\n" + place(10, x, y, 10);
    return text + "0\nVERTEX\n8\nPIT\n70\n128\n71\n1\n72\n3\n73\n4\n74\n2\n" + place(10, 0, 0, 0) +
           "0\nSEQEND\n8\nPIT\n0\nENDSEC\n0\nEOF\n";
  }

  static std::string feature(const std::string& properties, const std::string& geometry) {
    return R"({"type":"Feature","properties":{)" + properties + R"(},"geometry":)" + geometry + "}";
  }
  static std::string collection(const std::vector<std::string>& features) {
    return R"({"type":"FeatureCollection","crs":{"type":"name","properties":{"name":"urn:ogc:def:crs:EPSG::2056"}},"features":[)" +
           fmt::format("{}]}}", fmt::join(features, ","));
  }

  /// Two zones and two lines with a name and a number each.
  static std::string features() {
    const auto area = [](const char* kind, int number, double x) {
      return feature(
          fmt::format(R"("form":"area","kind":"{}","number":{})", kind, number),
          fmt::format(
              R"({{"type":"Polygon","coordinates":[[[{0},1200000],[{1},1200000],[{1},1200060],[{0},1200060],[{0},1200000]]]}})",
              x, x + 20));
    };
    const auto line = [](const char* kind, int number, double x) {
      return feature(
          fmt::format(R"("form":"line","kind":"{}","number":{})", kind, number),
          fmt::format(R"({{"type":"LineString","coordinates":[[{0},1200002],[{0},1200058]]}})", x));
    };
    return collection({area("scree", 1, 2600010), area("moss", 2, 2600035), line("house", 3, 2600060),
                       line("road", 4, 2600070)});
  }

  static std::string geojson_of_holes() {
    std::vector<std::string> holes;
    for (int i = 0; i < 3; ++i)
      holes.push_back(feature(fmt::format(R"("hole":"H{}","x":0,"y":{},"burden_m":2.9)", i, 3 * i), "null"));
    return collection(holes);
  }

  /// dBASE III: a head, a field of ten letters for each column, rows.
  static std::string dbf_of_holes() {
    const std::vector<std::string> names = {"HOLE", "X", "Y", "BURDEN"};
    constexpr std::size_t width = 10;
    const std::size_t head = 33 + 32 * names.size(), row = 1 + width * names.size();
    std::string bytes = std::string("\x03\x7a\x0b\x1c", 4) + workbooks::little_endian(3, 4) +
                        workbooks::little_endian(head, 2) + workbooks::little_endian(row, 2) +
                        std::string(20, '\0');
    for (const std::string& name : names)
      bytes += name + std::string(11 - name.size(), '\0') + (name == "HOLE" ? "C" : "N") +
               std::string(4, '\0') + workbooks::little_endian(width, 1) +
               workbooks::little_endian(name == "HOLE" ? 0 : 3, 1) + std::string(14, '\0');
    bytes += '\r';
    for (int i = 0; i < 3; ++i)
      bytes += fmt::format(" {:<10}{:>10.3f}{:>10.3f}{:>10.3f}", i, 0., 3. * i, 2.9);
    return bytes + '\x1a';
  }

  static constexpr const char* geojson =
      R"({"type":"FeatureCollection","crs":{"type":"name","properties":{"name":"urn:ogc:def:crs:EPSG::2056"}},"features":[)"
      R"({"type":"Feature","properties":{"kind":"soft"},"geometry":{"type":"Polygon","coordinates":[[[2600002,1200000],)"
      R"([2600008,1200000],[2600008,1200009],[2600002,1200009],[2600002,1200000]]]}}]})";
  static constexpr const char* dxf =
      "0\nSECTION\n2\nENTITIES\n0\nPOLYLINE\n8\nsoft\n66\n1\n70\n1\n10\n0\n20\n0\n30\n0\n0\nVERTEX\n8\nsoft\n"
      "10\n2600002\n20\n"
      "1200000\n30\n0\n42\n0."
      "2\n0\nVERTEX\n8\nsoft\n10\n2600008\n20\n1200000\n30\n0\n0\nVERTEX\n8\nsoft\n10\n2600008\n20\n1200009\n"
      "30\n0\n"
      "0\nSEQEND\n8\nsoft\n0\nENDSEC\n0\nEOF\n";
  static constexpr const char* kml =
      R"(<?xml version="1.0"?><kml xmlns="http://www.opengis.net/kml/2.2"><Document><Placemark><name>soft</name><Polygon>)"
      R"(<outerBoundaryIs><LinearRing><coordinates>7.43863,46.95108 7.43873,46.95108 7.43873,46.95116 7.43863,46.95108</coordinates>)"
      R"(</LinearRing></outerBoundaryIs></Polygon></Placemark></Document></kml>)";

  Dictionary dictionary_ = make_dictionary(LuaSession(share_folder()).registry());
};

}  // namespace

std::unique_ptr<Kind> make_sheet_kind() { return std::make_unique<SheetFiles>(); }
std::unique_ptr<Kind> make_layer_kind() { return std::make_unique<LayerFiles>(); }

}  // namespace flyrock::fuzz
