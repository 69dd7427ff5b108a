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

TEST_CASE("The graph of a constraint is a corner: no force where a gap is left") {
  const Folder folder;
  const std::string out = call(folder, "law unilateral/signorini").out;
  CHECK(out.find("open by 1 mm") == std::string::npos);
  const std::string corner = out.substr(out.find("gap that is left"));
  CHECK(corner.find("0  49050\n") != std::string::npos);
  CHECK(corner.find("9.81e-05  0\n") != std::string::npos);
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
