#include "write.hpp"

#include <array>
#include <charconv>
#include <string_view>

#include "ritz/base/error.hpp"
#include "ritz/base/printable.hpp"
#include "ritz/base/shown.hpp"

namespace ritz::scene {
namespace {

std::string written(double x) {
  std::array<char, 32> digits{};
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), x).ptr;
  std::string text(digits.data(), end);
  return text.find_first_of(".e") == text.npos ? text + ".0" : text;
}

std::string written(const std::string& text) {
  std::string quoted = "\"";
  for (std::size_t at = 0; at < text.size();) {
    const auto length = utf8_length(std::string_view(text).substr(at));
    if (length == 0) throw InputError("the name '" + text + "' is not UTF-8, as a scene file has to be; rename it");
    const auto c = static_cast<unsigned char>(text[at]);
    if (c == '"' || c == '\\') quoted += '\\';
    if (c < 0x20 || c == 0x7f) quoted += formatted("\\u%04x", static_cast<unsigned>(c));
    else quoted += text.substr(at, length);
    at += length;
  }
  return quoted + '"';
}

template <class List>
std::string listed(const List& items) {
  std::string text;
  for (const auto& item : items) text += (text.empty() ? "" : ", ") + written(item);
  return "[" + text + "]";
}

std::string written(const std::pair<double, double>& point) { return listed(std::array{point.first, point.second}); }

std::string written(const Table& table) {
  std::string text = "table = [";
  for (std::size_t i = 0; i < table.points.size(); ++i)
    text += (i == 0 ? "" : i % 6 == 0 ? ",\n  " : ", ") + written(table.points[i]);
  return text + "]\n";
}

struct Analysis {
  std::string operator()(const Static& statics) const {
    return "\n[static]\nsteps = " + std::to_string(statics.steps) + "\n";
  }
  std::string operator()(const Time& time) const {
    auto text = "\n[time]\nstep = " + written(time.step) + "  # s\nend = " + written(time.end) + "  # s\n";
    if (!time.integrator) return text;
    return text + "integrator = " + written(std::string(integrator_names[static_cast<std::size_t>(*time.integrator)])) +
           "\n";
  }
};

std::string written(const Damping& damping) {
  std::string text;
  if (damping.alpha != 0) text += "alpha = " + written(damping.alpha) + "  # 1/s\n";
  if (damping.beta != 0) text += "beta = " + written(damping.beta) + "  # s\n";
  if (!damping.ratio.empty()) text += "ratio = " + listed(damping.ratio) + "\n";
  return text.empty() ? text : "\n[damping]\n" + text;
}

std::string written(const Body& body) {
  return "\n[[body]]\nname = " + written(body.name) + "\n" +
         (body.model.empty() ? "" : "model = " + written(body.model.string()) + "\n") +
         (body.model_body.empty() ? "" : "model_body = " + written(body.model_body) + "\n");
}

/// Whom and where: the keys that loads and probes share.
std::string written(const std::string& body, const Target& target) {
  const auto* const set = std::get_if<std::string>(&target);
  return (body.empty() ? "" : "body = " + written(body) + "\n") +
         (set ? "set = " + written(*set) : "vertex = " + std::to_string(std::get<std::int64_t>(target))) + "\n";
}

struct Kind {
  std::string operator()(const TotalForce& f) const { return "total = " + listed(f.newton) + "  # N\n"; }
  std::string operator()(const EachForce& f) const { return "each = " + listed(f.newton) + "  # N\n"; }
  std::string operator()(const Pressure& p) const { return "pressure = " + written(p.pascal) + "  # Pa\n"; }
  std::string operator()(const Traction& t) const { return "traction = " + listed(t.pascal) + "  # Pa\n"; }
};

}  // namespace

std::string written(const Scene& scene) {
  std::string text;
  if (scene.gravity) text += "\ngravity = " + listed(*scene.gravity) + "  # m/s2\n";
  text += std::visit(Analysis{}, scene.analysis) + written(scene.damping);
  if (scene.shake)
    text += "\n[shake]\ndirection = " + listed(scene.shake->direction) + "\n" + written(scene.shake->table);
  for (const auto& body : scene.bodies) text += written(body);
  for (const auto& load : scene.loads)
    text += "\n[[load]]\n" + written(load.body, load.target) + std::visit(Kind{}, load.kind) +
            (load.table ? written(*load.table) : "");
  for (const auto& probe : scene.probes)
    text += "\n[[probe]]\nname = " + written(probe.name) + "\n" + written(probe.body, probe.target);
  return text;
}

}  // namespace ritz::scene
