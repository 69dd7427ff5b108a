#include "batch/chunk.h"

#include <fmt/format.h>
#include <zlib.h>

#include <algorithm>
#include <array>

#include "files/safe_file.h"
#include "record/columns.h"
#include "record/tables.h"

namespace flyrock {

namespace {

constexpr std::string_view magic = "flyrchnk";
constexpr std::uint64_t format = 21;

std::uint64_t crc(std::string_view bytes) {
  return ::crc32_z(0, reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size());
}

/// Writes or reads the columns of a table; `rows` is a vector of records, const where they are written.
template <class Io, class Rows>
auto columns_of(Io& io, Rows& rows) {
  return [&io, &rows](const Column&, auto get) { io.columns(rows, get); };
}

/// The trajectory of a body is stored in a table of its own (TrajectoryRecord), so it is not repeated here.
template <class Io, class Bodies>
void walk_bodies(Io& io, Bodies& bodies) {
  using B = BodyHistory;
  io.rows(bodies);
  const auto columns = columns_of(io, bodies);
  for (BodyState B::*state : {&B::first, &B::last, &B::min, &B::max}) visit_state(within(columns, state));
  io.columns(bodies, &B::min_speed, &B::max_speed, &B::reason, &B::fault, &B::stop_time, &B::contact_time,
             &B::max_distance, &B::landed, &B::flight_range, &B::bounce_height, &B::impact_count);
  for (auto& body : bodies) {
    io.rows(body.impacts);
    visit_impact(columns_of(io, body.impacts));
    io.rows(body.apexes);
    io.columns(body.apexes, &Apex::time, &Apex::height);
  }
}

/// Envelopes or maps.
template <class Io, class Totals>
void walk_bytes(Io& io, Totals& totals) {
  std::string bytes = totals.bytes();
  io.value(bytes);
  if constexpr (!std::is_const_v<Totals>) totals = Totals::read(bytes);
}

template <class Io, class Quality>
void walk_quality(Io& io, Quality& q) {
  for (const auto count : SolverQuality::counts) io.value(q.*count);
  for (const auto value : SolverQuality::greatest) io.value(q.*value);
  io.value(q.energy_gained), io.value(q.gained_by_slip), io.value(q.theta_loss),
      io.value(q.projection_energy);
  io.value(q.least_step), io.value(q.greatest_step), io.value(q.step_time);
  io.value(q.energy_relative_change);
}

template <class Io, class Totals>
void walk_totals(Io& io, Totals& totals) {
  io.rows(totals.materials);
  io.columns(totals.materials, &MaterialUse::contacts, &MaterialUse::restitution, &MaterialUse::friction,
             &MaterialUse::rolling, &MaterialUse::unilateral);
  walk_quality(io, totals.quality);
  io.rows(totals.notes);
  io.columns(
      totals.notes, [](auto& note) -> auto& { return note; });
  walk_bodies(io, totals.bodies);
}

/// What each part adds to the part before it.
template <class Io, class Records>
void walk_part(Io& io, Part part, Records& records) {
  visit_tables(records, [&](const Table& table, auto& rows, auto visit_columns) {
    if (table.part != part) return;
    io.rows(rows);
    const auto columns = columns_of(io, rows);
    visit_owner<typename std::decay_t<decltype(rows)>::value_type>(table, columns);
    visit_columns(columns);
  });
  if (part == Part::brief) {
    walk_totals(io, records.totals);
  } else {
    walk_bytes(io, records.totals.envelopes);
    walk_bytes(io, records.totals.maps);
  }
}

constexpr std::size_t word_size = 8;
constexpr std::array<Part, 2> parts = {Part::brief, Part::whole};

void write_header(ColumnWriter& out, const ChunkRange& range, const std::string& scenario_hash) {
  out.raw(magic);
  out.value(format);
  out.value(scenario_hash);
  out.value(range.point), out.value(range.index), out.value(range.first), out.value(range.count);
}

std::string header(const ChunkRange& range, const std::string& scenario_hash) {
  ColumnWriter out;
  write_header(out, range, scenario_hash);
  return out.take();
}

/// An estimate of the size of all tables of a chunk.
std::size_t size_of(const TrialRecords& records) {
  std::size_t bytes = 0;
  visit_tables(records,
               [&](const Table&, const auto& rows, auto) { bytes += rows.size() * sizeof(rows[0]); });
  return bytes;
}

/// The section whose length is stored at `at`, with its checksum checked. Moves `at` past the checksum.
std::string_view section(std::string_view bytes, std::size_t& at) {
  const auto read_word = [&] {
    std::uint64_t value = 0;
    ColumnReader(bytes.substr(at)).value(value);
    at += word_size;
    return value;
  };
  const std::uint64_t length = read_word();
  if (length > bytes.size() - at) throw ColumnError("cut short");
  const std::string_view tables = bytes.substr(at, length);
  at += length;
  if (read_word() != crc(tables)) throw ColumnError("damaged: its checksum is wrong");
  return tables;
}

}  // namespace

std::string ChunkRange::file_name() const { return fmt::format("p{}-c{}.chunk", point, index); }

std::uint64_t chunk_size(std::uint64_t trials) {
  const std::uint64_t of_few = std::min<std::uint64_t>((trials + 99) / 100, 10);
  return std::clamp<std::uint64_t>((trials + 999) / 1000, std::max<std::uint64_t>(of_few, 1), 250);
}

std::vector<ChunkRange> plan_chunks(int points, std::uint64_t trials, std::uint64_t size,
                                    std::uint64_t runs) {
  if (size == 0) size = chunk_size(trials);
  const std::uint64_t of_run = trials / runs;
  std::vector<ChunkRange> plan;
  for (int point = 0; point < points; ++point) {
    std::uint64_t index = 0;
    for (std::uint64_t end = of_run; end <= trials; end += of_run)
      for (std::uint64_t first = end - of_run; first < end; first += size)
        plan.push_back({point, index++, first, std::min(size, end - first)});
  }
  return plan;
}

std::string encode_chunk(const ChunkRange& range, const std::string& scenario_hash,
                         const TrialRecords& records) {
  ColumnWriter out(size_of(records));
  write_header(out, range, scenario_hash);
  for (const Part part : parts) {
    const std::size_t length_at = out.bytes().size();
    out.value(std::uint64_t{0});
    walk_part(out, part, records);
    const std::string_view tables = std::string_view(out.bytes()).substr(length_at + word_size);
    const std::uint64_t length = tables.size(), checksum = crc(tables);
    out.replace(length_at, length);
    out.value(checksum);
  }
  return out.take();
}

std::optional<TrialRecords> decode_chunk(std::string_view bytes, const ChunkRange& range,
                                         const std::string& scenario_hash, Part part, std::string& why) {
  const std::string expected = header(range, scenario_hash);
  TrialRecords records;
  try {
    if (!bytes.starts_with(magic)) throw ColumnError("not a chunk file");
    if (bytes.size() < expected.size()) throw ColumnError("cut short");
    if (!bytes.starts_with(expected)) throw ColumnError("of another format, scenario or range of trials");
    std::size_t at = expected.size();
    for (const Part each : parts) {
      if (each > part) return records;
      ColumnReader tables(section(bytes, at));
      walk_part(tables, each, records);
      if (!tables.at_end()) throw ColumnError("longer than its tables");
    }
    if (at != bytes.size()) throw ColumnError("longer than its tables");
  } catch (const ColumnError& error) {
    why = error.what();
    return std::nullopt;
  }
  return records;
}

std::optional<TrialRecords> read_chunk(const std::filesystem::path& path, const ChunkRange& range,
                                       const std::string& scenario_hash, Part part, std::string& why) {
  FileReader file(path);
  std::string bytes;
  file.append_to(bytes, header(range, scenario_hash).size());
  for (const Part each : parts) {
    const std::size_t at = bytes.size();
    file.append_to(bytes, word_size);
    if (each > part || bytes.size() < at + word_size) break;
    std::uint64_t length = 0;
    ColumnReader(std::string_view(bytes).substr(at)).value(length);
    file.append_to(bytes, length);
    file.append_to(bytes, word_size);  // the checksum
  }
  if (part == Part::whole) file.append_to(bytes, 1);  // must not exist
  return decode_chunk(bytes, range, scenario_hash, part, why);
}

}  // namespace flyrock
