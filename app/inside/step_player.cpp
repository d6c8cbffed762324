#include "app/inside/step_player.hpp"

#include <algorithm>
#include <cmath>
#include <unordered_map>
#include <utility>

namespace pf::app {

namespace {

double largest_length(const StepRecord& r, const std::vector<double>& values, const std::vector<bool>& counted) {
  double most = 0;
  for (std::size_t i = 0; i < r.nodes(); ++i)
    if (counted[i]) most = std::max(most, entry(values, i, r.dimension).norm());
  return most;
}

/// The largest of 1, 2, 5, 10, ... that is not above `times`.
double round_down(double times) {
  if (!(times > 1)) return 1;
  const double power = std::pow(10.0, std::floor(std::log10(times)));
  return power * (times >= 5 * power ? 5 : times >= 2 * power ? 2 : 1);
}

/// So that the grid bends by about half a cell.
double useful_magnification(const StepRecord& r, const std::vector<bool>& counted) {
  const double end = largest_length(r, r.node_displacement, counted);
  double most = end;
  for (const IterateRecord& it : r.iterates) most = std::max(most, largest_length(r, it.u, counted));
  if (!(end > 0)) return 1;
  return round_down(std::min(0.5 * r.spacing / end, 1.5 * r.spacing / most));
}

}  // namespace

Vec3 entry(const std::vector<double>& values, std::size_t k, int dimension) {
  Vec3 v = Vec3::Zero();
  const auto d = static_cast<std::size_t>(dimension);
  for (std::size_t a = 0; a < d && k * d + a < values.size(); ++a) v[static_cast<int>(a)] = values[k * d + a];
  return v;
}

StepPlayer::StepPlayer(ApartStep step, Scene scene) : step_(std::move(step)), scene_(std::move(scene)) {
  make_phases();
  const double heaviest =
      record().nodes() > 0 ? *std::max_element(record().node_mass.begin(), record().node_mass.end()) : 0;
  for (const double m : record().node_mass) drawn_.push_back(m > 0.01 * heaviest);
  magnification_ = useful_magnification(record(), drawn_);
}

void StepPlayer::make_phases() {
  const StepRecord& r = record();
  phases_.push_back({PhaseKind::give, 0, 4, "Particles give mass and velocity to the nodes", "Particles to grid"});
  if (r.iterates.empty()) {
    phases_.push_back({PhaseKind::kick, 0, 3, "Forces move the nodes", "Forces"});
  } else {
    phases_.push_back({PhaseKind::guess, 0, 2.5, "The grid goes to its first guess", "First guess"});
    for (std::size_t k = 1; k < r.iterates.size(); ++k) {
      const std::string number = std::to_string(k);
      phases_.push_back({PhaseKind::iterate, k, k < 4 ? 2.2 : 1.2, "Newton iteration " + number + " bends the grid",
                         "Newton " + number});
    }
    if (r.iterates.back().u != r.node_displacement)
      phases_.push_back({PhaseKind::extrapolate, r.iterates.size() - 1, 2, "The stage is carried on to the step's end",
                         "Step's end"});
  }
  phases_.push_back({PhaseKind::ride, 0, 3.5, "Particles ride on the grid", "Grid to particles"});
  phases_.push_back({PhaseKind::snap, 0, 2, "The grid snaps back", "Fresh grid"});
}

std::size_t StepPlayer::phase_index() const {
  return std::min(static_cast<std::size_t>(position_), phases_.size() - 1);
}

double StepPlayer::motion() const {
  const double f = position_ - static_cast<double>(phase_index());
  const double s = std::clamp((f - 0.08) / 0.72, 0.0, 1.0);  // a moment of rest at both ends, to read
  return s * s * (3 - 2 * s);
}

void StepPlayer::seek(double position) {
  position_ = std::clamp(position, 0.0, static_cast<double>(phases_.size()));
}

void StepPlayer::next() {
  seek(std::floor(position_ + 1e-9) + 1);
}

void StepPlayer::previous() {
  const double begin = std::floor(position_);
  seek(position_ - begin > 0.05 ? begin : begin - 1);
}

void StepPlayer::advance(double seconds) {
  if (!playing) return;
  seek(position_ + speed * seconds / phase().seconds);
  playing = !at_end();
}

std::pair<const std::vector<double>*, const std::vector<double>*> StepPlayer::displacements() const {
  const StepRecord& r = record();
  const Phase& p = phase();
  switch (p.kind) {
    case PhaseKind::give:
      return {nullptr, nullptr};
    case PhaseKind::guess:
      return {nullptr, &r.iterates[0].u};
    case PhaseKind::iterate:
      return {&r.iterates[p.iterate - 1].u, &r.iterates[p.iterate].u};
    case PhaseKind::kick:
      return {nullptr, &r.node_displacement};
    case PhaseKind::extrapolate:
      return {&r.iterates[p.iterate].u, &r.node_displacement};
    case PhaseKind::ride:
      return {&r.node_displacement, &r.node_displacement};
    default:
      return {&r.node_displacement, nullptr};
  }
}

Vec3 StepPlayer::node_displacement(std::size_t node) const {
  const auto [from, to] = displacements();
  const double f = motion();
  const Vec3 a = from ? entry(*from, node, record().dimension) : Vec3::Zero();
  const Vec3 b = to ? entry(*to, node, record().dimension) : Vec3::Zero();
  return (1 - f) * a + f * b;
}

NodeIndex StepPlayer::node(std::size_t node) const {
  const auto d = static_cast<std::size_t>(record().dimension);
  NodeIndex index{};
  std::copy_n(record().node_index.begin() + static_cast<std::ptrdiff_t>(node * d), d, index.begin());
  return index;
}

std::optional<std::size_t> StepPlayer::find_node(const NodeIndex& index) const {
  for (std::size_t i = 0; i < record().nodes(); ++i)
    if (node(i) == index) return i;
  return std::nullopt;
}

std::optional<std::size_t> StepPlayer::find_particle(std::uint32_t id) const {
  const auto found = std::find(record().id.begin(), record().id.end(), id);
  if (found == record().id.end()) return std::nullopt;
  return static_cast<std::size_t>(found - record().id.begin());
}

std::uint32_t StepPlayer::remarkable_particle() const {
  const StepRecord& r = record();
  Vec3 at = Vec3::Zero();
  if (!r.iterates.empty() && r.iterates[0].worst >= 0) {
    const NodeIndex i = node(static_cast<std::size_t>(r.iterates[0].worst));
    at = r.spacing * Vec3(i[0], i[1], i[2]);
  } else {
    for (std::size_t p = 0; p < r.id.size(); ++p) at += entry(r.before.x, p, r.dimension);
    at /= static_cast<double>(std::max<std::size_t>(1, r.id.size()));
  }
  std::size_t best = 0;
  double nearest = INFINITY;
  for (std::size_t p = 0; p < r.id.size(); ++p) {
    const double d = (entry(r.before.x, p, r.dimension) - at).squaredNorm();
    if (!(d < nearest)) continue;
    nearest = d;
    best = p;
  }
  return r.id.empty() ? 0 : r.id[best];
}

void StepPlayer::fill_grid(Snapshot& s) const {
  const StepRecord& r = record();
  const PhaseKind kind = phase().kind;
  const double f = motion(), arrows = kind == PhaseKind::give ? f : kind == PhaseKind::snap ? 1 - f : 1;
  const std::vector<double>& v =
      kind == PhaseKind::ride || kind == PhaseKind::snap ? r.node_velocity_end : r.node_velocity;
  const auto d = static_cast<std::size_t>(r.dimension);
  s.node_index.clear();
  s.node_mass.clear();
  s.node_velocity.clear();
  s.node_displacement.clear();
  for (std::size_t i = 0; i < r.nodes(); ++i) {
    if (!drawn_[i]) continue;
    const Vec3 u = magnification_ * node_displacement(i);
    s.node_mass.push_back(r.node_mass[i]);
    for (std::size_t a = 0; a < d; ++a) {
      s.node_index.push_back(r.node_index[i * d + a]);
      s.node_velocity.push_back(arrows * v[i * d + a]);
      s.node_displacement.push_back(u[static_cast<int>(a)]);
    }
  }
  s.nodes = s.node_mass.size();
  s.node_state.assign(s.nodes, 0);
}

std::shared_ptr<const Snapshot> StepPlayer::snapshot() {
  if (shown_ && shown_position_ == position_ && shown_magnification_ == magnification_) return shown_;
  const StepRecord& r = record();
  const PhaseKind kind = phase().kind;
  const double f = motion();
  // Particles: how far they have gone, and how much larger than life that is drawn.
  const double gone = kind == PhaseKind::ride ? f : kind == PhaseKind::snap ? 1 : 0;
  const double times = kind == PhaseKind::snap ? magnification_ + f * (1 - magnification_) : magnification_;
  auto s = std::make_shared<Snapshot>(*step_.before);
  // Every position is a picture of its own: the renderer tells pictures apart by their time.
  s->report.time = r.time + r.dt * position_ / static_cast<double>(phases_.size());
  for (std::size_t k = 0; k < s->x.size() && k < r.after.x.size(); ++k)
    s->x[k] = r.before.x[k] + gone * times * (r.after.x[k] - r.before.x[k]);
  for (std::size_t k = 0; k < s->F.size() && k < r.after.F.size(); ++k)
    s->F[k] = static_cast<float>(r.before.F[k] + gone * times * (r.after.F[k] - r.before.F[k]));
  fill_grid(*s);
  if (kind == PhaseKind::snap && f > 0.5) {
    // The new colours, particle by particle: the new state has another order.
    std::unordered_map<std::uint32_t, std::size_t> place;
    for (std::size_t p = 0; p < step_.after->id.size(); ++p) place[step_.after->id[p]] = p;
    for (std::size_t field = 0; field < s->field.size(); ++field) {
      const std::vector<float>& fresh = step_.after->field[field];
      for (std::size_t p = 0; p < s->field[field].size() && fresh.size() == s->id.size(); ++p)
        s->field[field][p] = fresh[place[s->id[p]]];
    }
  }
  shown_ = std::move(s);
  shown_position_ = position_;
  shown_magnification_ = magnification_;
  return shown_;
}

}  // namespace pf::app
