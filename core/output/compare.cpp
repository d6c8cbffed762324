#include "core/output/compare.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <unordered_map>

#include "core/files.hpp"
#include "core/output/csv_table.hpp"
#include "core/output/read_particles.hpp"
#include "core/params/problem.hpp"

namespace pf {

namespace {

namespace fs = std::filesystem;
using Numbers = std::vector<double>;

/// Numbers over time; `value[c]` is one component.
struct Track {
  Numbers time;
  std::vector<Numbers> value;
};

/// Adds the difference of two vectors of numbers at a time.
void add(FieldDifference& field, double& squares, double& count, const Numbers& a, const Numbers& b, double time) {
  double difference = 0, size_a = 0, size_b = 0;
  for (std::size_t c = 0; c < a.size(); ++c) {
    const double d = a[c] == b[c] || (std::isnan(a[c]) && std::isnan(b[c])) ? 0 : a[c] - b[c];
    difference += d * d;
    size_a += std::isfinite(a[c]) ? a[c] * a[c] : 0;
    size_b += std::isfinite(b[c]) ? b[c] * b[c] : 0;
  }
  difference = std::isfinite(difference) ? std::sqrt(difference) : std::numeric_limits<double>::infinity();
  field.scale = std::max({field.scale, std::sqrt(size_a), std::sqrt(size_b)});
  squares += difference * difference;
  count += 1;
  if (difference <= field.largest) return;
  field.largest = difference;
  field.time = time;
}

/// The track at `time`, linear between its rows; false beyond its ends. `exact`: it has a row there.
bool at_time(const Track& track, double time, Numbers& value, bool& exact) {
  const double tiny = 1e-9 * std::max(std::abs(time), 1e-300);
  const auto after = std::lower_bound(track.time.begin(), track.time.end(), time - tiny);
  if (after == track.time.end()) return false;
  const auto k = static_cast<std::size_t>(after - track.time.begin());
  exact = track.time[k] <= time + tiny;
  if (!exact && k == 0) return false;
  const double t = exact ? 1 : (time - track.time[k - 1]) / (track.time[k] - track.time[k - 1]);
  value.clear();
  for (const Numbers& column : track.value)
    value.push_back(exact ? column[k] : (1 - t) * column[k - 1] + t * column[k]);
  return true;
}

FieldDifference difference_of(const std::string& file, const std::string& name, const Track& a, const Track& b,
                              bool& interpolated) {
  FieldDifference field{.file = file, .field = name};
  double squares = 0, count = 0;
  Numbers here, there;
  for (std::size_t k = 0; k < a.time.size(); ++k) {
    bool exact = true;
    if (!at_time(b, a.time[k], there, exact)) continue;
    interpolated = interpolated || !exact;
    here.clear();
    for (const Numbers& column : a.value) here.push_back(column[k]);
    add(field, squares, count, here, there, a.time[k]);
  }
  field.rms = count > 0 ? std::sqrt(squares / count) : 0;
  return field;
}

Numbers column(const CsvTable& table, int index) {
  Numbers values;
  for (const auto& row : table.rows) values.push_back(csv_value(row[static_cast<std::size_t>(index)]));
  return values;
}

/// Columns of stats.csv that belong together; every other column stands for itself.
struct Group {
  const char* name;
  std::vector<const char*> columns;
};
const Group groups[] = {{"momentum", {"momentum_x", "momentum_y", "momentum_z"}},
                        {"angular_momentum", {"angular_momentum_x", "angular_momentum_y", "angular_momentum_z"}}};
const std::set<std::string> energies{"kinetic_energy", "elastic_energy", "potential_energy", "total_energy"};
/// How a result was reached and how good it is, not what it is.
const std::set<std::string> effort{
    "dt",         "newton_iterations", "linear_iterations", "residual",      "active_nodes",
    "cfl",        "error_l2",          "error_max",         "error_F_l2",    "error_velocity_l2",
    "error_rate", "explicit_limit",    "implicit_cost",     "explicit_cost", "given_up",
    "converged"};
/// Columns that are not, or not in every row, numbers.
const std::set<std::string> not_numbers{"integrator", "limited_by", "stable_step"};

std::map<std::string, std::vector<std::string>> stats_fields(const CsvTable& table) {
  std::map<std::string, std::vector<std::string>> fields;
  for (const std::string& name : table.header) {
    if (name == "time" || name == "step" || name == "wall_ms" || not_numbers.contains(name)) continue;
    std::string field = name;
    for (const Group& group : groups)
      if (std::find(group.columns.begin(), group.columns.end(), name) != group.columns.end()) field = group.name;
    fields[field].push_back(name);
  }
  return fields;
}

/// Measured from where each component was first: how far something moved, not how far from the origin it lies.
double largest_motion(const Track& track) {
  double largest = 0;
  for (std::size_t k = 0; k < track.time.size(); ++k) {
    double square = 0;
    for (const Numbers& column : track.value) square += (column[k] - column[0]) * (column[k] - column[0]);
    largest = std::max(largest, std::sqrt(square));
  }
  return largest;
}

Track track_of(const CsvTable& table, const std::vector<std::string>& columns) {
  Track track{column(table, table.find("time")), {}};
  for (const std::string& name : columns) track.value.push_back(column(table, table.find(name)));
  return track;
}

CsvTable read_stats(const fs::path& folder) {
  CsvTable table = read_csv(folder / "stats.csv");
  if (table.find("time") < 0 || table.rows.empty())
    throw InputError((folder / "stats.csv").string(), {{"", "no row with a time", "a file that run --out writes", 0}});
  return table;
}

void compare_stats(const CsvTable& a, const CsvTable& b, Comparison& result) {
  bool interpolated = false;
  const auto in_a = stats_fields(a), in_b = stats_fields(b);
  double energy = 0;
  for (const auto& [name, columns] : in_a) {
    if (!in_b.contains(name) || in_b.at(name) != columns) {
      result.notes.push_back("stats.csv: only A has " + name + (in_b.contains(name) ? " with these components" : ""));
      continue;
    }
    FieldDifference field = difference_of("stats.csv", name, track_of(a, columns), track_of(b, columns), interpolated);
    field.judged = !effort.contains(name);
    if (energies.contains(name)) energy = std::max(energy, field.scale);
    result.fields.push_back(std::move(field));
  }
  for (const auto& [name, columns] : in_b)
    if (!in_a.contains(name)) result.notes.push_back("stats.csv: only B has " + name);
  for (FieldDifference& field : result.fields)
    if (energies.contains(field.field)) field.scale = energy;
  const double end_a = csv_value(a.rows.back()[static_cast<std::size_t>(a.find("time"))]);
  const double end_b = csv_value(b.rows.back()[static_cast<std::size_t>(b.find("time"))]);
  result.fields.push_back({.file = "stats.csv",
                           .field = "end of the run",
                           .largest = std::abs(end_a - end_b),
                           .rms = std::abs(end_a - end_b),
                           .scale = std::max(end_a, end_b),
                           .time = std::min(end_a, end_b)});
  if (interpolated) result.notes.push_back("stats.csv: the times differ; B was interpolated at A's");
}

/// Rows of each probe.
std::map<std::string, CsvTable> by_probe(const fs::path& file) {
  const CsvTable all = read_csv(file);
  const int probe = all.find("probe");
  if (probe < 0 || all.find("time") < 0)
    throw InputError(file.string(), {{"", "no column probe or time", "a file that run --out writes", 1}});
  std::map<std::string, CsvTable> tables;
  for (const auto& row : all.rows) {
    CsvTable& table = tables[row[static_cast<std::size_t>(probe)]];
    table.header = all.header;
    table.rows.push_back(row);
  }
  return tables;
}

void compare_probes(const fs::path& a, const fs::path& b, Comparison& result) {
  const bool has_a = fs::exists(a / "probes.csv"), has_b = fs::exists(b / "probes.csv");
  if (!has_a || !has_b) {
    if (has_a != has_b) result.notes.push_back(std::string("only ") + (has_a ? "A" : "B") + " has probes.csv");
    return;
  }
  const auto in_a = by_probe(a / "probes.csv"), in_b = by_probe(b / "probes.csv");
  bool ignored = false;
  for (const auto& [name, table] : in_a) {
    const auto other = in_b.find(name);
    if (other == in_b.end()) {
      result.notes.push_back("probes.csv: only A has " + name);
      continue;
    }
    std::map<std::string, std::vector<std::string>> parts;
    for (const std::string& column : table.header)
      if (column != "time" && column != "probe" && other->second.find(column) >= 0)
        parts[column.size() == 1 ? "position" : column[0] == 'v' ? "velocity" : "stress"].push_back(column);
    for (const auto& [part, columns] : parts) {
      const Track one = track_of(table, columns), two = track_of(other->second, columns);
      const std::string title = std::string(name).append(" ").append(part);
      FieldDifference field = difference_of("probes.csv", title, one, two, ignored);
      if (part == "position") field.scale = std::max(largest_motion(one), largest_motion(two));
      result.fields.push_back(std::move(field));
    }
  }
  for (const auto& [name, table] : in_b)
    if (!in_a.contains(name)) result.notes.push_back("probes.csv: only B has " + name);
}

/// Number -> file of the exported particles.
std::map<std::string, fs::path> exported(const fs::path& folder) {
  std::map<std::string, fs::path> files;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder / "export", error)) {
    const std::string name = entry.path().stem().string(), extension = entry.path().extension().string();
    if (name.starts_with("particles_") && (extension == ".vtp" || extension == ".ply" || extension == ".csv"))
      files.emplace(name.substr(10), entry.path());
  }
  return files;
}

struct Sums {
  double squares = 0, count = 0;
};

/// Largest |x - X|.
double largest_displacement(const ReadParticles& particles) {
  const ReadField *x = particles.find("position"), *X = particles.find("X");
  if (x == nullptr || X == nullptr || x->values.size() != X->values.size()) return 0;
  double largest = 0;
  for (std::size_t k = 0; k + 2 < x->values.size(); k += 3) {
    double square = 0;
    for (std::size_t a = k; a < k + 3; ++a) square += (x->values[a] - X->values[a]) * (x->values[a] - X->values[a]);
    largest = std::max(largest, std::sqrt(square));
  }
  return largest;
}

/// Whether both began at the same place.
bool same_origin(const ReadField* X, std::size_t p, const ReadField* Y, std::size_t q) {
  if (X == nullptr || Y == nullptr) return false;
  for (std::size_t a = 0; a < 3; ++a) {
    const double x = X->values[3 * p + a], y = Y->values[3 * q + a];
    if (!(std::abs(x - y) <= 1e-9 * std::max(std::abs(x), std::abs(y)))) return false;
  }
  return true;
}

/// Row in `b` of each of `a`'s particles, by id; none: it is not there. Where there are not as many, some may have been
/// cut away, or the bodies were sampled otherwise: then a particle is one that began at the same place, too. Files
/// without ids go by their order.
std::vector<std::optional<std::size_t>> partners(const ReadParticles& a, const ReadParticles& b) {
  const ReadField *x = a.find("position"), *ids = a.find("id"), *others = b.find("id");
  std::vector<std::optional<std::size_t>> rows(x->values.size() / x->components);
  const bool as_many = x->values.size() == b.find("position")->values.size();
  std::unordered_map<double, std::size_t> row_of;
  for (std::size_t q = 0; others != nullptr && q < others->values.size(); ++q) row_of.emplace(others->values[q], q);
  for (std::size_t p = 0; p < rows.size(); ++p) {
    if (ids == nullptr || others == nullptr) {
      if ((p + 1) * x->components <= b.find("position")->values.size()) rows[p] = p;
    } else if (const auto found = row_of.find(ids->values[p]); found != row_of.end()) {
      if (as_many || same_origin(a.find("X"), p, b.find("X"), found->second)) rows[p] = found->second;
    }
  }
  return rows;
}

void compare_frame(const ReadParticles& a, const ReadParticles& b,
                   const std::vector<std::optional<std::size_t>>& partner,
                   std::map<std::string, FieldDifference>& fields, std::map<std::string, Sums>& sums) {
  Numbers here, there;
  for (const ReadField& field : a.fields) {
    const ReadField* other = b.find(field.name);
    if (other == nullptr || field.name == "id" || other->components != field.components) continue;
    FieldDifference& total = fields[field.name];
    Sums& sum = sums[field.name];
    const std::size_t n = field.components;
    for (std::size_t p = 0; p * n < field.values.size() && p < partner.size(); ++p) {
      if (!partner[p] || (*partner[p] + 1) * n > other->values.size()) continue;
      const auto first = static_cast<std::ptrdiff_t>(p * n), second = static_cast<std::ptrdiff_t>(*partner[p] * n);
      const auto length = static_cast<std::ptrdiff_t>(n);
      here.assign(field.values.begin() + first, field.values.begin() + first + length);
      there.assign(other->values.begin() + second, other->values.begin() + second + length);
      add(total, sum.squares, sum.count, here, there, a.time);
    }
  }
}

void compare_exports(const fs::path& a, const fs::path& b, Comparison& result) {
  const auto in_a = exported(a), in_b = exported(b);
  std::map<std::string, FieldDifference> fields;
  std::map<std::string, Sums> sums;
  long frames = 0, alone = 0;
  double displacement = 0;
  for (const auto& [number, file] : in_a) {
    if (!in_b.contains(number)) {
      ++alone;
      continue;
    }
    const ReadParticles one = read_particles(file), two = read_particles(in_b.at(number));
    const ReadField *x = one.find("position"), *y = two.find("position");
    const bool same_time = !(std::abs(one.time - two.time) > 1e-9 * std::abs(one.time));
    if (x == nullptr || y == nullptr || !same_time) {
      result.notes.push_back("export: frame " + number + " has another time");
      continue;
    }
    const auto partner = partners(one, two);
    const auto shared = static_cast<std::size_t>(
        std::count_if(partner.begin(), partner.end(), [](const auto& row) { return row.has_value(); }));
    if (shared != partner.size() || y->values.size() != x->values.size()) {
      result.notes.push_back("export: frame " + number + " has another number of particles, or other ones");
      if (shared == 0 || one.find("id") == nullptr || two.find("id") == nullptr) continue;
    }
    ++frames;
    displacement = std::max({displacement, largest_displacement(one), largest_displacement(two)});
    compare_frame(one, two, partner, fields, sums);
  }
  for (const auto& [number, file] : in_b) alone += in_a.contains(number) ? 0 : 1;
  for (auto& [name, field] : fields) {
    field.file = "export";
    field.field = name;
    if (name == "position" && displacement > 0) field.scale = displacement;
    field.rms = sums[name].count > 0 ? std::sqrt(sums[name].squares / sums[name].count) : 0;
    result.fields.push_back(field);
  }
  if (frames > 0) result.notes.push_back("export: " + std::to_string(frames) + " frames, particle by particle");
  if (alone > 0 && frames > 0)
    result.notes.push_back("export: " + std::to_string(alone) + " frames in one of them only");
  if (frames == 0 && in_a.empty() != in_b.empty())
    result.notes.push_back(std::string("only ") + (in_a.empty() ? "B" : "A") + " has exported particles");
}

/// What the scene itself says of the size of things; 0 where there is no summary.json to say it.
struct Sizes {
  double stiffness = 0, mass = 0, spacing = 0;
};

Sizes sizes_of(const fs::path& folder) {
  Sizes sizes;
  if (!fs::exists(folder / "summary.json")) return sizes;
  try {
    const auto summary = nlohmann::json::parse(read_file(folder / "summary.json"));
    sizes.mass = summary.at("mass");
    sizes.spacing = summary.at("scene").at("grid").at("spacing");
    for (const auto& [name, material] : summary.at("scene").at("materials").items())
      sizes.stiffness = std::max(sizes.stiffness, material.value("young", 0.0));
  } catch (const nlohmann::json::exception&) {
    return {};  // somebody else's file, or an older one
  }
  return sizes;
}

/// What should be zero is rounding in both runs: no field is judged on a finer scale than this share of what the scene
/// can hold.
constexpr double rounding = 1e-9;

void allow_for_rounding(const Sizes& sizes, Comparison& result) {
  double energy = 0;
  for (const FieldDifference& field : result.fields)
    if (field.field == "kinetic_energy") energy = field.scale;
  const double momentum = rounding * std::sqrt(2 * sizes.mass * energy), stress = rounding * sizes.stiffness;
  for (FieldDifference& field : result.fields) {
    const std::string& name = field.field;
    const bool is_stress = name.ends_with("stress") || name == "pressure" || name == "von_mises";
    if (is_stress) field.scale = std::max(field.scale, stress);
    if (name == "energy_density") field.scale = std::max(field.scale, rounding * stress);
    if (name == "momentum") field.scale = std::max(field.scale, momentum);
    if (name == "angular_momentum") field.scale = std::max(field.scale, momentum * sizes.spacing);
  }
}

}  // namespace

double FieldDifference::relative() const {
  if (largest == 0) return 0;
  return scale > 0 ? largest / scale : std::numeric_limits<double>::infinity();
}

double Comparison::worst() const {
  double worst = 0;
  for (const FieldDifference& field : fields)
    if (field.judged) worst = std::max(worst, field.relative());
  return worst;
}

Comparison compare_runs(const fs::path& a, const fs::path& b) {
  Comparison result;
  compare_stats(read_stats(a), read_stats(b), result);
  compare_probes(a, b, result);
  compare_exports(a, b, result);
  allow_for_rounding(sizes_of(a), result);
  return result;
}

}  // namespace pf
