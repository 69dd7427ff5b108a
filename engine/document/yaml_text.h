#pragma once
// Looks at the text of a YAML file where yaml-cpp says nothing, or nothing clear.

#include <memory>
#include <string>

#include "document/diagnostics.h"

namespace flyrock {

/// Its lines, without their ends.
std::shared_ptr<const Source> source_of(const std::string& text, const std::string& name);

/// yaml-cpp guesses at bytes that are no text, and a result file could not hold them. Reports the first line.
bool has_foreign_bytes(const std::shared_ptr<const Source>& source, Diagnostics& diagnostics);

/// Reports each line.
bool has_tab_indentation(const std::shared_ptr<const Source>& source, Diagnostics& diagnostics);

/// Of a scalar that begins at a line and byte, from 0: whether its quote is closed before the next key, or
/// what is wrong. A quote that is closed later, or by the end of the file, swallows the keys between.
std::string quote_fault(const Source& source, int line, int byte);

}  // namespace flyrock
