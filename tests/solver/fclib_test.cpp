// Problems on disk: what is read, what is written, what is refused; and the problems of others.

#include "solver/fclib.h"

#include <unistd.h>

#include <catch2/catch.hpp>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <random>

#include "data.h"
#include "solver/hdf5_file.h"
#include "solver/residual.h"
#include "solver/solve.h"

using namespace flyrock;
using flyrock::test::fclib_folder;
namespace fs = std::filesystem;

namespace {

/// A file of this process, removed at the end.
struct TemporaryFile {
  std::string name =
      (fs::temp_directory_path() / ("flyrock_fclib_" + std::to_string(::getpid()) + ".hdf5")).string();
  ~TemporaryFile() { fs::remove(name); }
};

bool without_hdf5() {
  if (!has_hdf5()) std::cout << "SKIPPED: built without HDF5\n";
  return !has_hdf5();
}

bool without_data() {
  if (!has_hdf5() || !fs::exists(fclib_folder)) {
    std::cout << "SKIPPED: " << fclib_folder << " is absent\n";
    return true;
  }
  return false;
}

/// Two contacts of 3D, coupled, W in triplets.
struct Parts {
  std::vector<std::int32_t> spacedim{3}, m{6}, n{6}, nz, p, i;
  std::vector<double> x, q{-1, 0, 0, -1, 0.5, 0}, mu{0.5, 0.3};

  Parts() {
    for (int k = 0; k < 6; ++k) p.push_back(k), i.push_back(k), x.push_back(2);
    p.push_back(3), i.push_back(0), x.push_back(0.5);
    p.push_back(0), i.push_back(3), x.push_back(0.5);
    nz = {static_cast<std::int32_t>(x.size())};
  }
  void write(const std::string& name) const {
    Hdf5File file = Hdf5File::create(name);
    file.write("/fclib_local/spacedim", spacedim);
    file.write("/fclib_local/W/m", m);
    file.write("/fclib_local/W/n", n);
    file.write("/fclib_local/W/nz", nz);
    file.write("/fclib_local/W/p", p);
    file.write("/fclib_local/W/i", i);
    file.write("/fclib_local/W/x", x);
    file.write("/fclib_local/vectors/q", q);
    file.write("/fclib_local/vectors/mu", mu);
  }
};

/// A body and one contact, whose frame is the world's: M, H = 1, f and w.
void write_global(const std::string& name, const Eigen::Matrix3d& mass) {
  Hdf5File file = Hdf5File::create(name);
  const auto matrix = [&](const std::string& path, const Eigen::Matrix3d& dense) {
    std::vector<std::int32_t> row, column;
    std::vector<double> x;
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j)
        if (dense(i, j) != 0) row.push_back(i), column.push_back(j), x.push_back(dense(i, j));
    file.write(path + "/m", std::vector<std::int32_t>{3});
    file.write(path + "/n", std::vector<std::int32_t>{3});
    file.write(path + "/nz", std::vector<std::int32_t>{static_cast<std::int32_t>(x.size())});
    file.write(path + "/p", column);
    file.write(path + "/i", row);
    file.write(path + "/x", x);
  };
  file.write("/fclib_global/spacedim", std::vector<std::int32_t>{3});
  matrix("/fclib_global/M", mass);
  matrix("/fclib_global/H", Eigen::Matrix3d::Identity());
  file.write("/fclib_global/vectors/f", std::vector<double>{-3, 1, 0});
  file.write("/fclib_global/vectors/w", std::vector<double>{0, 0, 0.5});
  file.write("/fclib_global/vectors/mu", std::vector<double>{0.4});
}

/// The error that a file gives, without the name of the file.
std::string error_of(const std::string& name) {
  try {
    read_fclib(name);
  } catch (const std::runtime_error& error) {
    const std::string text = error.what();
    CHECK(text.find('\n') == std::string::npos);
    REQUIRE(text.compare(0, name.size(), name) == 0);
    return text.substr(name.size() + 2);
  }
  return "";
}

}  // namespace

TEST_CASE("a problem in triplets, rows or columns is the same problem") {
  if (without_hdf5()) return;
  const TemporaryFile file;
  const Parts triplets;
  triplets.write(file.name);
  const auto given = std::get<StoredProblem<3>>(read_fclib(file.name)).problem;
  REQUIRE(given.size() == 2);
  CHECK(given.width() == 3);
  CHECK(given.contacts[0].w(0, 0) == 2);
  CHECK(given.contacts[1].mu == 0.3);
  REQUIRE(given.couplings() == 2);
  CHECK(given.block<3>(0)(0, 0) == 0.5);
  for (const int storage : {-1, -2}) {  // W is symmetric: its rows are its columns
    Parts compressed;
    compressed.nz = {storage};
    compressed.p = {0, 2, 3, 4, 6, 7, 8};
    compressed.i = {0, 3, 1, 2, 0, 3, 4, 5};
    compressed.x = {2, 0.5, 2, 2, 0.5, 2, 2, 2};
    compressed.write(file.name);
    const auto problem = std::get<StoredProblem<3>>(read_fclib(file.name)).problem;
    CHECK(problem.contacts[0].w == given.contacts[0].w);
    CHECK(problem.block<3>(0) == given.block<3>(0));
    CHECK(problem.block<3>(1) == given.block<3>(1));
  }
}

TEST_CASE("a problem that is written is read back to the last bit, with what FCLIB does not know") {
  if (without_hdf5()) return;
  const TemporaryFile file;
  std::mt19937 engine(1);
  std::uniform_real_distribution<double> unit(-1, 1);
  ContactProblem<2> problem;
  const auto block = [&] {
    return ContactProblem<2>::Block::NullaryExpr([&] { return unit(engine); }).eval();
  };
  std::vector<ContactProblem<2>::Row> start;
  for (int a = 0; a < 3; ++a) {
    ContactProblem<2>::Contact contact;
    contact.w = block();
    contact.q = block().col(0);
    contact.mu = 0.4, contact.c_t = 0.1 * a, contact.mu_r = 0.02, contact.normal = a != 1,
    contact.speed_scale = 0.1;
    problem.contacts.push_back(contact);
    problem.first.push_back(problem.couplings());
    problem.couple((a + 1) % 3, block());
    start.push_back(block().col(1));
  }
  problem.first.push_back(problem.couplings());
  write_fclib(file.name, problem, start, "test");
  const auto stored = std::get<StoredProblem<2>>(read_fclib(file.name));
  REQUIRE(stored.problem.size() == 3);
  for (int a = 0; a < 3; ++a) {
    const auto &given = problem.contacts[a], &found = stored.problem.contacts[a];
    CHECK(found.w == given.w);
    CHECK(found.q == given.q);
    CHECK(stored.start[a] == start[a]);
    CHECK(found.mu == given.mu);
    CHECK(found.c_t == given.c_t);
    CHECK(found.mu_r == given.mu_r);
    CHECK(found.normal == given.normal);
    CHECK(found.speed_scale == given.speed_scale);
    CHECK(stored.problem.block<3>(a) == problem.block<3>(a));
  }
}

TEST_CASE("a broken file gives one line that says what is wrong") {
  if (without_hdf5()) return;
  const TemporaryFile file;
  const auto error_with = [&](auto change) {
    Parts parts;
    change(parts);
    parts.write(file.name);
    return error_of(file.name);
  };
  CHECK(error_with([](Parts&) {}).empty());
  CHECK(error_with([](Parts& p) { p.n = {5}; }) == "/fclib_local/W: is 6 by 5, expected a square");
  CHECK(error_with([](Parts& p) { p.i[2] = 6; }) ==
        "/fclib_local/W: entry 2 stands at row 6, column 2 of a 6 by 6 matrix");
  CHECK(error_with([](Parts& p) { p.m = {7}; }) == "/fclib_local/W: is 7 by 6, expected a square");
  CHECK(error_with([](Parts& p) { p.m = {-1}; }) == "/fclib_local/W/m: -1 is not a sensible number of rows");
  CHECK(error_with([](Parts& p) { p.m = {6, 6}; }) == "/fclib_local/W/m: expected one integer, found 2");
  CHECK(error_with([](Parts& p) { p.nz = {-7}; }) ==
        "/fclib_local/W/nz: -7 names no storage, expected -1, -2 or a number of triplets");
  CHECK(error_with([](Parts& p) { p.x.pop_back(); }) == "/fclib_local/W/x: expected 8 numbers, found 7");
  CHECK(error_with([](Parts& p) { p.nz = {-1}; }) == "/fclib_local/W/p: expected 7 numbers, found 8");
  CHECK(error_with([](Parts& p) { p.x[3] = std::nan(""); }) == "/fclib_local/W/x: number 3 is not finite");
  CHECK(error_with([](Parts& p) { p.q.push_back(0); }) ==
        "/fclib_local/vectors/q: expected 6 numbers, found 7");
  CHECK(error_with([](Parts& p) { p.mu = {0.5}; }) == "/fclib_local/vectors/mu: expected 2 numbers, found 1");
  CHECK(error_with([](Parts& p) { p.mu[1] = -0.5; }) ==
        "/fclib_local/vectors/mu: number 1 is -0.5, must be at least 0");
  // Before a matrix of that size is made: it would take gigabytes.
  CHECK(error_with([](Parts& p) { p.m = p.n = {100'000'000}; }) ==
        "/fclib_local/vectors/q: expected 100000000 numbers, found 6");
  CHECK(error_with([](Parts& p) { p.spacedim = {4}; }) == "/fclib_local/spacedim: is 4, expected 2 or 3");
  CHECK(error_with([](Parts& p) { p.spacedim = {2}; }) ==
        "/fclib_local/vectors/mu: expected 3 numbers, found 2");

  Parts().write(file.name);
  fs::resize_file(file.name, fs::file_size(file.name) / 2);
  CHECK(error_of(file.name) == "cannot be opened as an HDF5 file");
  std::ofstream(file.name) << "no HDF5";
  CHECK(error_of(file.name) == "cannot be opened as an HDF5 file");
  Hdf5File::create(file.name).write("/other", std::vector<double>{1});
  CHECK(error_of(file.name) == "holds no /fclib_local and no /fclib_global: it is no FCLIB problem");
}

TEST_CASE("a global problem gives W = H^T M^-1 H and q = H^T M^-1 f + w, its M is symmetric and regular") {
  if (without_hdf5()) return;
  const TemporaryFile file;
  Eigen::Matrix3d mass;
  mass << 2, 0.5, 0, 0.5, 3, 0, 0, 0, 4;
  write_global(file.name, mass);
  const auto problem = std::get<StoredProblem<3>>(read_fclib(file.name)).problem;
  REQUIRE(problem.size() == 1);
  const Eigen::Matrix3d w = problem.contacts[0].w.topLeftCorner<3, 3>();
  const Eigen::Vector3d q = problem.contacts[0].q.head<3>();
  CHECK((w * mass - Eigen::Matrix3d::Identity()).norm() < 1e-15);
  CHECK((q - (mass.inverse() * Eigen::Vector3d(-3, 1, 0) + Eigen::Vector3d(0, 0, 0.5))).norm() < 1e-15);

  Eigen::Matrix3d other = mass;
  other(0, 1) = 0.4;
  write_global(file.name, other);
  CHECK(error_of(file.name) == "/fclib_global/M: is not symmetric");
  other = mass;
  other.row(2).setZero();
  write_global(file.name, other);
  CHECK(error_of(file.name) == "/fclib_global/M: is singular");
}

TEST_CASE("the merit is the one of the tables of FCLIB's problems", "[data]") {
  if (without_data()) return;
  struct Known {
    const char* name;
    double at_zero;
  };
  for (const auto& [name, at_zero] :
       {Known{"FrictionContactProblem00237", 0.299490048}, Known{"FrictionContact3D_RR_1c", 0.384162141},
        Known{"OneObject-i100000-499", 0.00385217131}, Known{"RockPile_tob1", 0.20192206},
        Known{"Box_Stacks-i0122-82-5", 0.945051353}}) {
    const std::string file = fclib_folder + name + ".hdf5";
    std::visit(
        [&](const auto& stored) {
          auto r = stored.start;
          INFO(name);
          CHECK(merit(stored.problem, r).relative() == Approx(at_zero).epsilon(1e-8));
          const Hdf5File data = Hdf5File::open(file);
          const auto solution = data.doubles("/solution/r");
          const int width = stored.problem.width();
          for (std::size_t k = 0; k < solution.size(); ++k) r[k / width][k % width] = solution[k];
          CHECK(merit(stored.problem, r).relative() < 1e-6);
        },
        read_fclib(file));
  }
}

TEST_CASE("a global problem is condensed to the local one", "[data]") {
  if (without_data()) return;
  const std::string name = "Box_Stacks-i0122-82-5.hdf5";
  const auto global = std::get<StoredProblem<3>>(read_fclib(fclib_folder + "original/" + name));
  const auto local = std::get<StoredProblem<3>>(read_fclib(fclib_folder + name));
  REQUIRE(global.problem.size() == local.problem.size());
  for (int a = 0; a < local.problem.size(); ++a) {
    CHECK((global.problem.contacts[a].w - local.problem.contacts[a].w).norm() <=
          1e-12 * local.problem.contacts[a].w.norm());
    CHECK((global.problem.contacts[a].q - local.problem.contacts[a].q).norm() <= 1e-12);
  }
}

TEST_CASE("every problem of FCLIB is solved to 1e-8, in few sweeps to 1e-4", "[data]") {
  if (without_data()) return;
  // The sweeps to 1e-4 of Siconos 4.4.0, NSGS, from the README of the data; 0: it fails.
  struct Known {
    const char* name;
    int sweeps;
  };
  for (const auto& [name, sweeps] :
       {Known{"FrictionContactProblem00237", 131}, Known{"FrictionContact3D_1c", 1},
        Known{"FrictionContact3D_RR_1c", 1}, Known{"Confeti-ex13-4contact-Fc3D-SBM", 1},
        Known{"Rover1040", 9}, Known{"NESpheres_10_1", 7}, Known{"OneObject-i100000-499", 0},
        Known{"local_problem_test", 34350}, Known{"Confeti-ex03-Fc3D-SBM", 31},
        Known{"LMGC_100_PR_PerioBox-i00361-60-03000", 261}, Known{"Box_Stacks-i0122-82-5", 13},
        Known{"Capsules-i101-404", 12}, Known{"Capsules-i125-1213", 12}, Known{"Spheres-i099-356-679", 99}}) {
    INFO(name);
    std::visit(
        [&](const auto& stored) {
          SolveSettings settings;
          settings.measure = ErrorMeasure::merit;
          settings.max_iterations = 10000;
          settings.tolerance = 1e-4;
          settings.solver = SolverKind::nlgs;
          auto r = stored.start;
          const SolveResult rough = solve(stored.problem, settings, r);
          CHECK(rough.converged);
          if (sweeps > 0) CHECK(rough.iterations <= sweeps);
          settings.tolerance = 1e-8;
          for (const SolverKind kind : {SolverKind::automatic, SolverKind::proximal_newton}) {
            settings.solver = kind;
            r = stored.start;
            CHECK(solve(stored.problem, settings, r).converged);
            CHECK(merit(stored.problem, r).relative() <= 1e-8);
          }
        },
        read_fclib(fclib_folder + name + ".hdf5"));
  }
}

TEST_CASE("the pile of rocks of FCLIB, the hardest of its problems, is solved to 1e-8 too", "[data][slow]") {
  if (without_data()) return;
  const auto stored = std::get<StoredProblem<3>>(read_fclib(fclib_folder + "RockPile_tob1.hdf5"));
  SolveSettings settings;
  settings.measure = ErrorMeasure::merit;
  settings.max_iterations = 100000;
  settings.tolerance = 1e-8;
  auto r = stored.start;
  CHECK(solve(stored.problem, settings, r).converged);
  CHECK(merit(stored.problem, r).relative() <= 1e-8);
}
