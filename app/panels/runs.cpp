#include "app/panels/runs.hpp"

#include <algorithm>
#include <map>
#include <set>

#include "app/panels/relevance.hpp"
#include "app/widgets/setting_help.hpp"
#include "core/params/setting.hpp"

namespace pf::app {

const std::array<const char*, phase_count> phase_names{"Sort particles", "Transfer",       "Assemble",   "Linear solve",
                                                       "Line search",    "Move particles", "Diagnostics"};

std::array<double, phase_count> phase_values(const PhaseTimes& t) {
  return {t.sort, t.transfer, t.assemble, t.linear_solve, t.line_search, t.update, t.diagnostics};
}

void Curves::follow(const std::vector<StepReport>& reports) {
  const std::size_t known = time.size();
  const auto same = [&](const StepReport& r) { return r.time == time.back() && r.balance.total() == total.back(); };
  if (known > reports.size() || (known > 0 && !same(reports[known - 1]))) *this = Curves{};
  for (std::size_t k = time.size(); k < reports.size(); ++k) {
    const StepReport& r = reports[k];
    time.push_back(r.time);
    kinetic.push_back(r.balance.kinetic);
    elastic.push_back(r.balance.elastic);
    potential.push_back(r.balance.potential);
    total.push_back(r.balance.total());
    for (int a = 0; a < 3; ++a) {
      const auto i = static_cast<std::size_t>(a);
      momentum[i].push_back(r.balance.momentum[a]);
      angular[i].push_back(r.balance.angular_momentum[a]);
      const bool first = lost_transfer[i].empty();
      lost_transfer[i].push_back((first ? 0 : lost_transfer[i].back()) + r.angular.transfer[a]);
      lost_time[i].push_back((first ? 0 : lost_time[i].back()) + r.angular.time_integration[a]);
      outside[i].push_back((first ? 0 : outside[i].back()) + r.angular.outside[a]);
      stroked[i].push_back((first ? 0 : stroked[i].back()) + r.angular.strokes[a]);
    }
    const auto ms = phase_values(r.ms);
    for (std::size_t i = 0; i < ms.size(); ++i) phase[i].push_back(ms[i]);
    step_ms.push_back(r.ms.total);
    error.push_back(r.error.l2);
  }
}

namespace {

/// "FLIP (increments)" -> "FLIP": labels are short, the panel explains.
std::string without_note(const std::string& text) {
  const std::size_t note = text.find(" (");
  return note == std::string::npos ? text : text.substr(0, note);
}

std::string difference_text(const std::string& pointer, const nlohmann::ordered_json& value) {
  const Setting* setting = find_setting(pointer);
  if (setting == nullptr) return pointer + " " + value.dump();
  if (setting->kind == SettingKind::choice && !pointer.ends_with("/mass") && !pointer.ends_with("_mass"))
    return without_note(value_text(value, *setting));
  std::string label = setting->label;
  if (!label.empty() && label.size() > 1 && !std::isupper(static_cast<unsigned char>(label[1])))
    label.front() = static_cast<char>(std::tolower(static_cast<unsigned char>(label.front())));
  return label + " " + without_note(value_text(value, *setting));
}

bool tells_nothing(const std::string& pointer) {
  return pointer == "/name" || pointer == "/about" || pointer.starts_with("/view") || pointer.starts_with("/events") ||
         pointer.starts_with("/probes");
}

}  // namespace

std::vector<std::string> distinguishing_labels(std::span<const nlohmann::ordered_json* const> scenes) {
  std::vector<nlohmann::ordered_json> flat;
  std::map<std::string, std::set<std::string>> values;
  std::vector<std::string> order;
  for (const auto* scene : scenes) {
    flat.push_back(scene->is_structured() ? scene->flatten() : nlohmann::ordered_json::object());
    for (const auto& [pointer, value] : flat.back().items()) {
      if (tells_nothing(pointer)) continue;
      if (!values.contains(pointer)) order.push_back(pointer);
      values[pointer].insert(value.dump());
    }
  }
  std::vector<std::string> labels(flat.size());
  constexpr int most = 3;
  for (std::size_t s = 0; s < flat.size(); ++s) {
    int shown = 0, left_out = 0;
    for (const std::string& pointer : order) {
      const bool everywhere = std::all_of(flat.begin(), flat.end(), [&](const auto& f) { return f.contains(pointer); });
      if ((everywhere && values[pointer].size() == 1) || !flat[s].contains(pointer)) continue;
      if (++shown > most) {
        ++left_out;
        continue;
      }
      labels[s] += (labels[s].empty() ? "" : ", ") + difference_text(pointer, flat[s][pointer]);
    }
    if (left_out > 0) labels[s] += " and " + std::to_string(left_out) + " more";
    if (labels[s].empty()) labels[s] = "same settings";
  }
  return labels;
}

void thin(std::vector<double>& x, std::vector<double>& y, std::size_t limit) {
  const std::size_t n = x.size();
  if (n <= limit || limit < 8) return;
  const std::size_t buckets = limit / 4;
  std::vector<double> thin_x, thin_y;
  for (std::size_t b = 0; b < buckets; ++b) {
    const std::size_t from = b * n / buckets, to = (b + 1) * n / buckets;
    const auto [low, high] =
        std::minmax_element(y.begin() + static_cast<std::ptrdiff_t>(from), y.begin() + static_cast<std::ptrdiff_t>(to));
    std::array<std::size_t, 4> keep{from, static_cast<std::size_t>(low - y.begin()),
                                    static_cast<std::size_t>(high - y.begin()), to - 1};
    std::sort(keep.begin(), keep.end());
    for (std::size_t i = 0; i < keep.size(); ++i) {
      if (i > 0 && keep[i] == keep[i - 1]) continue;
      thin_x.push_back(x[keep[i]]);
      thin_y.push_back(y[keep[i]]);
    }
  }
  x = std::move(thin_x);
  y = std::move(thin_y);
}

}  // namespace pf::app
