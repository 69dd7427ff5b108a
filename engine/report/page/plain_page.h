#pragma once
// Pages that need no script: paragraphs, tables and pictures in one file.

#include <string>

namespace flyrock {

/// A paragraph of a style of the page: "answer" or "note". The text is escaped.
std::string paragraph(const char* style, const std::string& text);

/// A page with a heading, whose body is HTML.
std::string plain_page(const std::string& title, const std::string& body);

}  // namespace flyrock
