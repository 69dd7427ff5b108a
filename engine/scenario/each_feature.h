#pragma once
// Zones, gates, barriers and exposures that stand for many: one for each value of an attribute of a layer.

#include "scenario/decode_context.h"

namespace flyrock {

/// Replaces an entry `{ name: NAME, line: { layer: FILE, each: ATTRIBUTE } }` of `terrain.zones`, `gates`,
/// `barriers` and `exposure` by one entry for each value that the attribute has, in the order of the file:
/// `{ name: NAME_VALUE, line: { layer: FILE, where: { ATTRIBUTE: VALUE } } }`. All other keys are those of
/// the entry. In a name a character of the value other than a letter, digit, `_` or `-` becomes `_`. Reports
/// layers that have no such attribute, and features without a value.
void expand_each_feature(Value& root, DecodeContext& context);

}  // namespace flyrock
