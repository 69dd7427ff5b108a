#pragma once
// Checks of the text of a YAML file for mistakes that yaml-cpp does not report, or does not report clearly.

#include <memory>
#include <string>

#include "document/diagnostics.h"

namespace flyrock {

/// The lines of a text, without their line ends.
std::shared_ptr<const Source> source_of(const std::string& text, const std::string& name);

/// Reports the first line with bytes that are not text: yaml-cpp guesses at them, and a result file could not
/// hold them.
bool has_foreign_bytes(const std::shared_ptr<const Source>& source, Diagnostics& diagnostics);

/// Reports each line that is indented with tabs.
bool has_tab_indentation(const std::shared_ptr<const Source>& source, Diagnostics& diagnostics);

/// What is wrong with the quote of a scalar that begins at a line and byte (both from 0); empty if the quote
/// is closed before the next key. A quote that is closed later, or only by the end of the file, swallows the
/// keys between.
std::string quote_fault(const Source& source, int line, int byte);

}  // namespace flyrock
