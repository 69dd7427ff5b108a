#pragma once
// Tables of the scenario in all their forms: texts, sheets, and the attributes of a layer of a GIS.

#include "document/table.h"

namespace flyrock {

/// read_table, and in addition `pit.gpkg#LAYER` (without `#LAYER` the only layer), .geojson, or a shapefile
/// by its .shp or .dbf: the names of attributes are the heads, each feature is a record. Places are
/// attributes too, because a table is read before the system of the terrain is known.
std::optional<TextTable> read_any_table(const std::string& path, std::span<const TableColumn> columns,
                                        const std::map<std::string, std::string>& heads, const Node& where,
                                        Diagnostics& diagnostics);

}  // namespace flyrock
