#include "report/page/plain_page.h"

#include <fmt/format.h>

#include "report/page/html.h"

namespace flyrock {

namespace {

constexpr const char* page_style =
    "body{max-width:1000px;margin:0 auto;padding:24px;font:16px/1.5 system-ui,\"DejaVu Sans\",sans-serif;"
    "color:#1a1d21}h1{font-size:26px}h2{font-size:20px;border-top:1px solid #d5dae0;padding-top:12px}"
    ".note{color:#5a6370;font-size:14px}table{border-collapse:collapse;margin:8px 0}td,th{border:1px solid "
    "#d5dae0;padding:2px "
    "10px;text-align:left;overflow-wrap:anywhere}th,td:first-child{overflow-wrap:normal}svg{max-width:100%;"
    "height:auto}";

}  // namespace

std::string paragraph(const char* style, const std::string& text) {
  return fmt::format("<p class=\"{}\">{}</p>\n", style, escaped(text));
}

std::string plain_page(const std::string& title, const std::string& body) {
  return fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n<title>{0}</title>\n"
      "<style>{1}</style>\n</head>\n<body>\n<h1>{0}</h1>\n{2}</body>\n</html>\n",
      escaped(title), page_style, body);
}

}  // namespace flyrock
