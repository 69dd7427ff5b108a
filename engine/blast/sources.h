#pragma once
// From which given numbers each field of a completed blast follows. It is noted where they are read: by
// complete() (blast/design.h) and where the surveyed face gives a burden.

#include <bitset>
#include <cmath>

#include "blast/blast.h"

namespace flyrock {

/// Who gives a field: the blast of all holes (`blast.burden`), or a measured hole (its column `burden`).
enum class Giver { blast, hole };

/// The given fields that the value of each field was computed from. A given field follows from itself.
class BlastSources {
 public:
  static constexpr std::size_t fields = static_cast<std::size_t>(BlastField::count);
  using Set = std::bitset<2 * fields>;

  void give(BlastField field, Giver giver) { of(field) = Set().set(bit(field, giver)); }
  void take_out(BlastField field) { of(field).reset(); }
  void compute(BlastField field, const Set& read) { of(field) = read; }

  const Set& operator[](BlastField field) const { return of_[static_cast<std::size_t>(field)]; }
  bool follows(BlastField field, BlastField from, Giver giver) const {
    return (*this)[field][bit(from, giver)];
  }

 private:
  static std::size_t bit(BlastField field, Giver giver) {
    return static_cast<std::size_t>(field) + (giver == Giver::hole ? fields : 0);
  }
  Set& of(BlastField field) { return of_[static_cast<std::size_t>(field)]; }

  std::array<Set, fields> of_;
};

/// Computes fields of a blast from other fields, and notes for each one that is put the ones that were read
/// since the last. Without `sources` it notes nothing.
class BlastWriter {
 public:
  BlastWriter(Blast& blast, BlastSources* sources) : blast_(blast), sources_(sources) {}

  bool has(BlastField field) const { return !std::isnan(blast_[field]); }
  /// The value, without a note: for checks.
  double operator[](BlastField field) const { return blast_[field]; }
  double read(BlastField field) {
    if (sources_) read_ |= (*sources_)[field];
    return blast_[field];
  }
  double read_or_zero(BlastField field) { return has(field) ? read(field) : 0; }
  void put(BlastField field, double value) {
    blast_[field] = value;
    if (sources_) sources_->compute(field, std::isnan(value) ? BlastSources::Set() : read_);
    read_.reset();
  }

 private:
  Blast& blast_;
  BlastSources* sources_;
  BlastSources::Set read_;
};

}  // namespace flyrock
