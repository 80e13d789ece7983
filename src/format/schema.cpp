#include "ritz/format/schema.hpp"

#include <cstdio>

namespace ritz::format::schema {

std::string join(std::string_view parent, std::string_view child) {
  return std::string(parent).append("/").append(child);
}

std::string body_group(std::string_view body) { return join(bodies, link_name(body)); }

std::string body_part(std::string_view body, std::string_view part) { return join(body_group(body), part); }

std::string link_name(std::string_view name) {
  if (name.empty()) return "%";
  std::string link;
  for (const char c : name) {
    if (c == '/') link += "%2F";
    else if (c == '%') link += "%25";
    else if (c == '\0') link += "%00";
    else if (c == '.' && link.empty()) link += "%2E";
    else link += c;
  }
  return link;
}

std::string name_of_link(std::string_view link) {
  if (link == "%") return "";
  std::string name;
  for (std::size_t i = 0; i < link.size(); ++i) {
    const auto code = link.substr(i, 3);
    const char plain = code == "%2F" ? '/' : code == "%25" ? '%' : code == "%2E" ? '.' : code == "%00" ? '\0' : link[i];
    name += plain;
    if (plain != link[i] || code == "%25") i += 2;
  }
  return name;
}

std::string column_name(std::int64_t column) {
  char text[24];
  std::snprintf(text, sizeof text, "%04lld", static_cast<long long>(column) + 1);
  return text;
}

}  // namespace ritz::format::schema
