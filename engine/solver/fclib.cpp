#include "solver/fclib.h"

#include <fmt/format.h>

#include <Eigen/SparseCholesky>
#include <map>
#include <stdexcept>

#include "plugin/in_child.h"
#include "solver/hdf5_file.h"

namespace flyrock {

namespace {

using Sparse = Eigen::SparseMatrix<double, Eigen::ColMajor, int>;
constexpr int compressed_columns = -1, compressed_rows = -2;

[[noreturn]] void refuse(const Hdf5File& file, const std::string& path, const std::string& what) {
  throw std::runtime_error(fmt::format("{}: {}: {}", file.name(), path, what));
}

int count_of(const Hdf5File& file, const std::string& path) {
  constexpr std::int64_t most = 100'000'000;
  const std::int64_t count = file.integer(path);
  if (count < 0 || count > most)
    refuse(file, path, fmt::format("{} is not a sensible number of rows", count));
  return static_cast<int>(count);
}

void expect_size(const Hdf5File& file, const std::string& path, std::size_t found, std::size_t expected) {
  if (found != expected) refuse(file, path, fmt::format("expected {} numbers, found {}", expected, found));
}

/// Rows and columns that the file states for a matrix. The vectors of the file must agree with them before
/// anything of this size is allocated.
struct Shape {
  int rows = 0, columns = 0;
};

Shape shape_of(const Hdf5File& file, const std::string& path) {
  return {count_of(file, path + "/m"), count_of(file, path + "/n")};
}

Shape square_of(const Hdf5File& file, const std::string& path) {
  const Shape shape = shape_of(file, path);
  if (shape.rows != shape.columns)
    refuse(file, path, fmt::format("is {} by {}, expected a square", shape.rows, shape.columns));
  return shape;
}

/// Reads a matrix in any of FCLIB's three storage formats. Repeated entries add up, as in its triplets.
Sparse read_matrix(const Hdf5File& file, const std::string& path, const Shape& shape) {
  const auto [m, n] = shape;
  const std::int64_t nz = file.integer(path + "/nz");
  const auto p = file.integers(path + "/p"), i = file.integers(path + "/i");
  const auto x = file.doubles(path + "/x");
  if (nz < compressed_rows)
    refuse(file, path + "/nz",
           fmt::format("{} names no storage, expected -1, -2 or a number of triplets", nz));
  std::vector<Eigen::Triplet<double, int>> entries;
  const auto add = [&](std::int64_t row, std::int64_t column, std::size_t k) {
    if (row < 0 || row >= m || column < 0 || column >= n)
      refuse(file, path,
             fmt::format("entry {} stands at row {}, column {} of a {} by {} matrix", k, row, column, m, n));
    entries.emplace_back(static_cast<int>(row), static_cast<int>(column), x[k]);
  };
  if (nz >= 0) {
    const auto count = static_cast<std::size_t>(nz);
    for (const auto& [name, size] :
         {std::pair("/i", i.size()), std::pair("/p", p.size()), std::pair("/x", x.size())})
      if (size < count) refuse(file, path + name, fmt::format("expected {} numbers, found {}", count, size));
    for (std::size_t k = 0; k < count; ++k) add(i[k], p[k], k);
  } else {
    const std::size_t lines = nz == compressed_columns ? n : m;
    expect_size(file, path + "/p", p.size(), lines + 1);
    if (p[0] != 0) refuse(file, path + "/p", "does not begin at 0");
    for (std::size_t line = 0; line < lines; ++line)
      if (p[line + 1] < p[line]) refuse(file, path + "/p", fmt::format("falls at number {}", line + 1));
    const auto count = static_cast<std::size_t>(p[lines]);
    if (i.size() < count)
      refuse(file, path + "/i", fmt::format("expected {} numbers, found {}", count, i.size()));
    if (x.size() < count)
      refuse(file, path + "/x", fmt::format("expected {} numbers, found {}", count, x.size()));
    for (std::size_t line = 0; line < lines; ++line)
      for (auto k = static_cast<std::size_t>(p[line]); k < static_cast<std::size_t>(p[line + 1]); ++k)
        nz == compressed_columns ? add(i[k], static_cast<std::int64_t>(line), k)
                                 : add(static_cast<std::int64_t>(line), i[k], k);
  }
  Sparse matrix(m, n);
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

Eigen::VectorXd read_vector(const Hdf5File& file, const std::string& path, Eigen::Index size) {
  expect_size(file, path, file.count(path), static_cast<std::size_t>(size));
  const std::vector<double> numbers = file.doubles(path);
  return Eigen::Map<const Eigen::VectorXd>(numbers.data(), size);
}

struct Operator {
  Sparse w;
  Eigen::VectorXd q;
};

Operator read_local(const Hdf5File& file) {
  const Shape shape = square_of(file, "/fclib_local/W");
  if (file.has("/fclib_local/V")) refuse(file, "/fclib_local/V", "equality constraints are not supported");
  Eigen::VectorXd q = read_vector(file, "/fclib_local/vectors/q", shape.rows);
  return {read_matrix(file, "/fclib_local/W", shape), std::move(q)};
}

Operator condense(const Hdf5File& file) {
  const Shape of_m = square_of(file, "/fclib_global/M"), of_h = shape_of(file, "/fclib_global/H");
  if (file.has("/fclib_global/G")) refuse(file, "/fclib_global/G", "equality constraints are not supported");
  if (of_h.rows != of_m.rows)
    refuse(file, "/fclib_global/H", fmt::format("has {} rows, M has {}", of_h.rows, of_m.rows));
  const Eigen::VectorXd f = read_vector(file, "/fclib_global/vectors/f", of_m.rows);
  const Eigen::VectorXd w = read_vector(file, "/fclib_global/vectors/w", of_h.columns);
  const Sparse m = read_matrix(file, "/fclib_global/M", of_m), h = read_matrix(file, "/fclib_global/H", of_h);
  if (!Sparse(m.transpose()).isApprox(m)) refuse(file, "/fclib_global/M", "is not symmetric");
  const Eigen::SimplicialLDLT<Sparse> mass(m);
  if (mass.info() != Eigen::Success) refuse(file, "/fclib_global/M", "is singular");
  const Sparse mobility = mass.solve(h);
  const Sparse transposed = h.transpose();
  return {transposed * mobility, transposed * mass.solve(f) + w};
}

/// The optional numbers of /flyrock, one per contact.
std::vector<double> own_numbers(const Hdf5File& file, const char* name, int contacts, double otherwise) {
  const std::string path = std::string("/flyrock/") + name;
  if (!file.has(path)) return std::vector<double>(static_cast<std::size_t>(contacts), otherwise);
  auto numbers = file.doubles(path);
  expect_size(file, path, numbers.size(), static_cast<std::size_t>(contacts));
  for (const double number : numbers)
    if (number < 0) refuse(file, path, fmt::format("{} is below 0", number));
  return numbers;
}

template <int D>
StoredProblem<D> to_blocks(const Hdf5File& file, const Operator& given, const std::string& group) {
  using Problem = ContactProblem<D>;
  const bool rolls = file.has("/flyrock/mu_r");
  const int width = rolls ? Problem::rows : D;
  const int size = static_cast<int>(given.w.rows());
  if (size == 0 || size % width != 0)
    refuse(file, group, fmt::format("W has {} rows, expected a multiple of {}", size, width));
  const int contacts = size / width;
  const auto mu = file.doubles(group + "/vectors/mu");
  expect_size(file, group + "/vectors/mu", mu.size(), static_cast<std::size_t>(contacts));
  const auto c_t = own_numbers(file, "c_t", contacts, 0), mu_r = own_numbers(file, "mu_r", contacts, 0);
  const auto mu_spin = own_numbers(file, "mu_spin", contacts, 0),
             normal = own_numbers(file, "normal", contacts, 1);
  const auto c_r = own_numbers(file, "c_r", contacts, 0), c_spin = own_numbers(file, "c_spin", contacts, 0);
  const auto speed_scale = own_numbers(file, "speed_scale", contacts, 1);

  std::vector<std::map<int, typename Problem::Block>> blocks(static_cast<std::size_t>(contacts));
  for (int column = 0; column < given.w.outerSize(); ++column)
    for (Sparse::InnerIterator entry(given.w, column); entry; ++entry) {
      const int row = static_cast<int>(entry.row());
      auto& block = blocks[row / width].try_emplace(column / width, Problem::Block::Zero()).first->second;
      block(row % width, column % width) = entry.value();
    }
  StoredProblem<D> stored;
  stored.problem.clear(width);
  for (int a = 0; a < contacts; ++a) {
    if (!(mu[a] >= 0))
      refuse(file, group + "/vectors/mu", fmt::format("number {} is {}, must be at least 0", a, mu[a]));
    typename Problem::Contact contact;
    const auto diagonal = blocks[a].find(a);
    contact.w = diagonal == blocks[a].end() ? Problem::Block::Zero().eval() : diagonal->second;
    contact.q.setZero();
    contact.q.head(width) = given.q.segment(a * width, width);
    contact.mu = mu[a], contact.c_t = c_t[a], contact.mu_r = mu_r[a], contact.mu_spin = mu_spin[a];
    contact.c_r = c_r[a], contact.c_spin = c_spin[a];
    contact.normal = normal[a] != 0, contact.speed_scale = speed_scale[a];
    stored.problem.contacts.push_back(contact);
    stored.problem.first.push_back(stored.problem.couplings());
    for (const auto& [b, block] : blocks[a])
      if (b != a) stored.problem.couple(b, block);
  }
  stored.problem.first.push_back(stored.problem.couplings());
  stored.start.assign(static_cast<std::size_t>(contacts), Problem::Row::Zero());
  // Use only a start that flyrock wrote, because a guess in a file from elsewhere is for comparison.
  if (file.has("/flyrock/speed_scale") && file.has("/guesses/1/r")) {
    const Eigen::VectorXd r = read_vector(file, "/guesses/1/r", size);
    for (int a = 0; a < contacts; ++a) stored.start[a].head(width) = r.segment(a * width, width);
  }
  return stored;
}

}  // namespace

AnyProblem read_fclib(const std::string& name) {
  const Hdf5File file = Hdf5File::open(name);
  const bool local = file.has("/fclib_local");
  if (!local && !file.has("/fclib_global"))
    throw std::runtime_error(
        fmt::format("{}: holds no /fclib_local and no /fclib_global: it is no FCLIB problem", name));
  const std::string group = local ? "/fclib_local" : "/fclib_global";
  const std::int64_t dimension = file.integer(group + "/spacedim");
  if (dimension != 2 && dimension != 3)
    refuse(file, group + "/spacedim", fmt::format("is {}, expected 2 or 3", dimension));
  const Operator given = local ? read_local(file) : condense(file);
  if (dimension == 2) return to_blocks<2>(file, given, group);
  return to_blocks<3>(file, given, group);
}

AnyProblem read_fclib_guarded(const std::string& name) {
  const bool succeeds = succeeds_in_child([&] {
    try {
      read_fclib(name);
    } catch (const std::exception&) {  // the parent process reports the error below
    }
  });
  if (!succeeds) throw std::runtime_error(fmt::format("{}: is damaged: the HDF5 library fails on it", name));
  return read_fclib(name);
}

template <int D>
void write_fclib(const std::string& name, const ContactProblem<D>& problem,
                 const std::vector<typename ContactProblem<D>::Row>& start, const std::string& title) {
  const int width = problem.width(), size = problem.size() * width;
  // Compressed columns of W are the compressed rows of its transpose.
  std::vector<Eigen::Triplet<double, int>> entries;
  const auto add = [&](int a, int b, const auto& block) {
    for (int row = 0; row < width; ++row)
      for (int column = 0; column < width; ++column)
        entries.emplace_back(a * width + row, b * width + column, block(row, column));
  };
  for (int a = 0; a < problem.size(); ++a) {
    add(a, a, problem.contacts[a].w);
    for (int k = problem.first[a]; k < problem.first[a + 1]; ++k)
      add(a, problem.other(k), problem.full_block(k));
  }
  Sparse w(size, size);
  w.setFromTriplets(entries.begin(), entries.end());

  std::vector<double> q, r, mu, c_t, mu_r, mu_spin, c_r, c_spin, normal, speed_scale;
  for (int a = 0; a < problem.size(); ++a) {
    const auto& contact = problem.contacts[a];
    for (int row = 0; row < width; ++row) q.push_back(contact.q[row]), r.push_back(start[a][row]);
    mu.push_back(contact.mu), c_t.push_back(contact.c_t), mu_r.push_back(contact.mu_r);
    c_r.push_back(contact.c_r), c_spin.push_back(contact.c_spin);
    mu_spin.push_back(contact.mu_spin), normal.push_back(contact.normal),
        speed_scale.push_back(contact.speed_scale);
  }
  Hdf5File file = Hdf5File::create(name);
  const auto one = [](int number) { return std::vector<std::int32_t>{number}; };
  file.write("/fclib_local/spacedim", one(D));
  file.write("/fclib_local/W/m", one(size));
  file.write("/fclib_local/W/n", one(size));
  file.write("/fclib_local/W/nz", one(compressed_columns));
  file.write("/fclib_local/W/nzmax", one(static_cast<int>(w.nonZeros())));
  file.write("/fclib_local/W/p", std::vector<std::int32_t>(w.outerIndexPtr(), w.outerIndexPtr() + size + 1));
  file.write("/fclib_local/W/i",
             std::vector<std::int32_t>(w.innerIndexPtr(), w.innerIndexPtr() + w.nonZeros()));
  file.write("/fclib_local/W/x", std::vector<double>(w.valuePtr(), w.valuePtr() + w.nonZeros()));
  file.write("/fclib_local/vectors/q", q);
  file.write("/fclib_local/vectors/mu", mu);
  file.write("/fclib_local/info/title", title);
  file.write("/fclib_local/info/description", std::string("a step that did not converge"));
  file.write("/fclib_local/info/math_info", std::string(" "));
  file.write("/guesses/number_of_guesses", one(1));
  file.write("/guesses/1/r", r);
  file.write("/flyrock/speed_scale", speed_scale);
  file.write("/flyrock/c_t", c_t);
  file.write("/flyrock/normal", normal);
  if (width > D) {
    file.write("/flyrock/mu_r", mu_r);
    file.write("/flyrock/mu_spin", mu_spin);
    file.write("/flyrock/c_r", c_r);
    file.write("/flyrock/c_spin", c_spin);
  }
}

template void write_fclib<2>(const std::string&, const ContactProblem<2>&,
                             const std::vector<ContactProblem<2>::Row>&, const std::string&);
template void write_fclib<3>(const std::string&, const ContactProblem<3>&,
                             const std::vector<ContactProblem<3>::Row>&, const std::string&);

}  // namespace flyrock
