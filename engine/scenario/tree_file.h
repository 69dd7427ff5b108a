#pragma once
// Trees in a text file: CSV with the header x,y,dbh_cm,height_m[,species].

#include <map>
#include <string>
#include <vector>

#include "geometry/forest.h"

namespace flyrock {

/// Reads a tree a line: its place in plan [m], its diameter at breast height [cm], its height [m] and its
/// species, a key of `strengths`, which are the factors on the energy that a tree takes. Without the column,
/// or with no `strengths`, they are 1. Throws PluginError: "FILE:3:17: what is wrong".
std::vector<Stem> read_trees(const std::string& path, const std::map<std::string, double>& strengths);

}  // namespace flyrock
