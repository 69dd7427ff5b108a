// flyrock law and flyrock verify.

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "program.h"

using namespace flyrock::test;

TEST_CASE("law draws a law's graph from solved contacts") {
  const Folder folder;
  const Output coulomb = call(folder, "law friction/coulomb --set mu=0.5 -o coulomb.svg");
  REQUIRE(coulomb.code == 0);
  CHECK(coulomb.out.find("r_t / (m g h)") != std::string::npos);
  CHECK(coulomb.out.find("-0.5\n") != std::string::npos);  // sliding forward
  const std::string svg = read(folder.path() / "coulomb.svg");
  CHECK(svg.starts_with("<svg xmlns="));
  CHECK(svg.find("nan") == std::string::npos);
  for (const char* law :
       {"restitution/newton --set en=0.5 --set form=energy", "restitution/wyllie",
        "restitution/normal_tangential --set rn=0.4 --set rt=0.8",
        "rolling/rolling_resistance --set \"mu_r=2 cm\"",
        "friction/slip_weakening --set mu_s=0.6 --set mu_d=0.2 --set distance=0.5", "unilateral/signorini",
        "unilateral/quasi_shock", "unilateral/cohesive --set \"pull=1 kN\"",
        "unilateral/penalty --set \"stiffness=1e5 N/m\""}) {
    INFO(law);
    const Output output = call(folder, std::string("law ") + law);
    CHECK(output.code == 0);
    CHECK(output.out.find("nan") == std::string::npos);
  }
}

TEST_CASE("law draws another ball, and the first axis to where one asks") {
  const Folder folder;
  const std::string near =
      call(folder, "law friction/coulomb --set mu=0.5 --to \"1 cm/s\" --mass \"2 t\"").out;
  CHECK(near.find("drawn for a ball of 2000 kg and 0.3 m") != std::string::npos);
  CHECK(near.find("-0.01 ") == std::string::npos);  // 7.2 cm/s of friction in 1 ms hold all of them
  CHECK(call(folder, "law friction/coulomb --set mu=0.5 --to \"1 kg\"").err ==
        "error: the axis of this graph has the unit m/s, not kg\n");
  CHECK(call(folder, "law friction/coulomb --set mu=0.5 --mass 0")
            .err.find("--mass 0: expected a positive number in kg") != std::string::npos);
  // A law that goes on weakening for 3 m is drawn beyond that.
  const std::string weakening =
      "law friction/slip_weakening --set mu_s=0.6 --set mu_d=0.2 --set \"distance=3 m\"";
  CHECK(call(folder, weakening).out.find("  5  0.2\n") != std::string::npos);
}

TEST_CASE("the graph of a spring shows its damper and its tangential spring") {
  const Folder folder;
  const std::string out =
      call(folder,
           "law unilateral/penalty --set \"stiffness=1e6 N/m\" --set \"damping=2 kN s/m\" "
           "--set \"tangential_stiffness=1e5 N/m\" --to \"10 mm\"")
          .out;
  CHECK(out.find("  0.01  10000\n") != std::string::npos);
  // The ball of 500 kg goes 10 mm deep at 0.01 sqrt(k / m) = 0.447 m/s.
  CHECK(out.find("closing at 0.447 m/s") != std::string::npos);
  CHECK(out.find("  0.01  10894\n") != std::string::npos);
  CHECK(out.find("  0.01  9105.6\n") != std::string::npos);
  CHECK(out.find("  0.04905  -2452.5\n") != std::string::npos);  // mu m g
}

TEST_CASE("law writes a PNG where a program draws it, and says which is missing") {
  const Folder folder;
  const Output output = call(folder, "law friction/coulomb --set mu=0.5 -o coulomb.png");
  if (output.code == 0) {
    CHECK(read(folder.path() / "coulomb.png").substr(1, 3) == "PNG");
  } else {
    CHECK(output.code == 2);
    CHECK(output.err.find("coulomb.png: a PNG needs the program rsvg-convert (Debian: librsvg2-bin)") !=
          std::string::npos);
  }
  CHECK_FALSE(folder.has("coulomb.png.svg"));
}

TEST_CASE("law says what is wrong with what it is given") {
  const Folder folder;
  const auto error = [&](const std::string& line) {
    const Output output = call(folder, "law " + line);
    CHECK(output.code == 2);
    return output.err;
  };
  CHECK(error("friction").find("expected KIND/NAME, as friction/coulomb") != std::string::npos);
  CHECK(error("friction/coulom").find("did you mean `coulomb`?") != std::string::npos);
  CHECK(error("friction/coulomb --set nu=0.5").find("nu") != std::string::npos);
  CHECK(error("friction/coulomb --set mu").find("expected PARAMETER=VALUE") != std::string::npos);
  CHECK(error("friction/coulomb").find("--set:1:1: error: plugin coulomb: expected either `mu` or `angle`") !=
        std::string::npos);
  CHECK(error("restitution/newton --set en=0.5 --set form=poisson --set et=0.1")
            .find("`et` belongs to the form newton; the form poisson has none") != std::string::npos);
  CHECK(error("shape/disk --set radius=1").find("a shape has no graph") != std::string::npos);
}

TEST_CASE("law draws, and plugins lists, the law of a user's file") {
  const Folder folder;
  folder.write("soft.lua", R"(local fr = require "flyrock"
return fr.plugin { kind = "restitution", name = "soft", doc = "Falls with the approach.",
  params = { en = fr.number { default = 0.5, min = 0, doc = "at rest" } },
  impact = function(p, contact) return p.en / (1 + contact.approach_speed), 0 end })");
  const Output drawn = call(folder, "law soft.lua --set en=0.8 -o soft.svg");
  INFO(drawn.err);
  CHECK(drawn.code == 0);
  CHECK(drawn.out.find("restitution/soft") != std::string::npos);
  CHECK(folder.has("soft.svg"));
  CHECK(call(folder, "plugins soft.lua").out.find("en") != std::string::npos);
  folder.write("model.lua", R"(local fr = require "flyrock"
return fr.plugin { kind = "velocity", name = "model", doc = "One speed.", params = {},
  launch = function(p, rock) return { velocity = rock:direction(3, 0.2) } end })");
  CHECK(call(folder, "law model.lua").err ==
        "error: model.lua registers no contact laws, expected one\nSee `flyrock law --help`.\n");
  CHECK(call(folder, "law absent.lua").err.find("cannot read `absent.lua`") != std::string::npos);
}

TEST_CASE("law draws a restitution that changes from impact to impact over several impacts") {
  const Folder folder;
  const auto tiring = [&](const std::string& history, const std::string& answer) {
    folder.write("tiring.lua", R"(local fr = require "flyrock"
return fr.plugin { kind = "restitution", name = "tiring", doc = "Loses more at each impact.",
  )" + history + R"( params = {},
  impact = function(p, contact)
    )" + answer + R"(
  end })");
    const Output drawn = call(folder, "law tiring.lua -o tiring.svg");
    INFO(drawn.err);
    CHECK(drawn.code == 0);
    return drawn.out;
  };
  const std::string counted = "local n = contact.history.n contact.history.n = n + 1 return 0.8 * 0.5 ^ n, 0";
  const std::string title = "one impact after the other at 10 m/s and 45 degrees";
  const std::string by_pair = tiring("history = { 'n' },", counted);
  CHECK(by_pair.find(title) != std::string::npos);
  CHECK(by_pair.find("  1  0.8\n") != std::string::npos);
  CHECK(by_pair.find("  2  0.4\n") != std::string::npos);
  CHECK(by_pair.find("  4  0.1\n") != std::string::npos);
  CHECK(read(folder.path() / "tiring.svg").find("number of the impact") != std::string::npos);
  // What a law remembers of a contact ends with the contact; the number of an impact goes on.
  CHECK(tiring("history = { 'n' }, history_of = 'contact',", counted).find(title) == std::string::npos);
  const std::string by_number = tiring("", "return 0.8 / contact.impact_number, 0");
  CHECK(by_number.find(title) != std::string::npos);
  CHECK(by_number.find("  1  0.8\n") != std::string::npos);
  CHECK(by_number.find("  50  0.016\n") != std::string::npos);
  CHECK(tiring("", "return 0.8, 0").find(title) == std::string::npos);
}

TEST_CASE("The graph of a constraint is a corner: no force where a gap is left") {
  const Folder folder;
  const std::string out = call(folder, "law unilateral/signorini").out;
  CHECK(out.find("open by 1 mm") == std::string::npos);
  const std::string corner = out.substr(out.find("gap that is left"));
  CHECK(corner.find("0  49050\n") != std::string::npos);
  CHECK(corner.find("9.81e-05  0\n") != std::string::npos);
}

TEST_CASE("the graph of a contact that bears a pull has the scale of the pull") {
  const Folder folder;
  const std::string out = call(folder, "law unilateral/cohesive --set \"pull=100 N\"").out;
  INFO(out);
  CHECK(out.find("from 400 N pushing to 400 N pulling") != std::string::npos);
  CHECK(out.find("  -80\n") != std::string::npos);   // held
  CHECK(out.find("  -100\n") != std::string::npos);  // torn apart: no more than the pull
}

TEST_CASE("verify holds in all its rows", "[slow]") {
  const Folder folder;
  const Output output = call(folder, "verify --json");
  for (const auto& row : nlohmann::json::parse(output.out)) {
    INFO(row.dump());
    CHECK(row["passed"] == true);
  }
  CHECK(output.code == 0);
}

TEST_CASE("verify says where it finds no friction problems") {
  const Folder folder;
  const Output absent = call(folder, "verify --data nowhere");
  CHECK(absent.code == 2);
  CHECK(absent.err == "error: nowhere: no such folder\n");
  const Output empty = call(folder, "verify --data .");
  CHECK(empty.code == 2);
  CHECK(empty.err == "error: .: holds no friction problems, expected *.hdf5 there or in its folder fclib\n");
}
