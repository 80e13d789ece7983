// *AMPLITUDE as tables.
#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "ritz/readers/inp_scene.hpp"

namespace ritz::readers {

namespace {

using Points = std::vector<std::pair<double, double>>;

std::string compact(std::string_view text) {
  auto word = upper(text);
  std::erase(word, ' ');
  return word;
}

constexpr int smooth_parts = 50;

Points listed_points(const Sources& sources, const InpLines& amplitude) {
  std::vector<double> numbers;
  for (const auto& line : amplitude.lines) {
    const auto parts = fields(line);
    for (std::size_t i = 0; i < parts.size(); ++i)
      numbers.push_back(inp_number(sources, parts, i, "a time or a value"));
  }
  if (numbers.empty() || numbers.size() % 2 > 0)
    fail(sources, amplitude.keyword.place, "*AMPLITUDE needs pairs of a time and a value");
  Points points;
  for (std::size_t i = 0; i < numbers.size(); i += 2) {
    if (i > 0 && !(numbers[i] > points.back().first))
      fail(sources, amplitude.keyword.place, "the times of *AMPLITUDE must ascend strictly");
    points.emplace_back(numbers[i], numbers[i + 1]);
  }
  return points;
}

// a + (b - a) x^3 (10 - 15 x + 6 x^2) between two points, x from 0 to 1.
Points smoothed(const Points& points) {
  Points fine = {points.front()};
  for (std::size_t i = 1; i < points.size(); ++i) {
    const auto [t0, a] = points[i - 1];
    const auto [t1, b] = points[i];
    for (int k = 1; k < smooth_parts; ++k) {
      const double x = static_cast<double>(k) / smooth_parts;
      fine.emplace_back(t0 + (t1 - t0) * x, a + (b - a) * x * x * x * (10 + x * (6 * x - 15)));
    }
    fine.push_back(points[i]);
  }
  return fine;
}

void refuse_parameters(const Sources& sources, const Keyword& keyword) {
  constexpr std::string_view known[] = {"NAME", "DEFINITION", "TIME", "VALUE", "SHIFTX", "SHIFTY"};
  for (const auto& [name, value] : keyword.parameters)
    if (std::find(std::begin(known), std::end(known), name) == std::end(known))
      fail(sources, keyword.place, "*AMPLITUDE with '" + name + "' is not supported; a table of its values is");
}

double shift(const Sources& sources, const Keyword& keyword, std::string_view parameter) {
  const auto text = keyword.value(parameter).value_or("");
  if (text.empty()) return 0;
  char* end = nullptr;
  const double value = std::strtod(text.c_str(), &end);
  if (*end != '\0' || !std::isfinite(value))
    fail(sources, keyword.place, std::string(parameter) + " of *AMPLITUDE must be a number");
  return value;
}

// In the time of the step.
Points points_of(const Sources& sources, const InpLines& amplitude, const InpAnalysis& analysis) {
  const auto& keyword = amplitude.keyword;
  refuse_parameters(sources, keyword);
  const auto kind = compact(keyword.value("DEFINITION").value_or("TABULAR"));
  if (kind != "TABULAR" && kind != "SMOOTHSTEP")
    fail(sources, keyword.place,
         "*AMPLITUDE with DEFINITION='" + kind + "' is not supported; a table of its values (TABULAR) is");
  const auto time = compact(keyword.value("TIME").value_or("STEPTIME"));
  if (time != "STEPTIME" && time != "TOTALTIME")
    fail(sources, keyword.place, "*AMPLITUDE has TIME=STEP TIME and TIME=TOTAL TIME, not TIME='" + time + "'");
  auto points = listed_points(sources, amplitude);
  if (kind == "SMOOTHSTEP") points = smoothed(points);
  if (time == "TOTALTIME" && !analysis.before)
    fail(sources, keyword.place,
         "TIME=TOTAL TIME counts from the beginning of the deck, and not every step before this one has a time; give "
         "the "
         "amplitude in the time of the step");
  const double later = shift(sources, keyword, "SHIFTX") - (time == "TOTALTIME" ? *analysis.before : 0);
  const double higher = shift(sources, keyword, "SHIFTY");
  for (auto& [t, value] : points) t += later, value += higher;
  return points;
}

void check_absolute(const Sources& sources, const Keyword& keyword, double magnitude, Place place) {
  const auto value = compact(keyword.value("VALUE").value_or("RELATIVE"));
  if (value == "RELATIVE" || (value == "ABSOLUTE" && magnitude == 1)) return;
  if (value != "ABSOLUTE") fail(sources, keyword.place, "*AMPLITUDE has VALUE=RELATIVE and VALUE=ABSOLUTE alone");
  fail(sources, place,
       "the amplitude of this load has VALUE=ABSOLUTE: Abaqus takes its values alone, and CalculiX multiplies them by "
       "the "
       "magnitude here; write the magnitude 1, of which both make the same");
}

}  // namespace

std::optional<scene::Table> inp_factor(const Sources& sources, const InpModel& model, const InpAnalysis& analysis,
                                       const InpActing& acting, double magnitude) {
  const auto& keyword = keyword_of(model, *acting.load);
  const auto name = keyword.value("AMPLITUDE");
  if (!name) {
    if (analysis.ramped == !analysis.motion) return std::nullopt;
    if (analysis.ramped) return scene::Table{{{0, 0}, {analysis.period, 1}}};
    return scene::Table{{{0, 1}}};
  }
  const auto count = model.amplitudes.count(upper(*name));
  if (count != 1)
    fail(sources, keyword.place,
         "the deck has " + std::string(count == 0 ? "no" : "more than one") + " amplitude '" + *name + "'");
  const auto& amplitude = model.amplitudes.find(upper(*name))->second;
  check_absolute(sources, amplitude.keyword, magnitude, acting.load->fields[0].place);
  scene::Table table{points_of(sources, amplitude, analysis)};
  if (!analysis.motion)
    for (auto& [t, value] : table.points) t /= analysis.period;
  return table;
}

}  // namespace ritz::readers
