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

void take_out(Blast& blast, std::initializer_list<BlastField> fields) {
  for (const BlastField field : fields) blast[field] = std::numeric_limits<double>::quiet_NaN();
}

}  // namespace

void force(BlastField field, double value, Blast& blast) {
  if (field == hole_stemming || field == hole_length) take_out(blast, {hole_charge_length, hole_charge});
  if (field == hole_charge_length) take_out(blast, {hole_length, hole_charge});
  if (field == hole_charge) take_out(blast, {hole_linear_charge});
  if (field == hole_linear_charge) take_out(blast, {hole_charge});
  if (field == explosive_density || field == hole_diameter)
    take_out(blast, {hole_charge, hole_linear_charge});
  if (field == burden_crest || field == burden_toe || field == hole_deviation) take_out(blast, {burden});
  blast[field] = value;
}

void put_own(const Hole& hole, Blast& blast) {
  const Blast& own = hole.own;
  if (count_fields(own, {hole_length, hole_stemming, hole_charge_length}) >= 2)
    take_out(blast, {hole_length, hole_stemming, hole_charge_length});
  if (count_fields(own, {hole_charge, hole_linear_charge}) > 0)
    take_out(blast, {hole_charge, hole_linear_charge});
  if (count_fields(own, {hole_dip, hole_deviation}) > 0) take_out(blast, {hole_dip, hole_deviation});
  for (std::size_t i = 0; i < own.values.size(); ++i)
    if (!std::isnan(own.values[i])) blast.values[i] = own.values[i];
  const bool has_ends = count_fields(blast, {burden_crest, burden_toe}) == 2;
  if (has_ends && !has_field(own, burden) && count_fields(own, {burden_crest, burden_toe}) > 0)
    take_out(blast, {burden});
}

}  // namespace flyrock
