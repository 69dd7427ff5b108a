// The factories of flyrock's own native plugins.

#include "plugin/module.h"

FLYROCK_MODULE(table) {
  (void)table;
  return nullptr;
}
