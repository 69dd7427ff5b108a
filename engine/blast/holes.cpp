#include "blast/holes.h"

#include <cmath>
#include <initializer_list>

namespace flyrock {

namespace {

using enum BlastField;

bool has_field(const Blast& blast, BlastField field) { return !std::isnan(blast[field]); }

int count_fields(const Blast& blast, std::initializer_list<BlastField> fields) {
  int count = 0;
  for (const BlastField field : fields) count += has_field(blast, field);
  return count;
}

/// A blast whose fields are taken out and given, with the notes of who gave them.
struct Given {
  Blast& blast;
  BlastSources* sources;

  void take_out(std::initializer_list<BlastField> fields) {
    for (const BlastField field : fields) {
      blast[field] = std::numeric_limits<double>::quiet_NaN();
      if (sources) sources->take_out(field);
    }
  }
  void give(BlastField field, double value, Giver giver) {
    blast[field] = value;
    if (sources) sources->give(field, giver);
  }
};

}  // namespace

void force(BlastField field, double value, Blast& blast, BlastSources* sources) {
  Given given{blast, sources};
  if (field == hole_stemming || field == hole_length) given.take_out({hole_charge_length, hole_charge});
  if (field == hole_charge_length) given.take_out({hole_length, hole_charge});
  if (field == hole_charge) given.take_out({hole_linear_charge});
  if (field == hole_linear_charge) given.take_out({hole_charge});
  if (field == explosive_density || field == hole_diameter) given.take_out({hole_charge, hole_linear_charge});
  if (field == burden_crest || field == burden_toe || field == hole_deviation) given.take_out({burden});
  given.give(field, value, Giver::blast);
}

void put_own(const Hole& hole, Blast& blast, BlastSources* sources) {
  const Blast& own = hole.own;
  Given given{blast, sources};
  if (count_fields(own, {hole_length, hole_stemming, hole_charge_length}) >= 2)
    given.take_out({hole_length, hole_stemming, hole_charge_length});
  if (count_fields(own, {hole_charge, hole_linear_charge}) > 0)
    given.take_out({hole_charge, hole_linear_charge});
  if (count_fields(own, {hole_dip, hole_deviation}) > 0) given.take_out({hole_dip, hole_deviation});
  for (const BlastFieldInfo& info : blast_fields())
    if (has_field(own, info.field)) given.give(info.field, own[info.field], Giver::hole);
  const bool has_ends = count_fields(blast, {burden_crest, burden_toe}) == 2;
  if (has_ends && !has_field(own, burden) && count_fields(own, {burden_crest, burden_toe}) > 0)
    given.take_out({burden});
}

}  // namespace flyrock
