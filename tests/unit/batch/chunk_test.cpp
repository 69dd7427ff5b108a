#include "batch/chunk.h"

#include <fmt/format.h>

#include <catch2/catch.hpp>

#include "batch/inputs.h"
#include "batch/record_check.h"
#include "files/sha256.h"
#include "record/columns.h"

using namespace flyrock;

namespace {

TrialRecords some_records() {
  TrialRecords records;
  RockRecord rock;
  rock.trial = 7;
  rock.rock = 1;
  rock.group = 2;
  rock.mass = 0.1;
  rock.reason = StopReason::plugin_error;
  rock.censored = true;
  rock.landed = true;
  rock.runout = -1e300;
  rock.impacts = 3;
  rock.start_x = 0.25;
  rock.start_y = -0.25;
  rock.end_part = 5;
  rock.fault = "law.lua:3: said \"no\"";
  rock.travel.time = {1, 2, 3, 4};
  rock.travel.distance = {5, 6, 7, 8};
  records.rocks = {rock, RockRecord{}};
  records.gates = {{7, 1, {{.time = 1.5, .speed = 3, .kinetic_energy = 4, .height = -0.5, .along = 12}, 2}}};
  records.barriers = {{7, 1, {{.time = 2, .speed = 9}, 1, BarrierOutcome::over_energy}}};
  records.inputs = {{7, 1, 4, 2, 0.3}};
  ImpactRecord impact{7, 1, {}};
  impact.impact.other = -1;
  impact.impact.place = {1, 2, 3};
  impact.impact.energy_change = -12.5;
  records.impacts = {impact};
  TrajectoryRecord point{7, 1, {}};
  point.point.mode = TravelMode::slide;
  point.point.state.position = {4, 5, 6};
  point.point.state.kinetic_energy = 8;
  point.point.turn = {0.5, -0.5, 0.5, -0.5};
  records.trajectories = {point, point};
  records.shapes = {{7, 1, {.contactor = 1, .face = 2, .place = {3, 4, 5}, .radius = 6}}};
  SeriesBody state;
  state.body = "ball";
  state.state.time = 0.25;
  state.potential_energy = -3;
  records.series_bodies = {{7, state}};
  SeriesContact contact;
  contact.a = "ball";
  contact.b = "terrain.floor";
  contact.rn = 12;
  contact.state = SeriesState::sliding;
  records.series_contacts = {{7, contact}, {7, contact}};
  records.series_solves = {{7, {.time = 0.25, .step = 0.01, .contacts = 2, .sweeps = 5, .residual = 1e-9}}};
  records.series_stress = {
      {7, {.time = 0.25, .body = "block", .strain = 3, .touch = 0.5, .tension_1pct = 2e6}}};
  records.series_nodes = {{7, {.time = 0.25, .body = "block", .node = 3, .place = {1, 2, 0}}}};
  records.series_cells = {
      {7, {.time = 0.25, .body = "block", .cell = 1, .a = 0, .b = 3, .c = 4, .tension = 2e6}}};
  records.totals.materials = {{1, 2, 3, 4, 5}};
  PathBins path(2, -10, 10);
  path.visit(-3, 1, 0, 4, [](PathBin& bin, double, double t) { bin = {t, 10 * t, 1e6}; });
  records.totals.envelopes.add(1, path);
  records.totals.quality.steps = 11;
  records.totals.quality.max_residual = 1e-9;
  records.totals.notes = {"v0^2 < 0"};
  BodyHistory body;
  body.last.velocity = {1, 0, -1};
  body.impacts = {impact.impact, impact.impact};
  body.apexes = {{0.5, 2.25}};
  records.totals.bodies = {body};
  return records;
}

const ChunkRange range{2, 3, 30, 10};

}  // namespace

TEST_CASE("A chunk reads back as it was written") {
  const std::string bytes = encode_chunk(range, "hash", some_records());
  std::string why;
  const auto read = decode_chunk(bytes, range, "hash", Part::whole, why);
  REQUIRE(read);
  // Written again, the same records give the same bytes: nothing was lost.
  CHECK(encode_chunk(range, "hash", *read) == bytes);
  CHECK(read->rocks[0].fault == "law.lua:3: said \"no\"");
  CHECK(read->rocks[0].reason == StopReason::plugin_error);
  CHECK(read->rocks[0].travel.distance[3] == 8);
  CHECK(read->rocks[0].landed);
  CHECK(read->rocks[0].start_x == 0.25);
  CHECK(read->rocks[0].start_y == -0.25);
  CHECK(read->rocks[0].end_part == 5);
  CHECK(read->gates[0].passage.height == -0.5);
  CHECK(read->gates[0].passage.along == 12);
  CHECK(read->barriers[0].hit.outcome == BarrierOutcome::over_energy);
  CHECK(read->barriers[0].hit.barrier == 1);
  CHECK(read->impacts[0].impact.other == -1);
  CHECK(read->trajectories[1].point.turn[3] == -0.5);
  CHECK(read->shapes[0].corner.place.z() == 5);
  CHECK(read->shapes[0].corner.radius == 6);
  CHECK(read->totals.bodies[0].apexes[0].height == 2.25);
  CHECK(std::isnan(read->totals.bodies[0].stop_time));
}

TEST_CASE("A reading of a part of a chunk has its tables and no others") {
  TrialRecords expected = some_records();
  std::string why;
  const std::string bytes = encode_chunk(range, "hash", expected);
  expected.inputs.clear();
  expected.impacts.clear();
  expected.series_bodies.clear();
  expected.series_contacts.clear();
  expected.series_solves.clear();
  expected.series_stress.clear();
  expected.series_nodes.clear();
  expected.series_cells.clear();
  expected.totals.envelopes = {};
  expected.trajectories.clear();
  expected.shapes.clear();
  const auto brief = decode_chunk(bytes, range, "hash", Part::brief, why);
  REQUIRE(brief);
  CHECK(encode_chunk(range, "hash", *brief) == encode_chunk(range, "hash", expected));
}

TEST_CASE("A number that stands in all rows of a chunk takes its room once") {
  TrialRecords records;
  records.trajectories.resize(1000);
  const std::string same = encode_chunk(range, "hash", records);
  for (int i = 0; i < 1000; ++i) records.trajectories[static_cast<std::size_t>(i)].point.state.time = i;
  const std::string bytes = encode_chunk(range, "hash", records);
  CHECK(bytes.size() - same.size() == 999 * 8);
  std::string why;
  const auto read = decode_chunk(bytes, range, "hash", Part::whole, why);
  REQUIRE(read);
  CHECK(read->trajectories[999].point.state.time == 999);
}

TEST_CASE("A broken or foreign chunk is refused with the reason") {
  const std::string bytes = encode_chunk(range, "hash", some_records());
  std::string why;
  SECTION("every truncation") {
    for (std::size_t size = 0; size < bytes.size(); ++size)
      CHECK_FALSE(decode_chunk(std::string_view(bytes).substr(0, size), range, "hash", Part::whole, why));
  }
  SECTION("a changed bit") {
    for (std::size_t i = 0; i < bytes.size(); i += 7) {
      std::string damaged = bytes;
      damaged[i] = static_cast<char>(damaged[i] ^ 4);
      CHECK_FALSE(decode_chunk(damaged, range, "hash", Part::whole, why));
    }
  }
  SECTION("another scenario or range") {
    CHECK_FALSE(decode_chunk(bytes, range, "hush", Part::whole, why));
    CHECK(why == "of another format, scenario or range of trials");
    CHECK_FALSE(decode_chunk(bytes, {2, 3, 30, 9}, "hash", Part::whole, why));
  }
}

TEST_CASE("A chunk whose checksum is right is refused where it promises more rows than its bytes can hold") {
  // Rocks, gates, barriers, materials: their numbers are the first word of the first part.
  const ColumnWriter numbers = [] {
    ColumnWriter writer;
    writer.value(std::uint64_t{1} << 29);
    for (int i = 0; i < 100; ++i) writer.raw(std::string_view("\x01\0\0\0\0\0\0\0\0", 9));
    return writer;
  }();
  ColumnReader reader(numbers.bytes());
  std::vector<RockRecord> rocks;
  CHECK_THROWS_WITH(reader.rows(rocks), "more rows than its bytes can hold");
}

TEST_CASE("Records that a program other than flyrock has written are held against their scenario") {
  Scenario scenario;
  scenario.rocks.resize(3);
  scenario.gates.resize(3);
  scenario.barriers.resize(2);
  scenario.draws.resize(5);
  const ChunkRange trials{0, 0, 0, 10};
  TrialRecords sound = some_records();
  sound.rocks.pop_back();
  REQUIRE(records_fault(sound, trials, scenario).empty());
  const auto fault_after = [&](const std::function<void(TrialRecords&)>& change) {
    TrialRecords records = sound;
    change(records);
    return records_fault(records, trials, scenario);
  };
  CHECK(fault_after([](TrialRecords& r) { r.rocks[0].group = 3; }) ==
        "a rock of group 3, the scenario has 3");
  CHECK(fault_after([](TrialRecords& r) { r.rocks[0].group = -1; }) ==
        "a rock of group -1, the scenario has 3");
  CHECK(fault_after([](TrialRecords& r) { r.rocks[0].trial = 10; }) ==
        "a rock of trial 10, expected trials 0 to 9");
  CHECK(fault_after([](TrialRecords& r) { r.rocks[0].reason = StopReason::not_started; }).empty());
  CHECK(fault_after([](TrialRecords& r) { r.rocks[0].reason = static_cast<StopReason>(stop_reasons); }) ==
        "a rock that stopped for no known reason");
  CHECK(fault_after([](TrialRecords& r) {
          r.rocks[0].reason = StopReason::stopped;
          r.rocks[0].runout = std::numeric_limits<double>::quiet_NaN();
        }) == "rock 1 of trial 7 has numbers that are not finite");
  for (const auto& other : {+[](TrialRecords& r) { r.inputs[0].rock = 2; },
                            +[](TrialRecords& r) { r.trajectories[1].trial = 6; }})
    CHECK(fault_after(other) == "rows of a rock that it does not have");
  for (const auto& other :
       {+[](TrialRecords& r) { r.gates[0].passage.gate = 3; },
        +[](TrialRecords& r) { r.barriers[0].hit.outcome = static_cast<BarrierOutcome>(3); },
        +[](TrialRecords& r) { r.gates[0].passage.speed = std::numeric_limits<double>::infinity(); }})
    CHECK(fault_after(other) ==
          "an arrival at a gate or barrier that the scenario does not have, or with numbers that are not "
          "finite");
  CHECK(fault_after([](TrialRecords& r) { r.rocks.push_back(r.rocks.front()); }) == "rocks out of order");
  CHECK(fault_after([](TrialRecords& r) { r.gates.push_back(r.gates.back()); }) ==
        "a rock that arrives twice at one gate or barrier");
  CHECK(fault_after([](TrialRecords& r) { r.barriers.push_back(r.barriers.back()); }) ==
        "a rock that arrives twice at one gate or barrier");
  const int inputs = static_cast<int>(inputs_of(scenario).size());
  CHECK(fault_after([&](TrialRecords& r) { r.inputs[0].input = inputs; }) ==
        fmt::format("input {0}, the scenario has {0}", inputs));
  CHECK(fault_after([](TrialRecords& r) { r.trajectories[0].point.mode = static_cast<TravelMode>(-1); }) ==
        "a point of a trajectory of no known mode of travel");
  CHECK(fault_after([](TrialRecords& r) { r.totals.bodies[0].reason = static_cast<StopReason>(9); }) ==
        "a body that stopped for no known reason");
}

TEST_CASE("A plan of chunks covers every trial once, in order") {
  for (std::uint64_t trials : {1u, 99u, 100u, 101u, 1000u, 250001u}) {
    std::uint64_t next = 0;
    int point = 0;
    for (const ChunkRange& chunk : plan_chunks(2, trials)) {
      if (chunk.point != point) {
        CHECK(next == trials);
        point = chunk.point;
        next = 0;
      }
      CHECK(chunk.first == next);
      CHECK(chunk.count >= 1);
      next += chunk.count;
    }
    CHECK(point == 1);
    CHECK(next == trials);
  }
  CHECK(chunk_size(20) == 1);
  CHECK(chunk_size(101) == 2);
  CHECK(chunk_size(1000) == 10);
  CHECK(chunk_size(10'000) == 10);
  CHECK(chunk_size(100'001) == 101);
  CHECK(chunk_size(10'000'000) == 250);
  CHECK(ChunkRange{0, 12, 120, 10}.file_name() == "p0-c12.chunk");
}

TEST_CASE("SHA-256 gives the digests of FIPS 180-4") {
  CHECK(sha256("") == "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  CHECK(sha256("abc") == "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  CHECK(sha256("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq") ==
        "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
  // In pieces of any length.
  Sha256 sum;
  const std::string text = "abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq";
  for (std::size_t at = 0, length = 0; at < text.size(); at += length++)
    sum.add(std::string_view(text).substr(at, length));
  CHECK(sum.digest() == sha256(text));
  CHECK(sha256(std::string(1'000'000, 'a')) ==
        "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
}
