// Friction problems in the layout of FCLIB: files of our own with wrong sizes and numbers, and damaged ones.

#include <filesystem>

#include "corpus.h"
#include "files/safe_file.h"
#include "kind.h"
#include "mutate_text.h"
#include "solver/hdf5_file.h"

namespace flyrock::fuzz {

namespace {

/// The data sets of a problem by their path.
struct Problem {
  std::vector<std::pair<std::string, std::vector<std::int32_t>>> integers;
  std::vector<std::pair<std::string, std::vector<double>>> doubles;

  void write(const std::string& name) const {
    Hdf5File file = Hdf5File::create(name);
    for (const auto& [path, numbers] : integers) file.write(path, numbers);
    for (const auto& [path, numbers] : doubles) file.write(path, numbers);
  }
};

void add_matrix(Problem& problem, const std::string& path, std::int32_t rows, std::int32_t columns,
                const std::vector<std::array<double, 3>>& entries) {
  std::vector<std::int32_t> p, i;
  std::vector<double> x;
  for (const auto& [row, column, value] : entries) {
    i.push_back(static_cast<std::int32_t>(row));
    p.push_back(static_cast<std::int32_t>(column));
    x.push_back(value);
  }
  problem.integers.push_back({path + "/m", {rows}});
  problem.integers.push_back({path + "/n", {columns}});
  problem.integers.push_back({path + "/nz", {static_cast<std::int32_t>(x.size())}});
  problem.integers.push_back({path + "/p", p});
  problem.integers.push_back({path + "/i", i});
  problem.doubles.push_back({path + "/x", x});
}

/// Two contacts of 3D that are coupled; with a part of our own in /flyrock.
Problem local_problem() {
  Problem problem;
  problem.integers.push_back({"/fclib_local/spacedim", {3}});
  std::vector<std::array<double, 3>> entries;
  for (int k = 0; k < 6; ++k) entries.push_back({double(k), double(k), 2});
  entries.push_back({0, 3, 0.5});
  entries.push_back({3, 0, 0.5});
  add_matrix(problem, "/fclib_local/W", 6, 6, entries);
  problem.doubles.push_back({"/fclib_local/vectors/q", {-1, 0, 0, -1, 0.5, 0}});
  problem.doubles.push_back({"/fclib_local/vectors/mu", {0.5, 0.3}});
  problem.doubles.push_back({"/flyrock/c_t", {0, 1}});
  problem.doubles.push_back({"/flyrock/speed_scale", {1, 1}});
  problem.doubles.push_back({"/guesses/1/r", {1, 0, 0, 1, 0, 0}});
  return problem;
}

/// Two bodies of 2D on a floor: M, H, f, w.
Problem global_problem() {
  Problem problem;
  problem.integers.push_back({"/fclib_global/spacedim", {2}});
  std::vector<std::array<double, 3>> mass, map;
  for (int k = 0; k < 4; ++k) {
    mass.push_back({double(k), double(k), 3});
    map.push_back({double(k), double(k), 1});
  }
  add_matrix(problem, "/fclib_global/M", 4, 4, mass);
  add_matrix(problem, "/fclib_global/H", 4, 4, map);
  problem.doubles.push_back({"/fclib_global/vectors/f", {0, -9.81, 0, -9.81}});
  problem.doubles.push_back({"/fclib_global/vectors/w", {0, 0, 0, 0}});
  problem.doubles.push_back({"/fclib_global/vectors/mu", {0.5, 0.5}});
  return problem;
}

template <class Number>
void change(std::vector<std::pair<std::string, std::vector<Number>>>& sets, const std::vector<Number>& nasty,
            Dice& dice) {
  const std::size_t at = dice.below(sets.size());
  std::vector<Number>& numbers = sets[at].second;
  switch (dice.below(6)) {
    case 0:
      sets.erase(sets.begin() + static_cast<std::ptrdiff_t>(at));
      break;
    case 1:
      numbers.push_back(dice.pick(nasty));
      break;
    case 2:
      numbers.resize(dice.below(numbers.size() + 1));
      break;
    default:
      if (!numbers.empty()) dice.pick(numbers) = dice.pick(nasty);
  }
}

class Problems : public Kind {
 public:
  void attempt(Dice& dice, Calls& call) override {
    Problem problem = dice.one_in(2) ? local_problem() : global_problem();
    const bool as_bytes = dice.one_in(2);
    if (!as_bytes) change_numbers(problem, dice);
    problem.write("p.hdf5");
    if (as_bytes) {
      std::string bytes = read_file("p.hdf5");
      mutate_bytes(bytes, dice);
      write_here("p.hdf5", bytes);
    }
    static const std::vector<const char*> solvers = {"auto", "nlgs", "proximal_newton"};
    call({"solve", "p.hdf5", "--max-iterations", "1000", "--solver", dice.pick(solvers)}, ErrorForm::named);
  }

 private:
  static void change_numbers(Problem& problem, Dice& dice) {
    static const std::vector<std::int32_t> integers = {0, 1, -1, -2,  -3,          2,          3,
                                                       4, 6, 7,  100, 100'000'000, 2147483647, -2147483647};
    static const std::vector<double> doubles = {0,     -0.0,  1,      -1,    1e-300, 1e-16, 1e16,
                                                1e155, 1e300, -1e300, 1e308, 5e-324, 0.5,   -2};
    do dice.one_in(2) ? change(problem.integers, integers, dice) : change(problem.doubles, doubles, dice);
    while (dice.one_in(3));
  }
};

}  // namespace

std::unique_ptr<Kind> make_problem_kind() {
  if (!has_hdf5()) return nullptr;
  return std::make_unique<Problems>();
}

}  // namespace flyrock::fuzz
